// Scene texts that are no TOML, in another encoding, too deep or too large: named in one line, never
// followed.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "process/input/shown_value.h"
#include "process/machine/motions/table_motion.h"
#include "process/scene/scene.h"
#include "process/scene/variants.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

std::string complaint(const std::string& text) {
  const SceneFolder folder;
  try {
    read_scene(folder.write(text));
  } catch (const SceneError& error) {
    const std::string message = error.what();
    return message.substr(message.find("scene.toml"));
  }
  return "";
}

void expect_begins(const std::string& message, const std::string& beginning) {
  EXPECT_EQ(message.substr(0, beginning.size()), beginning) << message;
}

/// The text with so many zeros after every letter.
std::string widened(const std::string& text, std::size_t zeros) {
  std::string wide;
  for (const char letter : text) wide += letter + std::string(zeros, '\0');
  return wide;
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int k = 0; k < times; ++k) all += text;
  return all;
}

TEST(SceneText, OtherEncodingsAreNamed) {
  const std::string scene = faultless_scene();
  const std::string wide = "scene.toml:1: found UTF-16 text, expected UTF-8; save the scene as UTF-8 text";
  expect_begins(complaint("\xFF\xFE" + widened(scene, 1)), wide);
  expect_begins(complaint(widened(scene, 1)), wide);
  expect_begins(complaint(std::string("\xFE\xFF\0t\0i", 6)), wide);
  expect_begins(complaint(std::string("\xFF\xFE\0\0", 4) + widened(scene, 3)),
                "scene.toml:1: found UTF-32 text");
  expect_begins(complaint(widened(scene, 3)), "scene.toml:1: found UTF-32 text");
  expect_begins(complaint("title = \"a\"\nseed = 1\n# caf\xE9\n"),
                "scene.toml:3:6: found the byte 0xE9, which is not UTF-8; save the scene as UTF-8 text");
  expect_begins(complaint(std::string("title = \"a\0b\"", 13)),
                "scene.toml:1:11: found the byte 0, which does not");
}

TEST(SceneText, NestingIsSeenBeforeItIsFollowed) {
  expect_begins(complaint("a" + repeated(".a", 50000) + " = 1"),
                "scene.toml:1: found a key of more than 16 parts joined by dots");
  expect_begins(complaint("[a" + repeated(".a", 50000) + "]"),
                "scene.toml:1: found a key of more than 16 parts");
  expect_begins(complaint("seed = 1\n# ...................\nx = " + repeated("[", 50000)),
                "scene.toml:3: found brackets nested more than 16 deep");
  expect_begins(complaint("x = " + repeated("{a=", 50000)), "scene.toml:1: found brackets nested");
  expect_begins(complaint("x = \"[[[[[[[[[[[[[[[[[[[[[ a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a\""),
                "scene.toml:1:1: powder: found nothing");
  expect_begins(
      complaint("x = '''\n[[[[[[[[[[[[[[[[[[[[[\n'''\ny = \"\"\"\\\"\"\"[[[[[[[[[[[[[[[[[[[[\"\"\""),
      "scene.toml:1:1: powder: found nothing");
}

TEST(SceneText, AdviceIsNeverMadeOfTheFault) {
  expect_begins(complaint("n = \"me = \"s1\"\""), "scene.toml:1:");
  for (const std::string line : {"n = me = \"s1\"", "n = me = s1", "a b = x", "= x", "velocity = 0.2 m = 3",
                                 "[[tool", "[to ol", "x = .6a", "n = a\"b\"", "n = a'b", "n = a]b"}) {
    const std::string message = complaint(line);
    const std::size_t example = message.find("such as ");
    if (example == std::string::npos) continue;
    const std::string advised = message.substr(example + 8);
    const std::string parsed =
        advised.find('=') == std::string::npos && advised[0] != '[' ? "x = " + advised : advised;
    EXPECT_NO_THROW(value_at(parsed, "x", "none")) << message;
  }
  EXPECT_NE(complaint("[[tool\n").find("such as [[tool]]"), std::string::npos) << complaint("[[tool\n");
  EXPECT_NE(complaint("seed = 9223372036854775808").find("and 9223372036854775807"), std::string::npos)
      << complaint("seed = 9223372036854775808");
}

