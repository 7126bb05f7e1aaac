// The STL files in sample_tools are usable and have the sizes that sample_tools/TOOLS.md lists.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "geometry/cad/mesh_import.h"
#include "geometry/mesh/mesh_check.h"
#include "project_paths.h"
#include "tests/geometry/sample_tool_files.h"

namespace diefill::geometry {
namespace {

constexpr double kRounding = 2e-8;  // m: STL files keep single precision

std::vector<std::filesystem::path> all_tools() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(DIEFILL_SOURCE_DIR "/sample_tools")) {
    if (entry.path().extension() == ".stl") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// m^3: what kRounding makes of the volume of a round wall.
double rounding(double radius, double height) {
  return kRounding * 2 * std::numbers::pi * radius * height;
}

// m^2, regular polygon of 256 corners on a circle.
double disc(double radius) {
  return 128 * std::sin(2 * std::numbers::pi / 256) * radius * radius;
}

void expect_box(const Mesh& mesh, const Eigen::Vector3d& lower_mm, const Eigen::Vector3d& upper_mm) {
  const Box box = mesh.bounding_box();
  EXPECT_LT((box.lower - lower_mm * 1e-3).cwiseAbs().maxCoeff(), kRounding) << box.lower.transpose();
  EXPECT_LT((box.upper - upper_mm * 1e-3).cwiseAbs().maxCoeff(), kRounding) << box.upper.transpose();
}

TEST(SampleTools, AreClosedOutwardSolids) {
  const auto files = all_tools();
  EXPECT_GE(files.size(), 30U);
  for (const auto& file : files) {
    const auto findings = check_mesh(import_mesh(file, 0.001));
    EXPECT_TRUE(findings.usable()) << file << ": " << testing::PrintToString(findings.description());
    // Slit plates and their shoe are pairs of solids in one file, as are punches of two cavities; the gear's
    // rods are five; a closed drum has an inner and an outer surface.
    const bool pair = file.parent_path().filename() == "slit_plate" || file.filename() == "pair_punch.stl" ||
                      file.filename() == "drum.stl";
    EXPECT_EQ(findings.shells, pair ? 2U : file.filename() == "core_rods.stl" ? 5U : 1U) << file;
  }
}

TEST(SampleTools, AreSmallFiles) {
  for (const auto& file : all_tools()) EXPECT_LT(std::filesystem::file_size(file), 1000000U) << file;
}

TEST(SampleTools, FacetsOfRoundWallsAreShort) {
  // The largest circle has a radius of 16 mm; rims are the edges along it.
  const Mesh die = sample::tool("wide_ring/die.stl");
  int rims = 0;
  for (const auto& triangle : die.triangles) {
    for (int i = 0; i < 3; ++i) {
      const auto& one = die.vertices[static_cast<std::size_t>(triangle[i])];
      const auto& other = die.vertices[static_cast<std::size_t>(triangle[(i + 1) % 3])];
      const bool on_circle =
          std::abs(one.head<2>().norm() - 0.016) < 1e-7 && std::abs(other.head<2>().norm() - 0.016) < 1e-7;
      if (!on_circle || one.z() != other.z() || (one - other).norm() > 1e-3) continue;
      ++rims;
      EXPECT_LT((one - other).norm(), 0.4e-3);
      EXPECT_LT(0.016 - ((one + other) / 2).head<2>().norm(), 1.3e-6);
    }
  }
  EXPECT_EQ(rims, 2 * 256 * 2);  // top and bottom rim, each edge seen from both of its triangles
}

TEST(SampleTools, ShoeOfTheSlitExperiments) {
  expect_box(sample::tool("shoe/shoe.stl"), {-19, -28, 0}, {19, 28, 37});
  expect_box(sample::tool("shoe/shoe_tall.stl"), {-19, -28, 0}, {19, 28, 46});
  EXPECT_NEAR(sample::tool("shoe/shoe.stl").volume(), (38 * 56 - 32 * 50) * 37e-9, 1e-13);
}

TEST(SampleTools, NarrowRingToolsFitIntoEachOther) {
  for (const auto& [name, width] : {std::pair{"0.47", 2.488e-3}, {"0.94", 3.146e-3}, {"1.88", 4.462e-3}}) {
    const Mesh die = sample::tool(std::string("narrow_ring/die_d") + name + ".stl");
    const Mesh punch = sample::tool(std::string("narrow_ring/punch_d") + name + ".stl");
    const double block = die.bounding_box().size().prod();
    EXPECT_NEAR(block - die.volume(), disc(8e-3 + width) * 25e-3, rounding(8e-3 + width, 25e-3)) << name;
    const double ring = disc(8e-3 + width - 0.02e-3) - disc(8e-3 + 0.02e-3);
    EXPECT_NEAR(punch.volume(), ring * 5e-3, rounding(16e-3 + width, 5e-3)) << name;
    EXPECT_NEAR(punch.bounding_box().upper.z(), -20e-3, kRounding);
    EXPECT_NEAR(die.bounding_box().upper.z(), 0, kRounding);
  }
  EXPECT_NEAR(sample::tool("narrow_ring/core_rod.stl").volume(), disc(8e-3) * 25e-3, rounding(8e-3, 25e-3));
}

TEST(SampleTools, SteppedDieHasBothBores) {
  const Mesh die = sample::tool("stepped_ring/die.stl");
  EXPECT_NEAR(die.bounding_box().size().prod() - die.volume(), disc(16e-3) * 10e-3 + disc(11.15e-3) * 15e-3,
              1e-12);
}

TEST(SampleTools, SlitPlatesMissExactlyTheirSlit) {
  for (const int slit : {6, 10}) {
    const Mesh plate = sample::tool("slit_plate/slit_" + std::to_string(slit) + "mm.stl");
    expect_box(plate, {-78, -20, -2}, {78, 20, 0});
    EXPECT_NEAR(plate.bounding_box().size().prod() - plate.volume(), slit * 40 * 2e-9, 1e-13);
  }
}

TEST(SampleTools, RectangularDieAndPunch) {
  expect_box(sample::tool("rectangular_die/die.stl"), {-58, -12, -20}, {58, 12, 0});
  expect_box(sample::tool("rectangular_die/punch.stl"), {-14.98, -5.98, -20}, {14.98, 5.98, -15});
}

}  // namespace
}  // namespace diefill::geometry
