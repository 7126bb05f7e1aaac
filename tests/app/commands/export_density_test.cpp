// A run's density in the mesh of a press simulation, from the command line.
#include <gtest/gtest.h>

#include <array>
#include <iomanip>
#include <sstream>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

namespace fs = std::filesystem;

/// 2 x 2 x 2 hexahedra over the pocket of the small die, numbered from 101, with `per_mm` units in a
/// millimetre.
std::string pocket_alone(double per_mm) {
  std::ostringstream text;
  text << std::setprecision(12) << std::showpoint;
  text << "*NODE\n";
  int number = 0;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
        text << ++number << ", " << per_mm * (-5 + 2 * i) << ", " << per_mm * (-2 + 2 * j) << ", "
             << per_mm * (-4 + 2 * k) << "\n";
  text << "*ELEMENT, TYPE=C3D8R\n";
  int element = 100;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        const int first = (k * 3 + j) * 3 + i + 1;
        text << ++element;
        for (const int node : {0, 1, 4, 3, 9, 10, 13, 12}) text << ", " << first + node;
        text << "\n";
      }
  return text.str();
}

/// The same in mm, and one element far away, 200.
std::string pocket_mesh() {
  std::ostringstream text;
  int number = 27;
  text << "*NODE\n";
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) text << ++number << ", " << 50 + i << ", " << j << ", " << k << "\n";
  return pocket_alone(1) + text.str() + "*ELEMENT, TYPE=C3D8R\n200, 28, 29, 31, 30, 32, 33, 35, 34\n";
}

/// Sum of a column (from 0) of a CSV.
double sum_of_column(const fs::path& csv, int column) {
  std::istringstream lines(contents(csv));
  std::string line;
  std::getline(lines, line);
  double sum = 0;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (int n = 0; n <= column; ++n) std::getline(cells, cell, ',');
    if (!cell.empty()) sum += std::stod(cell);
  }
  return sum;
}

TEST(ExportDensity, OfARunConservesItsMassAndNamesElementsOutside) {
  const SmallDie die;
  ASSERT_EQ(die.run({"--quiet", "--no-pictures"}).exit_code, 0);
  die.write("pocket.inp", pocket_mesh());
  const auto mesh = (die.folder() / "pocket.inp").string();
  const auto out = die.folder() / "density";
  const auto exported = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"export", die.out().string(), "--out", out.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  };
  const Outcome outcome = exported({"--density-for", mesh, "--density-grid", "1 mm"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("outside the powder: "), std::string::npos) << outcome.out;
  EXPECT_NE(contents(out / "pocket_density_outside.csv").find("\n200\n"), std::string::npos);
  const double mass = die.report()["filled_mass_kg"];
  EXPECT_NEAR(sum_of_column(out / "pocket_density_elements.csv", 7) / mass, 1, 1e-6);
  EXPECT_NEAR(sum_of_column(out / "density_grid.csv", 3) / mass, 1, 1e-6);
  for (const char* name : {"pocket_density.vtu", "pocket_density_abaqus.inp", "pocket_density_calculix.inp",
                           "pocket_density_nodes.csv", "pocket_density_outside.csv", "density_grid.vti"})
    EXPECT_TRUE(fs::exists(out / name)) << name;

  // The mesh that was written is a mesh to start from: in m, with the same mass.
  ASSERT_EQ(exported({"--density-for", (out / "pocket_density.vtu").string(), "--mesh-unit", "m", "--mass",
                      "0.1 g"})
                .exit_code,
            0);
  EXPECT_NEAR(sum_of_column(out / "pocket_density_density_elements.csv", 7), 1e-4, 1e-10);

  // Systems that know no small letters in names.
  die.write("POCKET.INP", pocket_mesh());
  EXPECT_EQ(exported({"--density-for", (die.folder() / "POCKET.INP").string()}).exit_code, 0);
  EXPECT_TRUE(fs::exists(out / "POCKET_density.vtu"));

  const auto refused = [&](const std::vector<std::string>& more, const std::string& reason) {
    const Outcome bad = exported(more);
    EXPECT_EQ(bad.exit_code, 2) << reason;
    EXPECT_EQ(bad.complaints(), 1U) << bad.err;
    EXPECT_NE(bad.err.find(reason), std::string::npos) << bad.err;
  };
  refused({"--density-for", mesh, "--mesh-unit", "m"}, "no element lies in the powder");
  refused({"--density-for", mesh, "--mesh-unit", "kg"}, "allowed: m, dm, cm, mm, um, nm, inch, ft");
  refused({"--density-for", mesh, "--mesh-unit", "2 mm"}, "allowed: m, dm, cm, mm");
  refused({"--density-for", mesh, "--mass", "fild"}, "did you mean \"filled\"? (allowed: filled, expected)");
  refused({"--density-for", mesh, "--mass", "1000 t"}, "--mass: found \"1000 t\", allowed: more than 0");
  refused({"--density-for", mesh, "--mesh-position", "0 mm", "0 mm", "1e9 m"}, "--mesh-position: found");
  refused({"--density-for", mesh, "--mass", "100 kg"}, "allowed: up to 1, the solid of");
  refused({"--density-for", mesh, "--mass", "0 g"}, "allowed: more than 0");
  refused({"--density-for", "mesh.stl"}, "a mesh ending in .vtu, .msh");
  refused({"--density-grid", "0.001 mm"}, "20 million cells");
}

