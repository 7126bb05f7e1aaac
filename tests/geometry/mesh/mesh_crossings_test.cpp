// Crossing triangles of meshes that are searched in several slabs.
#include "geometry/mesh/mesh_crossings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

constexpr std::size_t kBoxes =
    6000;  // of 12 triangles: more than a slab of 50,000, and fewer than 100,000 crossings
constexpr double kEdge = 1e-3, kStep = 2e-3;

/// A bar along x that pierces boxes from number `first` on.
Mesh pierced_boxes(std::size_t first, std::size_t count) {
  Mesh mesh = sample::box({-kStep, 0.3 * kEdge, 0.3 * kEdge},
                          {(static_cast<double>(kBoxes) + 1) * kStep, 0.6 * kEdge, 0.6 * kEdge});
  const Mesh box = sample::box({0, 0, 0}, {kEdge, kEdge, kEdge});
  for (std::size_t k = first; k < first + count; ++k) {
    const Eigen::Vector3i offset = Eigen::Vector3i::Constant(static_cast<int>(mesh.vertices.size()));
    for (const auto& vertex : box.vertices)
      mesh.vertices.push_back(vertex + Eigen::Vector3d(static_cast<double>(k) * kStep, 0, 0));
    for (const auto& triangle : box.triangles) mesh.triangles.push_back(triangle + offset);
  }
  return mesh;
}

std::vector<std::pair<std::size_t, std::size_t>> crossings_of(const Mesh& mesh) {
  return find_crossings(mesh, std::vector<std::uint8_t>(mesh.triangles.size(), 0));
}

TEST(MeshCrossings, AreEachFoundOnceHoweverManySlabsTheirTrianglesReachInto) {
  const auto all = crossings_of(pierced_boxes(0, kBoxes));
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
  EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
  // One box at a time is one slab.
  std::vector<std::pair<std::size_t, std::size_t>> expected;
  for (std::size_t k = 0; k < kBoxes; ++k)
    for (const auto& [bar, box] : crossings_of(pierced_boxes(k, 1))) expected.emplace_back(bar, box + 12 * k);
  std::sort(expected.begin(), expected.end());
  EXPECT_GT(expected.size(), 8 * kBoxes);
  EXPECT_EQ(all, expected);
}

TEST(MeshCrossings, OfTrianglesLeftOutAreNone) {
  const Mesh mesh = pierced_boxes(0, 20);
  std::vector<std::uint8_t> left_out(mesh.triangles.size(), 0);
  std::fill_n(left_out.begin(), 12, 1);  // the bar
  EXPECT_TRUE(find_crossings(mesh, left_out).empty());
}

}  // namespace
}  // namespace diefill::geometry
