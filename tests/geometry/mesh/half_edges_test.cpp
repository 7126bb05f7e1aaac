// Edges put together from the sides of triangles, and vertices told apart by their place.
#include "geometry/mesh/half_edges.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "geometry/mesh/equal_vertices.h"
#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

const auto kAll = [](std::size_t) { return true; };

TEST(HalfEdges, EveryEdgeOfAClosedMeshHasTwoSidesThatRunAgainstEachOther) {
  const Mesh mesh = sample::tube(8, 12, 10, 50);
  std::size_t edges = 0;
  HalfEdges(mesh, find_topology(mesh), kAll).visit_edges([&](std::size_t, std::span<const HalfEdge> sides) {
    ++edges;
    ASSERT_EQ(sides.size(), 2U);
    EXPECT_NE(sides[0].forward(), sides[1].forward());
    EXPECT_LT(sides[0].triangle(), sides[1].triangle());
  });
  EXPECT_EQ(2 * edges, 3 * mesh.triangles.size());
}

TEST(HalfEdges, AreThoseOfAMapInItsOrder) {
  const Mesh mesh = sample::tube(8, 12, 10, 20);
  const Topology topology = find_topology(mesh);
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::pair<std::size_t, int>>> expected;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 2)
    for (int k = 0; k < 3; ++k) {
      const auto from = topology.corner(mesh, t, k), to = topology.corner(mesh, t, (k + 1) % 3);
      expected[{std::min(from, to), std::max(from, to)}].emplace_back(t, k);
    }
  auto next = expected.begin();
  HalfEdges(mesh, topology, [](std::size_t t) {
    return t % 2 == 0;
  }).visit_edges([&](std::size_t low, std::span<const HalfEdge> sides) {
    ASSERT_NE(next, expected.end());
    EXPECT_EQ(static_cast<std::int64_t>(low), next->first.first);
    EXPECT_EQ(sides.front().high(), next->first.second);
    ASSERT_EQ(sides.size(), next->second.size());
    for (std::size_t k = 0; k < sides.size(); ++k) {
      EXPECT_EQ(sides[k].triangle(), next->second[k].first);
      EXPECT_EQ(sides[k].side(), next->second[k].second);
    }
    ++next;
  });
  EXPECT_EQ(next, expected.end());
}

TEST(EqualVertices, KeepsTheOrderOfFirstComing) {
  EqualVertices places;
  for (int round = 0; round < 2; ++round)
    for (int k = 0; k < 5000; ++k)
      EXPECT_EQ(places.add({0.1 * k, -1.0 * k, 1e-30 * k}), static_cast<std::uint32_t>(k));
  EXPECT_EQ(places.places().size(), 5000U);
}

TEST(EqualVertices, ZerosAreOneAndWhatIsNoNumberIsLikeItself) {
  EqualVertices places;
  EXPECT_EQ(places.add({0.0, 1, 2}), 0U);
  EXPECT_EQ(places.add({-0.0, 1, 2}), 0U);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(places.add({nan, 1, 2}), 1U);
  EXPECT_EQ(places.add({nan, 1, 2}), 1U);
  EXPECT_EQ(places.add({nan, 2, 1}), 2U);
}

}  // namespace
}  // namespace diefill::geometry
