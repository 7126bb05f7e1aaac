// What documents point to exists: linked files, and commands of the program.
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <regex>
#include <set>

#include "tests/project/source_files.h"

namespace diefill::project {
namespace {

/// Every match's first group in the text of every document.
void for_each_match(const std::regex& pattern,
                    const std::function<void(const std::string&, const std::string&)>& use) {
  for (const auto& file : written_files()) {
    if (!file.ends_with(".md")) continue;
    const std::string text = text_of(file);
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
      use(file, (*match)[1].str());
  }
}

TEST(Documents, LinkToFilesThatExist) {
  std::vector<std::string> missing;
  for_each_match(std::regex(R"(\]\(([^)#\s]+))"), [&](const auto& file, const auto& link) {
    if (link.find("://") == std::string::npos && !exists_beside(file, link))
      missing.push_back(file + ": " + link);
  });
  EXPECT_TRUE(missing.empty()) << in_lines(missing);
}

TEST(Documents, NameCommandsThatTheProgramHas) {
  std::set<std::string> commands;
  const std::string source = text_of("app/commands/commands.cpp");
  const std::regex registration(R"(add_(\w+)\(program)");
  for (std::sregex_iterator match(source.begin(), source.end(), registration), end; match != end; ++match)
    commands.insert((*match)[1].str());
  ASSERT_FALSE(commands.empty());
  std::vector<std::string> unknown;
  for_each_match(std::regex(R"(`(?:build/bin/)?diefill ([a-z_]+))"), [&](const auto& file, const auto& name) {
    if (!commands.contains(name)) unknown.push_back(file + ": diefill " + name);
  });
  EXPECT_TRUE(unknown.empty()) << in_lines(unknown);
}

}  // namespace
}  // namespace diefill::project
