// Which changes of a scene leave it the same computation.
#include <gtest/gtest.h>

#include "process/scene/identity.h"
#include "tests/process/wrong_scene.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

const std::vector<std::string> kTools = {"hash of the die", "hash of the shoe"};

std::uint64_t identity_of(const std::string& text) {
  return scene_identity(text, "scene.toml", kTools);
}

std::uint64_t identity_with(const std::string& old, const std::string& replacement) {
  return identity_of(support::exchanged(faultless_scene(), old, replacement));
}

TEST(SceneIdentity, IsTheSameWhateverHasNoPartInTheComputation) {
  const std::uint64_t before = identity_of(faultless_scene());
  EXPECT_EQ(identity_with("Narrow ring, one passage", "Another title"), before);
  EXPECT_EQ(identity_with("max_time = \"5 s\"", "max_time = \"50 s\""), before);
  EXPECT_EQ(identity_with("max_time = \"5 s\"\n", ""), before);
  EXPECT_EQ(identity_with("max_time = \"5 s\"", "checkpoint_interval = \"5 s\""), before);
  EXPECT_EQ(identity_of("# A comment\n" + faultless_scene() + "# and another\n"), before);
  EXPECT_EQ(identity_of(faultless_scene() + "\n[[variant]]\nname = \"slow\"\n"), before);
  EXPECT_EQ(identity_with("kind = \"passage\"\ntool = \"shoe\"", "tool = \"shoe\"\nkind = \"passage\""),
            before);
}

TEST(SceneIdentity, IsAnotherForWhateverActs) {
  const std::uint64_t before = identity_of(faultless_scene());
  for (const auto& [old, other] : {std::pair{"seed = 1", "seed = 2"},
                                   {"1.88 mm", "0.94 mm"},
                                   {"velocity = \"0.2 m/s\"", "velocity = \"0.3 m/s\""},
                                   {"max_time = \"5 s\"", "time_step_fraction = 0.1"},
                                   {"fill_plane = \"0 mm\"", "fill_plane = \"1 mm\""}})
    EXPECT_NE(identity_with(old, other), before) << other;
  EXPECT_NE(scene_identity(faultless_scene(), "scene.toml", {"hash of another die", kTools[1]}), before);
}

TEST(SceneIdentity, CountsTheContentsOfTheTablesThatStepsFollow) {
  const support::TemporaryFolder folder;
  const auto file = folder.path() / "scene.toml";
  const std::string text = faultless_scene() + "\n[[step]]\nkind = \"table\"\nfile = \"motion.csv\"\n";
  folder.write("motion.csv", "0,0\n1,1\n");
  const std::uint64_t before = scene_identity(text, file, kTools);
  EXPECT_EQ(scene_identity(text, file, kTools), before);
  folder.write("motion.csv", "0,0\n1,2\n");
  EXPECT_NE(scene_identity(text, file, kTools), before);
}

TEST(SceneIdentity, InputFilesAreNamedWithAHashOfTheirContents) {
  const support::TemporaryFolder folder;
  const auto file = folder.path() / "scene.toml";
  const std::string text = faultless_scene() + "\n[[step]]\nkind = \"table\"\nfile = \"motion.csv\"\n";
  EXPECT_TRUE(input_files(faultless_scene(), file).empty());
  folder.write("motion.csv", "0,0\n1,1\n");
  const auto before = input_files(text, file);
  ASSERT_EQ(before.size(), 1U);
  EXPECT_EQ(before.front().name, "motion.csv");
  EXPECT_EQ(input_files("# a comment\n" + text, file).front().hash, before.front().hash);
  EXPECT_EQ(hash_of_input(before, "motion.csv"), before.front().hash);
  EXPECT_THROW(hash_of_input(before, "other.csv"), std::logic_error);
  folder.write("motion.csv", "0,0\n1,2\n");
  EXPECT_NE(input_files(text, file).front().hash, before.front().hash);
}

}  // namespace
}  // namespace diefill::process
