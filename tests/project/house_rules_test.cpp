// Habits that keep the code readable: short files, headers that say what they are for, nothing half done.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "tests/project/source_files.h"

namespace diefill::project {
namespace {

TEST(HouseRules, FilesStayUnderFourHundredLines) {
  std::vector<std::string> long_files;
  for (const auto& file : source_files()) {
    const std::size_t lines = lines_of(text_of(file)).size();
    if (lines >= 400) long_files.push_back(file + ": " + std::to_string(lines) + " lines");
  }
  EXPECT_TRUE(long_files.empty()) << in_lines(long_files);
}

TEST(HouseRules, HeadersOpenWithWhatTheyAreForAndGuardThemselves) {
  std::vector<std::string> wrong;
  for (const auto& file : source_files()) {
    if (!file.ends_with(".h")) continue;
    const auto lines = lines_of(text_of(file));
    const bool says_what_for =
        !lines.empty() && lines.front().starts_with("// ") && lines.front().size() > 20;
    const bool guarded = std::find(lines.begin(), lines.end(), "#pragma once") != lines.end();
    if (!says_what_for || !guarded) wrong.push_back(file);
  }
  EXPECT_TRUE(wrong.empty()) << in_lines(wrong);
}

// Places on one developer's machine mean nothing on another.
TEST(HouseRules, NoFileNamesAPlaceOnOneMachine) {
  const std::regex place(
      "(^|[^A-Za-z0-9_.])/(home|work|root|Users|mnt|media)/[A-Za-z]|[A-Z]:\\\\\\\\[A-Za-z]");
  std::vector<std::string> wrong;
  for (const auto& file : written_files()) {
    if (file.starts_with("tests/project/")) continue;  // names them to look for them
    for (const auto& line : lines_of(text_of(file)))
      if (std::regex_search(line, place)) wrong.push_back(file + ": " + line);
  }
  EXPECT_TRUE(wrong.empty()) << in_lines(wrong);
}

TEST(HouseRules, NothingIsLeftHalfDone) {
  const std::regex mark("\\b(TODO|FIXME|XXX|HACK)\\b|not implemented|GTEST_SKIP|EXPECT_TRUE\\(true\\)");
  std::vector<std::string> wrong;
  for (const auto& file : source_files()) {
    if (file.starts_with("tests/project/")) continue;
    for (const auto& line : lines_of(text_of(file)))
      if (std::regex_search(line, mark)) wrong.push_back(file + ": " + line);
  }
  EXPECT_TRUE(wrong.empty()) << in_lines(wrong);
}

// Working memory is passed to whoever works with it (engine/README.md, Threads).
TEST(HouseRules, WorkingMemoryIsPassedAndNotKeptPerThread) {
  std::vector<std::string> wrong;
  for (const auto& file : source_files()) {
    if (file.starts_with("tests/project/")) continue;
    for (const auto& line : lines_of(text_of(file)))
      if (line.find("thread_local") != std::string::npos) wrong.push_back(file + ": " + line);
  }
  EXPECT_TRUE(wrong.empty()) << in_lines(wrong);
}

TEST(HouseRules, SourceFilesEndInOneLineEndAndHoldNoTabs) {
  std::vector<std::string> wrong;
  for (const auto& file : source_files()) {
    const std::string text = text_of(file);
    const bool ends_well = text.ends_with('\n') && !text.ends_with("\n\n");
    if (!ends_well || text.find('\t') != std::string::npos || text.find('\r') != std::string::npos)
      wrong.push_back(file);
  }
  EXPECT_TRUE(wrong.empty()) << in_lines(wrong);
}

}  // namespace
}  // namespace diefill::project
