// Every snapshot of a scene is kept in a folder of its own.
#include "process/scene/snapshot_folder.h"

#include <gtest/gtest.h>

#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

std::string snapshot_called(const std::string& name, const std::string& more = {}) {
  return "\n[[snapshot]]\nname = \"" + name + "\"\n" + more;
}

/// The message about a scene with these tables besides; empty: none.
std::string complaint_about(const std::string& tables) {
  const SceneFolder folder;
  try {
    read_scene(folder.write(faultless_scene() + tables));
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

TEST(SnapshotFolder, IsPlainForPlainNamesAndAnotherForEveryNameWithOtherLetters) {
  EXPECT_EQ(snapshot_folder("half filled"), "half_filled");
  EXPECT_NE(snapshot_folder("\xC3\xA9"), snapshot_folder("\xC3\xBC"));
  EXPECT_NE(snapshot_folder("\xE5\xA1\xAB\xE5\x89\x8D"), snapshot_folder("\xE5\xA1\xAB\xE5\x90\x8E"));
}

TEST(SnapshotFolder, OfTwoNamesThatDifferInOtherLettersIsAccepted) {
  EXPECT_EQ(complaint_about(snapshot_called("\xC3\xA9") + snapshot_called("\xC3\xBC")), "");
}

TEST(SnapshotFolder, OfTwoSnapshotsIsRefusedWithBothNames) {
  const std::string every = "every = \"10 ms\"\n";
  for (const std::string& tables : {snapshot_called("a b") + snapshot_called("a.b"),
                                    snapshot_called("a b", every) + snapshot_called("a.b", every),
                                    snapshot_called("a b", every) + snapshot_called("a.b 0001"),
                                    snapshot_called("a.b 0001") + snapshot_called("a b", every)}) {
    const std::string message = complaint_about(tables);
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    for (const char* part :
         {"snapshot.name: found \"a", "an earlier snapshot, \"a", "the same folder", "a b", "a.b"})
      EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
  }
  EXPECT_EQ(complaint_about(snapshot_called("a b", every) + snapshot_called("a.b")), "")
      << "a_b_0001 and a_b";
}

}  // namespace
}  // namespace diefill::process
