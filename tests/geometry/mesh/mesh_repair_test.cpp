// Repairs: what is done without guessing, what is refused, and that nothing is done in silence.
#include "geometry/mesh/mesh_repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

RepairedMesh repaired(const Mesh& mesh, RepairLevel level = RepairLevel::kSafe) {
  RepairOptions options;
  options.level = level;
  return repair_mesh(mesh, check_mesh(mesh), options);
}

void expect_repaired(const Mesh& broken, double volume, const std::string& words) {
  ASSERT_FALSE(check_mesh(broken).usable());
  const RepairedMesh result = repaired(broken);
  EXPECT_TRUE(result.findings.usable())
      << testing::PrintToString(result.findings.description()) << testing::PrintToString(result.refused);
  EXPECT_NEAR(result.mesh.volume(), volume, 1e-5 * volume);
  const std::string all = testing::PrintToString(result.repairs);
  EXPECT_NE(all.find(words), std::string::npos) << all;
  EXPECT_EQ(result.largest_deviation, 0);
}

void expect_refused(const Mesh& broken, const std::string& words) {
  const RepairedMesh result = repaired(broken);
  EXPECT_FALSE(result.findings.usable());
  EXPECT_TRUE(result.repairs.empty());
  EXPECT_EQ(result.mesh.triangles.size(), broken.triangles.size());
  const std::string all = testing::PrintToString(result.refused);
  EXPECT_NE(all.find(words), std::string::npos) << all;
}

Mesh soup_of(const Mesh& mesh) {
  Mesh soup;
  for (const auto& triangle : mesh.triangles) {
    const int first = static_cast<int>(soup.vertices.size());
    for (int k = 0; k < 3; ++k) soup.vertices.push_back(mesh.vertices[static_cast<std::size_t>(triangle[k])]);
    soup.triangles.emplace_back(first, first + 1, first + 2);
  }
  return soup;
}

const Mesh& tube() {
  static const Mesh mesh = sample::tube(8e-3, 12e-3, 10e-3, 90);
  return mesh;
}

TEST(MeshRepair, LeavesGoodMeshesAlone) {
  const RepairedMesh result = repaired(tube());
  EXPECT_TRUE(result.repairs.empty());
  EXPECT_TRUE(result.mesh.vertices == tube().vertices);
  EXPECT_TRUE(result.mesh.triangles == tube().triangles);
}

TEST(MeshRepair, OfFacetsThatFaceBothWaysTheFirstIsKept) {
  const Mesh both = sample::joined(tube(), sample::inside_out(tube()));
  ASSERT_NEAR(both.volume(), 0, 1e-12);
  const RepairedMesh result = repaired(both);
  EXPECT_TRUE(result.findings.usable());
  EXPECT_NEAR(result.mesh.volume(), tube().volume(), 1e-12);
  EXPECT_EQ(result.repairs.size(), 1U);
}

TEST(MeshRepair, FillsASmallHole) {
  Mesh mesh = tube();
  mesh.triangles.erase(mesh.triangles.begin() + 40);
  expect_repaired(mesh, tube().volume(), "a hole of ");
}

TEST(MeshRepair, FillsHolesThatTouchAtACorner) {
  const Mesh whole = sample::cylinder(0.01, 0.01, 90);
  Mesh mesh = whole;
  // Two triangles of an end, which is a fan, have only its hub in common.
  const auto of_the_end = [&](const Eigen::Vector3i& triangle) {
    return mesh.vertices[static_cast<std::size_t>(triangle[0])].z() == 0.01 &&
           mesh.vertices[static_cast<std::size_t>(triangle[1])].z() == 0.01 &&
           mesh.vertices[static_cast<std::size_t>(triangle[2])].z() == 0.01;
  };
  for (const int apart : {0, 10}) {
    auto found = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), of_the_end);
    for (int k = 0; k < apart; ++k) found = std::find_if(found + 1, mesh.triangles.end(), of_the_end);
    mesh.triangles.erase(found);
  }
  ASSERT_EQ(check_mesh(mesh).open_edges, 6U);
  expect_repaired(mesh, whole.volume(), "a hole of 3.49 mm2 filled");
}

TEST(MeshRepair, RefusesToCloseWhatMayBeAnOpening) {
  Mesh mesh = sample::box({0, 0, 0}, {0.01, 0.02, 0.03});
  mesh.triangles.resize(10);  // one face is missing
  expect_refused(mesh, "may be an opening");
}

TEST(MeshRepair, TurnsFlippedTriangles) {
  Mesh mesh = tube();
  for (const std::size_t t : {3U, 4U, 100U}) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  expect_repaired(mesh, tube().volume(), "neighbours agree on the outside");
}

TEST(MeshRepair, TurnsAMeshRightSideOut) {
  expect_repaired(sample::inside_out(tube()), tube().volume(), "point outward");
}

TEST(MeshRepair, TurnsAShellInsideAnotherOnceBothPointOutward) {
  const Mesh outer = sample::box({0, 0, 0}, {0.02, 0.02, 0.02}),
             inner = sample::box({0.005, 0.005, 0.005}, {0.01, 0.01, 0.01});
  expect_repaired(sample::inside_out(sample::joined(outer, inner)), outer.volume() - inner.volume(),
                  "inner shells bound cavities");
}

