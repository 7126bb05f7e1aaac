// Stretches of a surface: every triangle is in one, in order, and what is taken from them is taken in order.
#include "geometry/solid/surface_stretches.h"

#include <gtest/gtest.h>

#include <numeric>

#include "geometry/mesh/topology.h"
#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

Facets facets_of(const Mesh& mesh) {
  return find_facets(mesh, find_topology(mesh));
}

/// Facets of two thousand triangles each, and many of one.
Mesh ball_beside_a_plate(int levels) {
  return sample::joined(sample::sphere(0.003, levels), sample::cylinder(0.02, 0.001, 3000));
}

TEST(Stretches, HoldEveryTriangleOnceInOrder) {
  for (const int levels : {0, 3, 5}) {
    SCOPED_TRACE(levels);
    const Mesh mesh = ball_beside_a_plate(levels);
    const Facets facets = facets_of(mesh);
    std::vector<std::uint32_t> expected, met;
    for (const Facet& facet : facets)
      expected.insert(expected.end(), facet.triangles.begin(), facet.triangles.end());
    std::size_t whole = 0, longest = 0;
    for (const Stretch& stretch : stretches_of(facets)) {
      const std::size_t before = met.size();
      visit_facets(facets, stretch, [&](std::size_t f, std::size_t begin, std::size_t end, bool last) {
        met.insert(met.end(), facets[f].triangles.begin() + static_cast<std::ptrdiff_t>(begin),
                   facets[f].triangles.begin() + static_cast<std::ptrdiff_t>(end));
        whole += last;
      });
      longest = std::max(longest, met.size() - before);
    }
    EXPECT_EQ(met, expected);
    EXPECT_EQ(whole, facets.size());
    EXPECT_LE(longest, mesh.triangles.size() / 250);
  }
}

TEST(Stretches, AreTakenInOrderAndNeverWhileOthersWork) {
  const Facets facets = facets_of(sample::sphere(0.003, 4));
  const auto stretches = stretches_of(facets);
  std::vector<std::size_t> taken;
  std::size_t sum = 0;
  work_and_take(
      stretches,
      [&](const Stretch& stretch) {
        // What was taken is the same for all that work: the thread sanitizer sees a race if it is not.
        return std::pair(stretch.first_facet, taken.size());
      },
      [&](const std::pair<std::size_t, std::size_t>& result) {
        EXPECT_LE(result.second, taken.size());
        taken.push_back(result.first);
        sum += result.second;
      });
  ASSERT_EQ(taken.size(), stretches.size());
  EXPECT_TRUE(std::is_sorted(taken.begin(), taken.end()));
  EXPECT_GT(sum, 0U);
}

}  // namespace
}  // namespace diefill::geometry
