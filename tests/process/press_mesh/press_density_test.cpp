// What the press simulation starts from: mass, uniform densities, elements outside, cards.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <sstream>

#include "geometry/mesh/mesh.h"
#include "process/measure/fields/element_density.h"
#include "process/measure/measure.h"
#include "process/press_mesh/density_files.h"
#include "process/press_mesh/density_grid.h"
#include "process/press_mesh/read_press_mesh.h"
#include "tests/process/measure_sample.h"
#include "tests/process/press_mesh/sample_meshes.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

constexpr double kWidth = 5e-4;  // m, of averages

/// A block of 12 x 12 x 12 grains about the origin, 6.6 mm wide, solid fraction as `value` gives it.
results::FillResult filled_block(const std::function<double(const Eigen::Vector3d&)>& value) {
  results::FillResult result;
  result.powder = powder_of(block(12, 5.5e-4));
  result.solid_fraction = fraction_of(result.powder, value);
  result.cavity.lower_corner = Eigen::Vector3d::Constant(-3.3e-3);
  result.cavity.upper_corner = Eigen::Vector3d::Constant(3.3e-3);
  result.cavity.volume = 6.6e-3 * 6.6e-3 * 6.6e-3;
  result.title = "a block";
  return result;
}

/// n x n x n hexahedra over a cube of this edge (m) about a point.
results::SolidMesh cube_mesh(int n, double edge, const Eigen::Vector3d& middle = Eigen::Vector3d::Zero()) {
  results::SolidMesh mesh;
  const auto node = [&](int i, int j, int k) {
    return static_cast<std::uint32_t>((k * (n + 1) + j) * (n + 1) + i);
  };
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        mesh.nodes.push_back(middle + edge * (Eigen::Vector3d(i, j, k) / n - Eigen::Vector3d::Constant(0.5)));
        mesh.node_numbers.push_back(mesh.nodes.size());
      }
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        results::SolidElement element{results::ElementShape::hexa8, mesh.elements.size() + 1, {}};
        element.nodes = {
            node(i, j, k),     node(i + 1, j, k),     node(i + 1, j + 1, k),     node(i, j + 1, k),
            node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
        mesh.elements.push_back(element);
      }
  return mesh;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(PressDensity, ConservesTheMassOfTheCavityInElementsAndNodes) {
  const auto result = filled_block([](const Eigen::Vector3d& p) { return 0.4 + 20 * p.x() + 10 * p.z(); });
  const double mass = filled_mass(result.powder, result.solid_fraction);
  const auto mesh = cube_mesh(3, 6.6e-3);
  const auto density = element_density(result, mesh, {kWidth, mass});
  EXPECT_NEAR(sum(density.mass) / mass, 1, 1e-12);
  double of_nodes = 0;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    of_nodes += density.node_volume[n] * density.node_relative[n] * density.solid_density;
  EXPECT_NEAR(of_nodes / mass, 1, 1e-12);
  EXPECT_LT(density.relative.front(), density.relative.back());  // denser at larger x and z
}

TEST(PressDensity, OfUniformPowderIsUniform) {
  const auto result = filled_block([](const Eigen::Vector3d&) { return 0.42; });
  const auto mesh = cube_mesh(2, 6e-3);
  const double mass = 0.42 * solid_density(result) * std::pow(6e-3, 3);
  const auto density = element_density(result, mesh, {kWidth, mass});
  constexpr double kRounding = 1e-10;  // of sums over the cells of the field
  EXPECT_NEAR(density.scale, 1, kRounding);
  for (const double relative : density.relative) EXPECT_NEAR(relative, 0.42, kRounding);
  for (const double relative : density.node_relative) EXPECT_NEAR(relative, 0.42, kRounding);
  EXPECT_TRUE(density.outside.empty());
}

TEST(PressDensity, NamesElementsOutsideThePowder) {
  const auto result = filled_block([](const Eigen::Vector3d&) { return 0.42; });
  auto mesh = cube_mesh(2, 6e-3, {4e-3, 0, 0});  // half of it beyond the block
  const auto density = element_density(result, mesh, {kWidth, 5e-5});
  EXPECT_EQ(density.outside, (std::vector<std::uint64_t>{2, 4, 6, 8}));
  EXPECT_EQ(density.mass[1], 0);
  EXPECT_GT(density.filled[0], 0.2);
  EXPECT_LT(density.filled[0], 1);
  EXPECT_NEAR(sum(density.mass), 5e-5, 5e-17);
  for (auto& node : mesh.nodes) node.x() += 1;
  EXPECT_THROW(element_density(result, mesh, {kWidth, 1e-3}), std::invalid_argument);
}