TEST(SceneText, QuotesAreShortAndShowControlCharactersWrittenOut) {
  EXPECT_EQ(one_line("a\nb\x1B[31m\t\x7F"), "a\\nb\\u001B[31m\\t\\u007F");
  EXPECT_EQ(one_line(std::string("a\0b", 3)), "a\\u0000b");
  EXPECT_EQ(one_line("a\xE9z"), "a\\xE9z");
  EXPECT_EQ(one_line("a\u202Eb\u2028c\u009Bd"), "a\\u202Eb\\u2028c\\u009Bd");
  EXPECT_EQ(one_line("\u00e9\u4e2d\U0001F600"), "\u00e9\u4e2d\U0001F600");
  EXPECT_EQ(one_line(std::string(100, 'x'), 10), std::string(10, 'x') + "...");
  EXPECT_EQ(one_line("aaaa\u4e2d", 5), "aaaa...");
  EXPECT_EQ(with_short_words("found no aaaabbbb", 8), "found no aaaabbbb");
  EXPECT_EQ(with_short_words("no aaaaabbbbb file", 8), "no aaa...bb file");
  EXPECT_EQ(with_short_words("\u4e2d\u4e2d\u4e2d\u4e2d", 9), "\u4e2d...\u4e2d");
  for (const std::string fault : {"title = \"a\\u0000b\"", "title = \"a\\nb\"", "title = \"\\u001b[31m\""})
    expect_begins(complaint(fault + faultless_scene().substr(faultless_scene().find('\n'))),
                  "scene.toml:1:9: title: found \"");
  const std::string message = complaint("x = " + std::string(200000, 'y'));
  EXPECT_LT(message.size(), 600U);
  EXPECT_LT(complaint(std::string(100000, 'k') + " = 1\n" + faultless_scene()).size(), 700U);
}

TEST(SceneText, NamesLongerThanFileNamesAreRefused) {
  const std::string message = complaint(
      support::exchanged(faultless_scene(), "name = \"die\"", "name = \"" + std::string(300, 'n') + "\""));
  EXPECT_NE(message.find("tool.name: found \"nnn"), std::string::npos) << message;
  EXPECT_NE(message.find("the name has 300 bytes, allowed: up to 100"), std::string::npos) << message;
}

TEST(SceneText, OnlyRegularFilesAreRead) {
  const SceneFolder folder;
  const auto pipe = folder.path() / "pipe.toml";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const auto sparse = folder.path() / "sparse.toml";
  std::ofstream(sparse).put('#');
  std::filesystem::resize_file(sparse, 10ULL << 30U);
  for (const auto& file : {pipe, std::filesystem::path("/dev/zero"), sparse}) {
    EXPECT_THROW(read_scene(file), SceneError) << file;
    EXPECT_THROW(read_motion_table(file, "scene.toml:1:1: step.file"), SceneError) << file;
  }
  EXPECT_THROW(read_motion_table(folder.path(), "scene.toml:1:1: step.file"), SceneError);
}

TEST(SceneText, SpreadsheetsMarkOfByteOrderIsNoneOfATable) {
  const SceneFolder folder;
  std::ofstream(folder.path() / "motion.csv") << "\xEF\xBB\xBFtime s,x mm\r\n0,0\r\n1,5\r\n";
  EXPECT_EQ(read_motion_table(folder.path() / "motion.csv", "here").time.size(), 2U);
}

TEST(SceneText, LimitsAreMetByWhatIsWrittenWithTheLastDigitThatCounts) {
  const auto with_diameter = [](const std::string& diameter) {
    std::string text = support::exchanged(faultless_scene(), "Distaloy AE", "ASC100.29 A2");
    return support::exchanged(text, "1.88 mm", diameter);
  };
  EXPECT_EQ(complaint(with_diameter("6 mm")), "");
  const std::string message = complaint(with_diameter("6.0000001 mm"));
  EXPECT_NE(message.find("the grains measure 6.0000001 mm, allowed: 0.03 mm to 6 mm"), std::string::npos)
      << message;
}

}  // namespace
}  // namespace diefill::process
