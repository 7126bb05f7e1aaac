// Who may know whom: reads every #include and fails where a folder reaches for what it may not.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "tests/project/source_files.h"

namespace diefill::project {
namespace {

/// What the files of a folder may include, by prefix.
struct Rule {
  std::string folder;
  std::vector<std::string> ours;       ///< of the project
  std::vector<std::string> libraries;  ///< besides the standard library and POSIX
};

/// The longest prefix wins, so that process/results is not ruled by process.
const std::vector<Rule>& rules() {
  static const std::vector<Rule> all = {
      {"engine/", {"engine/"}, {"Eigen/"}},
      {"geometry/",
       {"geometry/"},
       {"Eigen/", "CGAL/", "assimp/", "embree3/", "voro++/", "oneapi/tbb/", "tbb/"}},
      {"geometry/cad/read_3mf.cpp", {"geometry/"}, {"Eigen/", "Common/", "Model/COM/"}},
      {"geometry/cad/gltf_document.cpp", {"geometry/"}, {"nlohmann/"}},
      {"geometry/cad/referred_files.cpp", {"geometry/"}, {"nlohmann/"}},
      {"geometry/cad/zip_archive.cpp", {"geometry/"}, {"minizip/"}},
      {"geometry/cad/opencascade/",
       {"geometry/"},
       {"BRep", "Bnd_", "IGES", "Interface_", "Message", "Poly_", "STEPCAF", "Standard_", "TColStd_", "TDF_",
        "TDataStd_", "TDocStd_", "TopExp_", "TopoDS", "XCAFDoc_"}},
      {"process/results/", {"process/results/"}, {"Eigen/", "hdf5.h", "nlohmann/"}},
      {"process/results/studies/quantiles.cpp", {"process/results/"}, {"boost/math/"}},
      {"process/measure/", {"process/results/", "process/measure/", "geometry/"}, {"Eigen/"}},
      {"process/",
       {"engine/", "geometry/", "process/"},
       {"Eigen/", "toml++/", "udunits2.h", "zlib.h", "boost/math/"}},
      {"process/cluster/lammps/", {"engine/", "geometry/", "process/"}, {"Eigen/", "lammps/", "mpi.h"}},
      {"process/compare/backups.cpp", {"process/"}, {"nlohmann/"}},
      {"process/plan/pilot_cache.cpp", {"engine/", "geometry/", "process/"}, {"nlohmann/"}},
      {"process/estimate/discharge/fitted_discharge.cpp",
       {"engine/", "geometry/", "process/"},
       {"nlohmann/"}},
      {"process/laboratory/published/custom_runs.cpp", {"engine/", "process/"}, {"nlohmann/"}},
      {"process/laboratory/published/sawing/sawing_json.h", {"process/"}, {"nlohmann/"}},
      {"process/calibration/methods/",
       {"process/results/", "process/calibration/methods/"},
       {"Eigen/", "boost/random/", "nlopt.h"}},
      {"render/", {"process/results/", "render/"}, {"Eigen/", "Q", "vtk", "GL/"}},
      {"render/tracing/", {"render/"}, {"Eigen/", "Q", "embree3/", "oneapi/tbb/"}},
      {"app/", {"engine/", "geometry/", "process/", "render/", "app/"}, {"Eigen/", "CLI/", "nlohmann/"}},
      {"app/python/", {"process/results/", "app/python/"}, {"Eigen/", "pybind11/"}},
      {"app/freed_memory.cpp", {"app/"}, {"malloc.h"}},  // GNU's, where there is one
  };
  return all;
}

const Rule* rule_of(const std::string& file) {
  const Rule* best = nullptr;
  for (const Rule& rule : rules())
    if (file.starts_with(rule.folder) && (best == nullptr || rule.folder.size() > best->folder.size()))
      best = &rule;
  return best;
}

bool begins_with_any(const std::string& name, const std::vector<std::string>& prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(),
                     [&](const auto& prefix) { return name.starts_with(prefix); });
}

/// Headers of the system: <vector> has no dot and no slash; POSIX ones are these.
bool of_the_system(const std::string& name) {
  static const std::regex standard("[a-z_0-9]+"),
      posix("(sys/[a-z]+|unistd|fcntl|dlfcn|poll|netdb|sched)\\.h");
  return std::regex_match(name, standard) || std::regex_match(name, posix);
}

/// What is wrong with the includes of one file, a line each.
std::vector<std::string> trespasses(const std::string& file, const std::string& text) {
  static const std::regex include("[ \\t]*#[ \\t]*include[ \\t]*([<\"])([^>\"]+)[>\"].*");
  std::vector<std::string> wrong;
  const Rule* rule = rule_of(file);
  if (rule == nullptr) return {file + ": no rule says what this folder may include"};
  for (const std::string& line : lines_of(text)) {
    std::smatch part;
    if (!std::regex_match(line, part, include)) continue;
    const bool quoted = part[1] == "\"";
    const std::string name = part[2];
    const bool allowed = quoted ? begins_with_any(name, rule->ours)
                                : of_the_system(name) || begins_with_any(name, rule->libraries);
    if (!allowed) wrong.push_back(file + ": " + line);
  }
  return wrong;
}

TEST(FolderRules, EveryFolderIncludesOnlyWhatItMayKnow) {
  std::vector<std::string> wrong;
  for (const auto& file : source_files()) {
    if (file.starts_with("tests/") || file.starts_with("sample_tools/")) continue;
    const auto more = trespasses(file, text_of(file));
    wrong.insert(wrong.end(), more.begin(), more.end());
  }
  EXPECT_TRUE(wrong.empty()) << in_lines(wrong);
}

TEST(FolderRules, TrespassesAreNoticed) {
  EXPECT_EQ(trespasses("engine/a.cpp", "#include \"geometry/mesh/mesh.h\"\n").size(), 1U);
  EXPECT_EQ(
      trespasses("engine/a.cpp", "#include <hdf5.h>\n#include <vector>\n#include <Eigen/Core>\n").size(), 1U);
  EXPECT_EQ(trespasses("geometry/a.h", "  # include \"process/scene/scene.h\"\n").size(), 1U);
  EXPECT_EQ(trespasses("process/results/a.h", "#include \"process/scene/scene.h\"\n").size(), 1U);
  EXPECT_EQ(
      trespasses("process/run/a.h", "#include \"render/charts/chart.h\"\n#include \"engine/walls/walls.h\"\n")
          .size(),
      1U);
  EXPECT_EQ(trespasses("render/a.cpp", "#include \"process/measure/measure.h\"\n#include <QImage>\n").size(),
            1U);
  EXPECT_EQ(
      trespasses("app/a.cpp", "#include \"tests/app/cad.h\"\n#include \"../engine/walls/walls.h\"\n").size(),
      2U);
  EXPECT_EQ(trespasses("geometry/a.cpp", "#include <TopoDS.hxx>\n").size(), 1U);
  EXPECT_EQ(trespasses("elsewhere/a.cpp", "").size(), 1U);
}

TEST(FolderRules, NoProductFileKnowsTheTests) {
  for (const auto& file : source_files()) {
    if (file.starts_with("tests/")) continue;
    EXPECT_EQ(text_of(file).find("\"tests/"), std::string::npos) << file;
  }
}

}  // namespace
}  // namespace diefill::project
