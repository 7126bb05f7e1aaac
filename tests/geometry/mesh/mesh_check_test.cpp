// Every kind of bad mesh is found, counted and described; good ones pass without a message.
#include "geometry/mesh/mesh_check.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

const Eigen::Vector3d kZero = Eigen::Vector3d::Zero();

Mesh unit_box() {
  return sample::box(kZero, Eigen::Vector3d::Constant(0.01));
}

void expect_words(const MeshFindings& findings, const std::string& words) {
  std::string all;
  for (const std::string& line : findings.description()) all += line + "\n";
  EXPECT_NE(all.find(words), std::string::npos) << all;
  EXPECT_EQ(findings.description().size(), findings.places.size());
}

TEST(MeshCheck, PassesGoodSolidsWithoutAWord) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (const Mesh& mesh : {unit_box(), sample::tube(0.008, 0.012, 0.01, 90), sample::sphere(0.01, 4)}) {
    const MeshFindings findings = check_mesh(transformed(mesh, turn, Eigen::Vector3d(0.05, -0.02, 0.1)));
    EXPECT_TRUE(findings.usable());
    EXPECT_TRUE(findings.description().empty());
    EXPECT_EQ(findings.shells, 1U);
  }
}

TEST(MeshCheck, TakesAHollowInsideASolidAsOutward) {
  const Mesh hollow =
      sample::inside_out(sample::box(Eigen::Vector3d::Constant(0.003), Eigen::Vector3d::Constant(0.006)));
  const MeshFindings findings = check_mesh(sample::joined(unit_box(), hollow));
  EXPECT_TRUE(findings.usable());
  EXPECT_EQ(findings.shells, 2U);
}

TEST(MeshCheck, FindsTheHoleOfAnOpenBox) {
  Mesh mesh = unit_box();
  mesh.triangles.resize(10);  // the side x = 10 mm is gone
  const MeshFindings findings = check_mesh(mesh);
  EXPECT_EQ(findings.open_edges, 4U);
  EXPECT_FALSE(findings.usable());
  expect_words(findings, "4 open edges: the surface has a hole near (10.000, ");
}

TEST(MeshCheck, FindsATriangleTurnedOver) {
  Mesh mesh = unit_box();
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  const MeshFindings findings = check_mesh(mesh);
  EXPECT_EQ(findings.badly_oriented_edges, 3U);
  EXPECT_FALSE(findings.consistently_oriented);
  EXPECT_FALSE(findings.usable());
  expect_words(findings, "facing opposite ways");
}

TEST(MeshCheck, FindsASolidInsideOut) {
  const MeshFindings findings = check_mesh(sample::inside_out(unit_box()));
  EXPECT_TRUE(findings.consistently_oriented);
  EXPECT_FALSE(findings.outward);
  EXPECT_FALSE(findings.usable());
  expect_words(findings, "the whole surface is inside out");
}

TEST(MeshCheck, FindsOneOfTwoSolidsInsideOut) {
  const Mesh other =
      sample::inside_out(sample::box(Eigen::Vector3d(0.02, 0, 0), Eigen::Vector3d(0.021, 0.001, 0.001)));
  const MeshFindings findings = check_mesh(sample::joined(unit_box(), other));
  EXPECT_GT(findings.volume, 0);
  EXPECT_EQ(findings.inward_shells, 1U);
  EXPECT_FALSE(findings.usable());
}

TEST(MeshCheck, RemarksOnADuplicateTriangleButTakesTheSolid) {
  Mesh mesh = unit_box();
  mesh.triangles.push_back(mesh.triangles[3]);
  const MeshFindings findings = check_mesh(mesh);
  EXPECT_EQ(findings.duplicate_triangles, 1U);
  EXPECT_TRUE(findings.usable());
  expect_words(findings, "1 duplicate triangle");
}

TEST(MeshCheck, RemarksOnADegenerateTriangleButTakesTheSolid) {
  Mesh mesh = unit_box();
  // One side of the edge from corner 0 to corner 1 is split at its middle, the other is not; a sliver closes
  // it.
  mesh.vertices.emplace_back(0.005, 0, 0);
  mesh.triangles[4] = {0, 8, 5};
  mesh.triangles.emplace_back(8, 1, 5);
  mesh.triangles.emplace_back(0, 1, 8);
  const MeshFindings findings = check_mesh(mesh);
  EXPECT_EQ(findings.degenerate_triangles, 1U);
  EXPECT_EQ(findings.open_edges, 0U);
  EXPECT_TRUE(findings.usable());
  expect_words(findings, "1 triangle without area");
}

TEST(MeshCheck, FindsTwoCrossingBoxes) {
  const Mesh other = sample::box(Eigen::Vector3d::Constant(0.005), Eigen::Vector3d::Constant(0.015));
  const MeshFindings findings = check_mesh(sample::joined(unit_box(), other));
  EXPECT_GT(findings.self_intersections, 0U);
  EXPECT_FALSE(findings.usable());
  expect_words(findings, "the surface passes through itself");
}

TEST(MeshCheck, FindsAnEdgeWhereTwoBoxesTouch) {
  const Mesh other = sample::box({0.01, 0.01, 0}, {0.02, 0.02, 0.01});
  const MeshFindings findings = check_mesh(sample::joined(unit_box(), other));
  EXPECT_EQ(findings.non_manifold_edges, 1U);
  EXPECT_EQ(findings.self_intersections, 0U);
  EXPECT_FALSE(findings.usable());
  expect_words(findings, "touch along an edge near (10.000, 10.000, 5.000) mm");
}

TEST(MeshCheck, NeverThrowsForNonsense) {
  EXPECT_FALSE(check_mesh(Mesh{}).usable());
  EXPECT_EQ(check_mesh(Mesh{}).description().size(), 1U);
  Mesh mesh = unit_box();
  mesh.vertices[2].x() = std::numeric_limits<double>::quiet_NaN();
  expect_words(check_mesh(mesh), "invalid corner");
  mesh = unit_box();
  mesh.triangles[0][1] = 99;
  expect_words(check_mesh(mesh), "1 triangle with an invalid corner");
  mesh = unit_box();
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex.setZero();
  EXPECT_FALSE(check_mesh(mesh).usable());
}

}  // namespace
}  // namespace diefill::geometry
