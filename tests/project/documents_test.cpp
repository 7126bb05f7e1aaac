// What documents name exists: files, commands, options, and keys of scenes; and what is in a folder is
// named on its page.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "tests/project/document_text.h"
#include "tests/project/source_files.h"

namespace diefill::project {
namespace {

/// `name` as a file, folder, or source without its ending, seen from `folder` (empty or with a slash at its
/// end).
bool names_a_file(const std::string& folder, const std::string& name) {
  constexpr std::array kEndings = {"", ".h", ".cpp"};
  return std::any_of(kEndings.begin(), kEndings.end(),
                     [&](const char* ending) { return exists_beside(folder + "x", name + ending); });
}

/// From the document's folder or one above it, the root included.
bool names_a_file_near(const std::string& document, const std::string& name) {
  for (std::string folder = folder_of(document);; folder = folder_of(folder.substr(0, folder.size() - 1))) {
    if (names_a_file(folder, name)) return true;
    if (folder.empty()) return false;
  }
}

bool stands_for_several(const std::string& name) {
  return name.find_first_of("<>*{}, ") != std::string::npos || name.find("...") != std::string::npos;
}

/// Paths into the project and names of sources; not those of files that the program or its user makes.
bool is_path_of_project(const std::string& name) {
  static const std::regex path("(\\.\\./)*(engine|geometry|process|render|app|tests|sample_tools)/[\\w./-]+"),
      source("[\\w./-]+\\.(h|cpp|cmake|scad)");
  return !stands_for_several(name) && (std::regex_match(name, path) || std::regex_match(name, source));
}

/// Paths without an ending, such as `run/fill_run`, that begin with a folder beside the document or above it;
/// not those of files that builds and runs make, nor of groups in results.h5.
bool is_path_from_a_folder(const std::string& document, const std::string& name) {
  static const std::regex path("([a-z0-9_]+)(/[a-z0-9_]+)+");
  std::smatch part;
  if (!std::regex_match(name, part, path) || document == "process/results/README.md") return false;
  return part[1] != "build" && part[1] != "out" && names_a_file_near(document, part[1]);
}

/// What a document names and the project lacks, a line each.
std::vector<std::string> missing_files(const std::string& document, const std::string& text) {
  std::set<std::string> known;
  for (const auto& file : written_files()) known.insert(std::filesystem::path(file).filename());
  std::vector<std::string> missing;
  for (const auto& line : lines_of(text))
    for (const auto& name : quoted_code(line)) {
      const bool bare = name.find('/') == std::string::npos;
      if (is_path_of_project(name) && !(bare ? known.contains(name) : names_a_file_near(document, name)))
        missing.push_back(document + ": " + name);
      else if (is_path_from_a_folder(document, name) && !names_a_file_near(document, name) &&
               !exists_beside("sample_tools/x", name + ".toml"))
        missing.push_back(document + ": " + name);
    }
  return missing;
}

TEST(Documents, LinkToFilesThatExist) {
  std::vector<std::string> missing;
  for_each_match(std::regex(R"(\]\(([^)#\s]+))"), [&](const auto& file, const auto& link) {
    if (link.find("://") == std::string::npos && !exists_beside(file, link))
      missing.push_back(file + ": " + link);
  });
  EXPECT_TRUE(missing.empty()) << in_lines(missing);
}

TEST(Documents, NameFilesThatExist) {
  std::vector<std::string> missing;
  for (const auto& document : documents())
    for (auto& line : missing_files(document, text_of(document))) missing.push_back(std::move(line));
  EXPECT_TRUE(missing.empty()) << in_lines(missing);
  EXPECT_EQ(
      missing_files("engine/README.md", "`laws/nowhere.h` `engine/laws/parts.h` `gone.cpp` `laws/parts`"),
      (std::vector<std::string>{"engine/README.md: laws/nowhere.h", "engine/README.md: gone.cpp"}));
  EXPECT_EQ(
      missing_files("process/plan/README.md", "`run/nowhere` `run/fill_run` `narrow_ring/fill` `N/m` `m/s`"),
      std::vector<std::string>{"process/plan/README.md: run/nowhere"});
}

TEST(Documents, ListFilesThatStandBesideThem) {
  std::vector<std::string> missing;
  for (const auto& document : documents())
    for (const auto& cell : file_cells(text_of(document)))
      for (const auto& name : quoted_code(cell))
        if (!stands_for_several(name) && !names_a_file(folder_of(document), name))
          missing.push_back(document + ": " + name);
  EXPECT_TRUE(missing.empty()) << in_lines(missing);
}

TEST(Documents, ListEveryFileOfTheirFolder) {
  std::vector<std::string> unlisted;
  for (const auto& file : source_files()) {
    const std::string folder = folder_of(file), page = folder + "README.md";
    if (file.starts_with("tests/") || !exists_beside(folder + "x", "README.md")) continue;
    if (folder == "process/scene/") continue;  // its page is the user's: keys, not files
    const std::string text = text_of(page), name = std::filesystem::path(file).filename();
    const std::string stem = std::filesystem::path(file).stem();
    const bool listed = text.find('`' + stem + '`') != std::string::npos ||
                        text.find('`' + name + '`') != std::string::npos ||
                        text.find('`' + stem + ".h`") != std::string::npos;
    if (!listed) unlisted.push_back(page + ": " + name);
  }
  EXPECT_TRUE(unlisted.empty()) << in_lines(unlisted);
}

TEST(Documents, NameCommandsThatTheProgramHas) {
  std::set<std::string> commands;
  const std::string source = text_of("app/commands/commands.cpp");
  const std::regex registration(R"(add_(\w+)\(program)");
  for (std::sregex_iterator match(source.begin(), source.end(), registration), end; match != end; ++match)
    commands.insert(std::regex_replace((*match)[1].str(), std::regex("_"), "-"));
  ASSERT_FALSE(commands.empty());
  std::vector<std::string> unknown;
  for_each_match(std::regex(R"(`(?:build/bin/)?diefill ([a-z][a-z_-]*[a-z]))"),
                 [&](const auto& file, const auto& name) {
                   if (!commands.contains(name)) unknown.push_back(file + ": diefill " + name);
                 });
  EXPECT_TRUE(unknown.empty()) << in_lines(unknown);
}

/// All that is written in sources and scripts below `folders`.
std::string all_code(const std::vector<std::string>& folders) {
  std::string code;
  for (const auto& file : written_files())
    if (!file.ends_with(".md") && std::any_of(folders.begin(), folders.end(),
                                              [&](const auto& folder) { return file.starts_with(folder); }))
      code += text_of(file);
  return code;
}

TEST(Documents, NameOptionsThatProgramsHave) {
  const std::string code = all_code({"app/", "tests/", "sample_tools/"});
  std::vector<std::string> unknown;
  for_each_match(std::regex("[` ](--[a-z][a-z-]+)(?![a-z_-])"), [&](const auto& file, const auto& option) {
    if (code.find(option) == std::string::npos) unknown.push_back(file + ": " + option);
  });
  EXPECT_TRUE(unknown.empty()) << in_lines(unknown);
}

TEST(Documents, NameTypesMembersAndConstantsThatSourcesHave) {
  const std::string code = all_code({"engine/", "geometry/", "process/", "render/", "app/", "tests/"});
  static const std::regex word("[A-Za-z_][A-Za-z_0-9]*"),
      identifier("([A-Z][A-Za-z0-9]*)::(\\w+)(\\(.*\\))?|k[A-Z]\\w*");
  std::set<std::string> known;
  for (std::sregex_iterator match(code.begin(), code.end(), word), end; match != end; ++match)
    known.insert(match->str());
  std::vector<std::string> unknown;
  for (const auto& document : documents())
    for (const auto& line : lines_of(text_of(document)))
      for (const auto& name : quoted_code(line)) {
        std::smatch part;
        if (!std::regex_match(name, part, identifier)) continue;
        const bool exists =
            part[1].matched ? known.contains(part[1]) && known.contains(part[2]) : known.contains(name);
        if (!exists) unknown.push_back(document + ": " + name);
      }
  EXPECT_TRUE(unknown.empty()) << in_lines(unknown);
}

// Files move; comments that name them are forgotten.
TEST(Documents, CommentsNameSourcesThatExist) {
  const std::regex comment("//.*"), source("[\\w./-]*\\w\\.(h|cpp)\\b"), system("GL/.*");
  const auto files = source_files();
  const auto exists = [&](const std::string& name) {
    return std::regex_match(name, system) || std::any_of(files.begin(), files.end(), [&](const auto& file) {
             return ('/' + file).ends_with('/' + name);
           });
  };
  std::vector<std::string> missing;
  for (const auto& file : files)
    for (const auto& line : lines_of(text_of(file))) {
      std::smatch part;
      if (file.starts_with("tests/project/") || !std::regex_search(line, part, comment)) continue;
      const std::string text = part.str();
      for (std::sregex_iterator match(text.begin(), text.end(), source), end; match != end; ++match)
        if (!exists(match->str())) missing.push_back(file + ": " + match->str());
    }
  EXPECT_TRUE(missing.empty()) << in_lines(missing);
}

// Points that the source leaves open are known by number everywhere, and explained on one page.
TEST(Documents, ExplainEveryOpenPointThatIsNamed) {
  const std::string page = text_of("engine/OPEN_POINTS.md");
  const std::regex point("\\bOP-[0-9]+\\b");
  std::set<std::string> unexplained;
  for (const auto& file : written_files()) {
    const std::string text = text_of(file);
    for (std::sregex_iterator match(text.begin(), text.end(), point), end; match != end; ++match)
      if (page.find("| " + match->str() + " |") == std::string::npos)
        unexplained.insert(file + ": " + match->str());
  }
  EXPECT_TRUE(unexplained.empty()) << in_lines({unexplained.begin(), unexplained.end()});
}

/// Keys of scenes that a document names: `table.key` in its text, and all of its blocks of TOML.
std::set<std::string> scene_keys(const std::string& text) {
  static const std::regex table_key(
      "(?!powder\\.vtp)(?:powder|pour|walls|numerics|economy|measure|contact|suction|motion)\\.([a-z_]+)(?:"
      "\\.([a-z_]+))?(?: "
      "= .*)?"),
      assigned(" *([a-z_]+) *=.*"), heading(" *\\[+([a-z_]+)(?:\\.([a-z_]+))*\\]+.*");
  std::set<std::string> keys;
  const auto take = [&](const std::string& line, const std::regex& pattern) {
    std::smatch part;
    if (!std::regex_match(line, part, pattern)) return;
    for (std::size_t k = 1; k < part.size(); ++k)
      if (part[k].matched) keys.insert(part[k]);
  };
  for (const auto& line : lines_of(text))
    for (const auto& code : quoted_code(line)) take(code, table_key), take(code, heading);
  for (const auto& line : code_lines(text, "toml")) take(line, assigned), take(line, heading);
  return keys;
}

TEST(Documents, NameKeysThatScenesHave) {
  EXPECT_EQ(scene_keys("`economy.sleep` and `[powder.sizes]`\n```toml\nseed = 2\n```\n"),
            (std::set<std::string>{"powder", "seed", "sizes", "sleep"}));
  const std::string code = all_code({"process/"});
  std::vector<std::string> unknown;
  for (const auto& document : documents()) {
    if (document == "CHANGELOG.md") continue;  // tells which keys are gone
    for (const auto& key : scene_keys(text_of(document)))
      if (code.find('"' + key + '"') == std::string::npos && code.find('.' + key + '"') == std::string::npos)
        unknown.push_back(document + ": " + key);
  }
  EXPECT_TRUE(unknown.empty()) << in_lines(unknown);
}

}  // namespace
}  // namespace diefill::project
