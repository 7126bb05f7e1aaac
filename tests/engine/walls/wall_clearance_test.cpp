// How far a wall is from powder at least: never more than it is, and something where it is far.
#include "engine/walls/wall_clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace diefill::engine {
namespace {

constexpr double kReach = 1e-3;  // m

TEST(WallClearance, IsNeverMoreThanTheDistanceOfAnyPointFromAnyWallSphere) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto place = [&] { return Eigen::Vector3d(unit(random), unit(random), unit(random)); };
  int far = 0;
  for (int trial = 0; trial < 200; ++trial) {
    WallBodySpec spec;
    for (int k = 0; k < 30; ++k) spec.centres.push_back(0.01 * place());
    const WallBody body(spec, kReach);
    BodyMotion pose;
    pose.rotation = Eigen::AngleAxisd(3 * unit(random), place().normalized()).toRotationMatrix();
    pose.translation = 0.06 * place();
    Eigen::AlignedBox3d powder;
    for (int k = 0; k < 8; ++k) powder.extend(Eigen::Vector3d(0.005 * place()));
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& centre : body.centres())
      nearest = std::min(nearest, std::sqrt(powder.squaredExteriorDistance(pose.point(centre))));
    const double clearance = clearance_of(body, pose, powder, kReach);
    EXPECT_GE(clearance, 0);
    EXPECT_LE(clearance, std::max(0.0, nearest - kReach) + 1e-12);
    far += clearance > 0 ? 1 : 0;
  }
  EXPECT_GT(far, 100);
}

TEST(WallClearance, OfAPlaneIsNone) {
  WallBodySpec spec;
  spec.planes = {{{0, 0, -1}, {0, 0, 1}}};
  const Eigen::AlignedBox3d powder(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(1e-3));
  EXPECT_EQ(clearance_of(WallBody(std::move(spec), kReach), {}, powder, kReach), 0);
}

}  // namespace
}  // namespace diefill::engine
