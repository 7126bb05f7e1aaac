// What several files say of the release is the same in all of them.
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "tests/project/source_files.h"

namespace diefill::project {
namespace {

/// The groups of the first match of `pattern` in a file, with blanks between them.
std::string stated(const std::string& file, const std::string& pattern) {
  const std::string text = text_of(file);
  std::smatch match;
  if (!std::regex_search(text, match, std::regex(pattern))) return "nothing in " + file;
  std::string groups;
  for (std::size_t k = 1; k < match.size(); ++k) groups += (k == 1 ? "" : " ") + match[k].str();
  return groups;
}

TEST(Release, HasOneVersion) {
  const std::string version = stated("CMakeLists.txt", R"(project\(diefill VERSION ([0-9.]+))");
  EXPECT_EQ(stated("CITATION.cff", R"(\nversion: ([0-9.]+)\n)"), version);
  EXPECT_EQ(stated("CHANGELOG.md", R"(\n## ([0-9.]+),)"), version);
}

TEST(Release, HasOneSchemaOfResults) {
  const std::string code = "process/results/storage/schema.h";
  const std::string schema = stated(code, R"(kSchemaVersion = ([0-9]+))"),
                    oldest = stated(code, R"(kOldestSchemaVersion = ([0-9]+))");
  EXPECT_EQ(stated("process/results/README.md", R"(\n## results\.h5, schema version ([0-9]+)\n)"), schema);
  EXPECT_EQ(
      stated("CHANGELOG.md", R"(schema version ([0-9]+); versions ([0-9]+) to ([0-9]+) are still read)"),
      schema + " " + oldest + " " + std::to_string(std::stoi(schema) - 1));
}

}  // namespace
}  // namespace diefill::project