TEST(PressDensity, IsRefusedAboveThatOfTheSolid) {
  const auto result = filled_block([](const Eigen::Vector3d&) { return 0.42; });
  const auto mesh = cube_mesh(2, 6e-3);
  const double solid = solid_density(result) * std::pow(6e-3, 3);
  EXPECT_NO_THROW(element_density(result, mesh, {kWidth, 0.99 * solid}));
  try {
    element_density(result, mesh, {kWidth, 1.1 * solid});
    FAIL() << "not refused";
  } catch (const geometry::MeshError& error) {
    EXPECT_NE(std::string(error.what()).find("a relative density of 1.1, allowed: up to 1"),
              std::string::npos)
        << error.what();
  }
}

TEST(PressDensity, NamesElementsAboveThatOfTheSolid) {
  const support::TemporaryFolder folder;
  const auto result =  // one corner much denser than all the rest
      filled_block([](const Eigen::Vector3d& p) { return p.minCoeff() > 1.5e-3 ? 0.95 : 0.2; });
  const auto mesh = cube_mesh(4, 6e-3);
  const double solid = solid_density(result) * std::pow(6e-3, 3);
  const auto density = element_density(result, mesh, {kWidth, 0.36 * solid});
  EXPECT_EQ(density.above, std::vector<std::uint64_t>{64});
  EXPECT_EQ(write_density_files(folder.path(), "m", mesh, density, {"m.inp", ""}).size(), 6U);
  EXPECT_EQ(support::contents(folder.path() / "m_density_above_solid.csv"),
            "element denser than its solid\n64\n");
  EXPECT_NE(
      support::contents(folder.path() / "m_density_abaqus.inp").find("** WARNING: 1 elements are denser"),
      std::string::npos);
}

TEST(PressDensity, FilesHoldEveryElementAndNodeAndTheMass) {
  const support::TemporaryFolder folder;
  const auto result = filled_block([](const Eigen::Vector3d& p) { return 0.4 + 20 * p.x(); });
  const auto mesh = cube_mesh(2, 6.6e-3);
  const auto density = element_density(result, mesh, {kWidth, 1.3e-4});
  const auto files = write_density_files(folder.path(), "m", mesh, density, {"m.inp", "a\nb"});
  EXPECT_EQ(files.size(), 5U);
  std::istringstream elements(support::contents(folder.path() / "m_density_elements.csv"));
  double mass = 0;
  int rows = -1;
  for (std::string line; std::getline(elements, line); ++rows) {
    if (rows < 0) continue;
    std::vector<double> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(std::stod(cell));
    ASSERT_EQ(cells.size(), 9U);
    mass += cells[7];
  }
  EXPECT_EQ(rows, 8);
  EXPECT_NEAR(mass / 1.3e-4, 1, 1e-6);
  const std::string card = support::contents(folder.path() / "m_density_abaqus.inp");
  EXPECT_NE(card.find("\n*INITIAL CONDITIONS, TYPE=RELATIVE DENSITY\n1, 0."), std::string::npos) << card;
  EXPECT_NE(card.find("** run: a b\n"), std::string::npos);
  EXPECT_EQ(std::count(card.begin(), card.end(), '\n'), 5 + 27);
  const std::string other = support::contents(folder.path() / "m_density_calculix.inp");
  EXPECT_EQ(other.substr(other.find("\n1, ")), card.substr(card.find("\n1, ")));
  EXPECT_NE(other.find("TYPE=TEMPERATURE"), std::string::npos);
}

TEST(PressDensity, NodesOutsideGetNoCard) {
  const support::TemporaryFolder folder;
  const auto result = filled_block([](const Eigen::Vector3d&) { return 0.42; });
  const auto mesh = cube_mesh(2, 6e-3, {4e-3, 0, 0});
  write_density_files(folder.path(), "m", mesh, element_density(result, mesh, {kWidth, 5e-5}), {"m.inp", ""});
  const std::string card = support::contents(folder.path() / "m_density_abaqus.inp");
  EXPECT_NE(card.find("\n1, "), std::string::npos);
  EXPECT_EQ(card.find("\n3, "), std::string::npos);  // at the far end along x
  EXPECT_NE(card.find("** 4 elements lie outside"), std::string::npos);
  EXPECT_EQ(support::contents(folder.path() / "m_density_outside.csv"),
            "element outside the powder\n2\n4\n6\n8\n");
}

