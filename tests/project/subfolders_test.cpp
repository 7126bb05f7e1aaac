// Order of subfolders: each includes only those before it. These are the folders directly below engine,
// geometry, process, render and app; files in none of them (main, exit codes) may be included by all
// subfolders of theirs.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>

#include "tests/project/source_files.h"

namespace diefill::project {
namespace {

/// Subfolders of each folder, lowest first: a file includes from its own subfolder and from those before it.
const std::map<std::string, std::vector<std::string>>& subfolders() {
  static const std::map<std::string, std::vector<std::string>> all = {
      {"engine",
       {"numerics", "laws", "coarse_graining", "powder", "walls", "search", "contact", "integrate",
        "simulation", "observe", "fluid", "limits"}},
      {"geometry", {"grids", "mesh", "solid", "cad", "voronoi", "reach", "cavity", "wall_spheres"}},
      {"process",
       {"results", "measure", "input", "machine", "scene", "measured_data", "press_mesh", "powder", "tooling",
        "setup", "run", "cluster", "plan", "compare", "tradeoff", "continuum", "laboratory", "calibration",
        "estimate"}},
      {"render", {"style", "offscreen", "tracing", "fields", "charts", "scene3d", "report"}},
      {"app", {"tables", "options", "pictures", "shell", "commands", "python"}},
  };
  return all;
}

/// Index of a subfolder in its folder's order, or -1.
std::ptrdiff_t place_of(const std::string& folder, const std::string& subfolder) {
  const auto& order = subfolders().at(folder);
  const auto found = std::find(order.begin(), order.end(), subfolder);
  return found == order.end() ? -1 : found - order.begin();
}

/// What is wrong with the includes of one file, a line each.
std::vector<std::string> against_the_order(const std::string& file, const std::string& text) {
  static const std::regex in_subfolder("(engine|geometry|process|render|app)/([a-z0-9_]+)/.*"),
      include("[ \\t]*#[ \\t]*include[ \\t]*\"([^\"]+)\".*");
  std::smatch own;
  if (!std::regex_match(file, own, in_subfolder)) return {};
  const std::string folder = own[1], subfolder = own[2];
  if (place_of(folder, subfolder) < 0)
    return {file + ": subfolder " + subfolder + " is missing in the order of subfolders"};
  std::vector<std::string> wrong;
  for (const std::string& line : lines_of(text)) {
    std::smatch part, other;
    if (!std::regex_match(line, part, include)) continue;
    const std::string name = part[1];
    if (!std::regex_match(name, other, in_subfolder) || other[1] != folder) continue;
    const auto place = place_of(folder, other[2]);
    if (place < 0 || place > place_of(folder, subfolder)) wrong.push_back(file + ": " + line);
  }
  return wrong;
}

TEST(Subfolders, IncludeFromThemselvesAndFromThoseBeforeThem) {
  std::vector<std::string> wrong;
  for (const auto& file : source_files())
    for (auto& line : against_the_order(file, text_of(file))) wrong.push_back(std::move(line));
  EXPECT_TRUE(wrong.empty()) << in_lines(wrong);
}

TEST(Subfolders, IncludesAgainstTheOrderAreNoticed) {
  EXPECT_EQ(against_the_order("engine/laws/a.h", "#include \"engine/contact/pair_loop.h\"\n").size(), 1U);
  EXPECT_EQ(against_the_order("engine/contact/a.h", "#include \"engine/laws/parts.h\"\n").size(), 0U);
  EXPECT_EQ(against_the_order("process/machine/a.h", "#include \"process/scene/scene.h\"\n").size(), 1U);
  EXPECT_EQ(against_the_order("engine/elsewhere/a.h", "").size(), 1U);
}

TEST(Subfolders, HaveAReadme) {
  const auto files = written_files();
  for (const auto& [folder, order] : subfolders())
    for (const auto& subfolder : order) {
      const std::string readme = folder + "/" + subfolder + "/README.md";
      EXPECT_NE(std::find(files.begin(), files.end(), readme), files.end()) << readme << " is missing";
    }
}

TEST(Subfolders, ASourceIncludesTheHeaderOfItsName) {
  const auto files = source_files();
  for (const auto& file : files) {
    if (!file.ends_with(".h") || file.starts_with("tests/")) continue;
    const std::string source = file.substr(0, file.size() - 2) + ".cpp";
    if (std::find(files.begin(), files.end(), source) == files.end()) continue;
    EXPECT_NE(text_of(source).find("#include \"" + file + "\""), std::string::npos)
        << source << " does not include " << file;
  }
}

}  // namespace
}  // namespace diefill::project
