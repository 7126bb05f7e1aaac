// What a user hears about a wrong scene: place, key, what was found and the remedy, on one line.
#include <gtest/gtest.h>

#include <set>

#include "process/scene/scene.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scenes.h"

namespace diefill::process {
namespace {

std::string complaint(const std::filesystem::path& file) {
  try {
    read_scene(file);
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

class WrongScenes : public testing::TestWithParam<WrongScene> {};

TEST_P(WrongScenes, AreExplainedWithPlaceFindingAndRemedy) {
  const SceneFolder folder;
  const std::string message = complaint(folder.write(GetParam().text));
  ASSERT_FALSE(message.empty()) << "the scene was accepted";
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  for (const std::string& part : GetParam().expected) {
    EXPECT_NE(message.find(part), std::string::npos) << "missing: " << part << "\nin:      " << message;
  }
}

INSTANTIATE_TEST_SUITE_P(Scene, WrongScenes, testing::ValuesIn(wrong_scenes()),
                         [](const auto& instance) { return instance.param.name; });

TEST(WrongSceneList, IsLongAndEveryCaseHasItsOwnName) {
  std::set<std::string> names;
  for (const WrongScene& scene : wrong_scenes()) names.insert(scene.name);
  EXPECT_EQ(names.size(), wrong_scenes().size());
  EXPECT_GE(names.size(), 55U);
}

TEST(SceneErrors, FaultlessSceneIsAccepted) {
  const SceneFolder folder;
  EXPECT_EQ(complaint(folder.write(faultless_scene())), "");
}

TEST(SceneErrors, MissingFileIsNamedWithItsFullPath) {
  const SceneFolder folder;
  const std::string message = complaint(folder.path() / "parts" / ".." / "none.toml");
  EXPECT_NE(message.find("found no such scene file"), std::string::npos) << message;
  EXPECT_NE(message.find((folder.path() / "none.toml").string()), std::string::npos) << message;
  EXPECT_NE(message.find("give a scene"), std::string::npos) << message;
}

TEST(SceneErrors, FolderIsNoScene) {
  const SceneFolder folder;
  const std::string message = complaint(folder.path());
  EXPECT_NE(message.find("found a folder, expected a scene file"), std::string::npos) << message;
}

TEST(SceneErrors, BytesThatAreNoTextAreRefused) {
  const SceneFolder folder;
  std::string bytes = "solid";
  for (int i = 0; i < 4096; ++i) bytes += static_cast<char>((i * 7919) % 256);
  const std::string message = complaint(folder.write(bytes));
  EXPECT_NE(message.find("scene.toml:1:6: found the byte 0, which does not occur in a text file"),
            std::string::npos)
      << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(SceneErrors, HugeFileIsRefusedUnread) {
  const SceneFolder folder;
  const std::string message = complaint(folder.write(std::string(5U << 20U, '#')));
  EXPECT_NE(message.find("more than 4 MiB"), std::string::npos) << message;
}

TEST(SceneErrors, EmptyFileAsksForThePowder) {
  const SceneFolder folder;
  const std::string message = complaint(folder.write(""));
  EXPECT_NE(message.find("scene.toml:1:1: powder: found nothing, a value is required"), std::string::npos)
      << message;
}

TEST(SceneErrors, ByteOrderMarkAndWindowsLineEndsAreAccepted) {
  const SceneFolder folder;
  std::string text = "\xEF\xBB\xBF";
  for (const char letter : faultless_scene())
    text += letter == '\n' ? std::string("\r\n") : std::string(1, letter);
  EXPECT_EQ(complaint(folder.write(text)), "");
}

TEST(SceneErrors, LongAndOddValuesStayOnOneShortLine) {
  const SceneFolder folder;
  std::string text = faultless_scene();
  text.replace(text.find("\"1.88 mm\""), 9, "\"" + std::string(500, 'x') + "\\n\\t\"");
  const std::string message = complaint(folder.write(text));
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_NE(message.find("xxx...\""), std::string::npos) << message;
  EXPECT_LT(message.size(), 400U);
}

// Every prefix of a scene is read or refused with a SceneError, never with another exception or a crash.
TEST(SceneErrors, EveryPrefixOfASceneIsHandled) {
  const SceneFolder folder;
  const std::string text = faultless_scene();
  const std::filesystem::path file = folder.path() / "scene.toml";
  int refused = 0;
  for (std::size_t length = 0; length < text.size(); ++length) {
    try {
      parse_scene(text.substr(0, length), file);
    } catch (const SceneError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, static_cast<int>(text.find("direction")));
}

// The same for single characters replaced by ones that matter to the syntax.
TEST(SceneErrors, EveryDamagedCharacterIsHandled) {
  const SceneFolder folder;
  const std::string text = faultless_scene();
  const std::filesystem::path file = folder.path() / "scene.toml";
  int refused = 0;
  for (std::size_t place = 0; place < text.size(); ++place) {
    for (const char letter : std::string("\"[]{}=.,-0\n#\\\xFF")) {
      std::string damaged = text;
      damaged[place] = letter;
      try {
        parse_scene(damaged, file);
      } catch (const SceneError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace diefill::process