TEST(PressDensity, OfAGridConservesTheMass) {
  const auto result = filled_block([](const Eigen::Vector3d&) { return 0.42; });
  const double mass = filled_mass(result.powder, result.solid_fraction);
  const auto grid = density_grid(result, 1e-3, {kWidth, mass});
  EXPECT_NEAR(sum(grid.mass) / mass, 1, 1e-9);
  const auto middle = static_cast<std::size_t>(
      ((grid.cells.z() / 2) * grid.cells.y() + grid.cells.y() / 2) * grid.cells.x() + grid.cells.x() / 2);
  EXPECT_NEAR(grid.relative[middle], 0.42, 1e-12);
  EXPECT_TRUE(std::isnan(grid.relative.back()));  // above the cavity
  EXPECT_THROW(density_grid(result, 1e-6, {kWidth, mass}), std::invalid_argument);
}

TEST(PressDensity, OfRealPowderIsRelativeToItsMetal) {
  const auto result = filled_block([](const Eigen::Vector3d&) { return 0.42; });
  const double metal = 7870, volume = std::pow(6e-3, 3), mass = 0.4 * metal * volume;
  const auto density = element_density(result, cube_mesh(2, 6e-3), {kWidth, mass, metal});
  for (const double relative : density.relative) EXPECT_NEAR(relative, 0.4, 1e-10);
  EXPECT_NEAR(sum(density.mass) / mass, 1, 1e-12);
  const double of_model = filled_mass(result.powder, result.solid_fraction);
  const auto grid = density_grid(result, 1.1e-3, {kWidth, 0.8 * of_model, metal});
  EXPECT_EQ(grid.solid_density, metal);
  const auto plain = density_grid(result, 1.1e-3, {kWidth, of_model});
  for (std::size_t k = 0; k < grid.relative.size(); ++k) {
    EXPECT_NEAR(grid.mass[k], 0.8 * plain.mass[k], 1e-12 * of_model);
    if (std::isfinite(plain.relative[k])) {
      EXPECT_NEAR(grid.relative[k] * metal, 0.8 * plain.relative[k] * plain.solid_density, 1e-6);
    }
  }
}

TEST(PressDensity, OfAGridHasTheWallsOfTheCavityBetweenItsCells) {
  const auto result = filled_block([](const Eigen::Vector3d&) { return 0.42; });
  for (const double spacing : {1.1e-3, 0.55e-3, 1e-3, 0.7e-3}) {
    const auto grid = density_grid(result, spacing, {kWidth, 1e-4});
    const Eigen::Vector3d beyond = (result.cavity.lower_corner - grid.origin) / spacing;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GT(std::abs(beyond[axis] - std::floor(beyond[axis]) - 0.5), 1e-3) << spacing;
      const double end = grid.origin[axis] + spacing * grid.cells[axis];
      EXPECT_NEAR(end - result.cavity.upper_corner[axis],
                  result.cavity.lower_corner[axis] - grid.origin[axis], 1e-12);
    }
  }
}

TEST(PressDensity, ShapesOfElementsFillTheSameCube) {
  // One hexahedron, two wedges and six tetrahedra of one cube have its volume.
  const auto mesh = cube_mesh(1, 2);
  const auto& n = mesh.elements[0].nodes;
  EXPECT_NEAR(volume_of(mesh, mesh.elements[0]), 8, 1e-14);
  const auto volume = [&](results::ElementShape shape, std::vector<std::size_t> corners) {
    results::SolidElement element{shape, 1, {}};
    for (std::size_t k = 0; k < corners.size(); ++k) element.nodes[k] = n[corners[k]];
    return volume_of(mesh, element);
  };
  EXPECT_NEAR(volume(results::ElementShape::wedge6, {0, 1, 2, 4, 5, 6}), 4, 1e-14);
  EXPECT_NEAR(volume(results::ElementShape::tetra4, {0, 1, 2, 5}), 8.0 / 6, 1e-14);
  EXPECT_NEAR(volume(results::ElementShape::pyramid5, {0, 1, 2, 3, 4}), 8.0 / 3, 1e-14);
}

}  // namespace
}  // namespace diefill::process
