#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "geometry/wall_spheres/wall_spheres.h"
#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

/// Part of a ball of small triangles, which lattices grow over, and of the tube round it, which grids cover.
WallSpheres spheres_on(int threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  const Mesh mesh = sample::joined(sample::sphere(0.002, 5), sample::tube(0.003, 0.005, 0.004, 50));
  WallSphereOptions some;
  some.radius = 1.5e-4;
  some.reachable = [](const Eigen::Vector3d& point, const Eigen::Vector3d&) { return point.x() < 0.001; };
  return make_wall_spheres(mesh, some);
}

TEST(WallSpheres, AreTheSameBitForBitOnAnyNumberOfThreads) {
  const WallSpheres one = spheres_on(1), four = spheres_on(4);
  EXPECT_GT(one.centres.size(), 1000U);
  EXPECT_EQ(one.centres, four.centres);
  EXPECT_EQ(one.mean_deviation, four.mean_deviation);
  EXPECT_EQ(one.largest_deviation_place, four.largest_deviation_place);
  EXPECT_EQ(one.largest_gap, four.largest_gap);
  EXPECT_EQ(one.largest_gap_place, four.largest_gap_place);
}

}  // namespace
}  // namespace diefill::geometry