// One layer of powder in a shoe that stands: no grain is enclosed by others.
TEST(ExportDensity, WithoutASolidFractionTheOptionThatIsGivenIsNamed) {
  const SmallDie die;
  die.exchange("fill_height = \"5 mm\"", "fill_height = \"1 mm\"");
  die.exchange_passage("[[step]]\nkind = \"wait\"\nduration = \"10 ms\"\n");
  ASSERT_EQ(die.run({"--quiet", "--no-pictures"}).exit_code, 0);
  const auto refused = [&](const std::string& size, const std::string& expected) {
    const Outcome outcome = run_program({"export", die.out().string(), "--density-grid", size});
    EXPECT_EQ(outcome.exit_code, 2) << size;
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(expected), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("--density-for"), std::string::npos) << outcome.err;
  };
  refused("1 mm", "--density-grid: the result holds no measured solid fraction");
  refused("1 kg", "--density-grid: found \"1 kg\"");
}

TEST(ExportDensity, OfAMeshInAnyUnitIsThatOfTheSameMesh) {
  const SmallDie die;
  ASSERT_EQ(die.run({"--quiet", "--no-pictures"}).exit_code, 0);
  const auto exported = [&](const std::string& name, const std::string& unit) {
    return run_program({"export", die.out().string(), "--out", (die.folder() / "density").string(),
                        "--density-for", (die.folder() / name).string(), "--mesh-unit", unit});
  };
  for (const auto& [unit, per_mm] : {std::pair<const char*, double>{"mm", 1},
                                     {"cm", 0.1},
                                     {"m", 1e-3},
                                     {"um", 1e3},
                                     {"inch", 1 / 25.4},
                                     {"ft", 1 / 304.8}}) {
    SCOPED_TRACE(unit);
    const std::string name = std::string(unit) + ".inp";
    die.write(name, pocket_alone(per_mm));
    const Outcome outcome = exported(name, unit);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("mesh: 8 elements, 27 nodes, 64 mm^3"), std::string::npos) << outcome.out;
    EXPECT_NEAR(sum_of_column(die.folder() / "density" / (std::string(unit) + "_density_elements.csv"), 7),
                die.report()["filled_mass_kg"], 1e-9);
  }
  // In a larger unit than its own it would be thousands of times the pocket.
  for (const auto& [name, wrong, own] : {std::array<const char*, 3>{"mm.inp", "inch", "mm"},
                                         {"mm.inp", "cm", "mm"},
                                         {"inch.inp", "m", "inch"}}) {
    const Outcome bad = exported(name, wrong);
    EXPECT_EQ(bad.exit_code, 2) << name;
    EXPECT_EQ(bad.complaints(), 1U) << bad.err;
    EXPECT_NE(bad.err.find(std::string("it is as large: give --mesh-unit ") + own), std::string::npos)
        << bad.err;
  }
}

}  // namespace
}  // namespace diefill::app