TEST(MeshRepair, TurnsOneOfTwoShells) {
  const Mesh far = sample::box({0.03, 0, 0}, {0.04, 0.01, 0.01});
  expect_repaired(sample::joined(tube(), sample::inside_out(far)), tube().volume() + far.volume(),
                  "1 shell reversed");
}

TEST(MeshRepair, WeldsCornersThatHardlyMiss) {
  Mesh mesh = soup_of(tube());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    mesh.vertices[v].z() += 2e-8 * static_cast<double>(v % 3);
  expect_repaired(mesh, tube().volume(), "welded to a neighbour at most 4e-05 mm away");
}

TEST(MeshRepair, DropsDuplicatesOfAHoledMesh) {
  Mesh mesh = tube();
  mesh.triangles.push_back(mesh.triangles[7]);
  mesh.triangles.erase(mesh.triangles.begin() + 40);
  expect_repaired(mesh, tube().volume(), "1 duplicate triangle removed");
}

TEST(MeshRepair, UnitesOverlappingShells) {
  const Mesh one = sample::box({0, 0, 0}, {0.01, 0.01, 0.01});
  const Mesh other = sample::box({0.005, 0.0022, 0.0031}, {0.02, 0.0072, 0.0081});
  expect_repaired(sample::joined(one, other), 1e-6 + 0.01 * 0.005 * 0.005, "2 shells that overlap united");
}

TEST(MeshRepair, RefusesASurfaceThatPassesThroughItself) {
  Mesh mesh = sample::prism({{0, 0}, {0.01, 0.01}, {0.01, 0}, {0, 0.01}}, {0.005, 0.005}, 0.01);
  expect_refused(mesh, "a surface that intersects itself");
}

TEST(MeshRepair, RefusesSolidsThatTouchAlongAnEdge) {
  const Mesh one = sample::box({0, 0, 0}, {0.01, 0.01, 0.01});
  const Mesh other = sample::box({0.01, 0.01, 0}, {0.02, 0.02, 0.01});
  const Mesh both = sample::joined(one, other);
  ASSERT_EQ(check_mesh(both).non_manifold_edges, 1U);
  EXPECT_FALSE(repaired(both).findings.usable());
  EXPECT_FALSE(repaired(both).refused.empty());
}

TEST(MeshRepair, SplitsAnEdgeOnWhichACornerOfTheNeighbourLies) {
  Mesh mesh = sample::box({0, 0, 0}, {0.01, 0.02, 0.03});
  // One of the two triangles at an edge gets a corner in the middle of it, the other does not.
  const Eigen::Vector3i old = mesh.triangles[4];
  const auto place = [&](int k) { return mesh.vertices[static_cast<std::size_t>(old[k])]; };
  mesh.vertices.push_back((2 * place(0) + place(1)) / 3);
  const int middle = static_cast<int>(mesh.vertices.size()) - 1;
  mesh.triangles[4] = {old[0], middle, old[2]};
  mesh.triangles.emplace_back(middle, old[1], old[2]);
  expect_repaired(mesh, 6e-6, "1 edge split where a corner of a neighbour lies on it");
}

TEST(MeshRepair, TakesTheWallBetweenBoxesThatShareAFaceAway) {
  const Mesh one = sample::box({0, 0, 0}, {0.01, 0.01, 0.01});
  Mesh other = one;
  for (auto& vertex : other.vertices) vertex.x() = 0.02 - vertex.x();
  const Mesh both = soup_of(sample::joined(one, sample::inside_out(other)));
  expect_repaired(both, 2e-6, "2 pairs of triangles between solids that share a face removed");
}

TEST(MeshRepair, UnitesBoxesWhoseSharedFacesAreCutUpOtherwise) {
  const Mesh one = sample::box({0, 0, 0}, {0.01, 0.01, 0.01});
  const Mesh other = sample::box({0.01, 0, 0}, {0.02, 0.01, 0.01});
  EXPECT_TRUE(repaired(soup_of(sample::joined(one, other))).findings.usable());
  const Mesh higher = sample::box({0.01, 0, 0}, {0.02, 0.01, 0.02});
  const RepairedMesh step = repaired(sample::joined(one, higher));
  ASSERT_TRUE(step.findings.usable()) << testing::PrintToString(step.refused);
  EXPECT_NEAR(step.mesh.volume(), 3e-6, 1e-11);
  expect_repaired(sample::inside_out(soup_of(sample::joined(one, other))), 2e-6, "point outward");
}

TEST(MeshRepair, WrapsOnlyWhenAllowedAndStatesTheDeviation) {
  Mesh mesh = sample::box({0, 0, 0}, {0.01, 0.02, 0.03});
  mesh.triangles.resize(11);
  const RepairedMesh result = repaired(mesh, RepairLevel::kWrap);
  ASSERT_TRUE(result.findings.usable());
  ASSERT_EQ(result.repairs.size(), 1U);
  EXPECT_NE(result.repairs[0].find("largest deviation"), std::string::npos);
  EXPECT_GT(result.largest_deviation, 0);
  EXPECT_TRUE(repaired(mesh, RepairLevel::kOff).repairs.empty());
  EXPECT_FALSE(repaired(mesh, RepairLevel::kOff).findings.usable());
}

TEST(MeshRepair, NothingIsTriedOnNumbersThatAreNone) {
  Mesh mesh = tube();
  mesh.vertices[5].x() = std::nan("");
  EXPECT_TRUE(repaired(mesh, RepairLevel::kWrap).repairs.empty());
}

}  // namespace
}  // namespace diefill::geometry
