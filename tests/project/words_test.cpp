// Words: sources and documents use those of the field, and those of a reader who is not at home in English.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "tests/project/source_files.h"

namespace diefill::project {
namespace {

/// A word or phrase that is not to be used, and what to write.
struct Banned {
  std::string word;  ///< regular expression, matched as whole words whatever the case
  std::string instead;
  std::vector<std::string> allowed = {};  ///< beginnings of the paths of files that may use it
};

const std::vector<Banned>& banned_words() {
  static const std::vector<Banned> all = {
      {"air_?draught|draughts?", "air flow"},
      {"at ease", "at rest"},
      {"carried_?powder", "co-moving powder"},
      {"cube_of_space", "cell index"},
      {"dice", "random"},
      {"foreseen|foresees?", "predicted, expected"},
      {"in[_ ]words", "as text, description", {"CHANGELOG.md"}},
      {"leeway", "remaining skin"},
      {"lie_apart", "distinct"},
      {"look_?ahead", "prefetch"},
      {"looks? after|looked after", "monitor, manage"},
      {"physics reference", "the source and its equation, or engine/OPEN_POINTS.md"},
      {"slip of the pen", "did you mean ...?"},
      {"slots_?in_?space", "spatial cache"},
      {"to and fro", "oscillate, back and forth"},
  };
  return all;
}

/// Uses of banned words in a text, a line each.
std::vector<std::string> uses(const std::string& file, const std::string& as_written) {
  // Phrases go on behind the mark of the next line's comment.
  const std::string text = std::regex_replace(as_written, std::regex("\\n[ \\t]*(///?|#)?[ \\t]*"), " ");
  std::vector<std::string> found;
  for (const Banned& banned : banned_words()) {
    if (std::any_of(banned.allowed.begin(), banned.allowed.end(),
                    [&](const auto& start) { return file.starts_with(start); }))
      continue;
    const std::regex whole("(^|[^A-Za-z])(" + banned.word + ")($|[^A-Za-z])", std::regex::icase);
    for (std::sregex_iterator match(text.begin(), text.end(), whole), end; match != end; ++match)
      found.push_back(file + ": '" + (*match)[2].str() + "'; write: " + banned.instead);
  }
  return found;
}

TEST(Words, AreThoseOfTheField) {
  std::vector<std::string> wrong;
  for (const auto& file : written_files()) {
    if (file.starts_with("tests/project/")) continue;  // names them to look for them
    for (auto& line : uses(file, text_of(file))) wrong.push_back(std::move(line));
  }
  EXPECT_TRUE(wrong.empty()) << in_lines(wrong);
}

// What git leaves where two branches changed the same lines.
TEST(Words, AreNotThoseOfAnUnfinishedMerge) {
  const std::string ours(7, '<'), theirs(7, '>');
  std::vector<std::string> wrong;
  for (const auto& file : written_files())
    for (const auto& line : lines_of(text_of(file)))
      if (line.starts_with(ours + " ") || line.starts_with(theirs + " ")) wrong.push_back(file + ": " + line);
  EXPECT_TRUE(wrong.empty()) << in_lines(wrong);
}

TEST(Words, BannedOnesAreNoticed) {
  EXPECT_EQ(uses("engine/a.h", "// A draught.\nclass AirDraught;\nint look_ahead_of = 1;\n").size(), 3U);
  EXPECT_EQ(uses("README.md", "The shoe moves to and fro. Said in words.\n").size(), 2U);
  EXPECT_EQ(uses("engine/a.h", "// Drought, indices, diced.\n").size(), 0U);
}

// What a document says is true now; how it came about is in the history.
TEST(Words, DocumentsKeepNoDiary) {
  const std::regex diary(R"((^|[^A-Za-z])(used to be|formerly|as of today|at first we)($|[^A-Za-z]))",
                         std::regex::icase);
  std::vector<std::string> wrong;
  for (const auto& file : written_files()) {
    if (!file.ends_with(".md") || file == "CHANGELOG.md") continue;
    const std::string text = text_of(file);
    for (std::sregex_iterator match(text.begin(), text.end(), diary), end; match != end; ++match)
      wrong.push_back(file + ": " + (*match)[2].str());
  }
  EXPECT_TRUE(wrong.empty()) << in_lines(wrong);
}

}  // namespace
}  // namespace diefill::project
