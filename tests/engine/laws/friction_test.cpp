// Coulomb friction with a tangential spring (Bierwisch 2009, Eq. 2.7): the law itself, and grains that stick
// to or slide on a tilted plane.
#include <gtest/gtest.h>

#include "engine/laws/tangential_spring.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

constexpr double kTangential = 78, kFriction = 0.5, kEffectiveRadius = 3.92e-5, kOverlap = 4e-7;
constexpr double kLoad = 1e-5, kStep = 1e-6;
const Eigen::Vector3d kNormal = Eigen::Vector3d::UnitZ();

double stiffness() {
  return kTangential * std::sqrt(kOverlap / kEffectiveRadius);
}

/// Drags a contact along x at `speed` (m/s) for `steps`; returns the last force along x.
template <bool kCutBack>
double drag(Eigen::Vector3d& spring, double speed, int steps) {
  const laws::TangentialSpring<kCutBack> law(kTangential, kFriction, kEffectiveRadius);
  Vector3 force;
  for (int k = 0; k < steps; ++k)
    force = law.force(spring.data(), plain(kNormal), {speed, 0, 0}, std::sqrt(kOverlap), kLoad, kStep);
  return force.x;
}

TEST(Friction, SpringIsLinearUpToCoulombsLimit) {
  Eigen::Vector3d spring = Eigen::Vector3d::Zero();
  const double limit_length = kFriction * kLoad / stiffness();
  const double speed = limit_length / (10 * kStep);
  EXPECT_NEAR(drag<true>(spring, speed, 5), -0.5 * kFriction * kLoad, 1e-12 * kLoad);
  EXPECT_NEAR(drag<true>(spring, speed, 100), -kFriction * kLoad, 1e-12 * kLoad);
}

TEST(Friction, CutBackSpringAnswersAReversalAtOnce) {
  Eigen::Vector3d spring = Eigen::Vector3d::Zero();
  const double limit_length = kFriction * kLoad / stiffness();
  const double speed = limit_length / (10 * kStep);
  drag<true>(spring, speed, 100);
  EXPECT_NEAR(spring.norm(), limit_length, 1e-9 * limit_length);
  EXPECT_NEAR(drag<true>(spring, -speed, 10), 0, 1e-9 * kFriction * kLoad);
  EXPECT_NEAR(drag<true>(spring, -speed, 10), kFriction * kLoad, 1e-9 * kFriction * kLoad);
}

TEST(Friction, FreeSpringMustUnwindFirst) {
  Eigen::Vector3d spring = Eigen::Vector3d::Zero();
  const double limit_length = kFriction * kLoad / stiffness();
  const double speed = limit_length / (10 * kStep);
  EXPECT_NEAR(drag<false>(spring, speed, 100), -kFriction * kLoad, 1e-12 * kLoad);
  EXPECT_NEAR(spring.norm(), 10 * limit_length, 1e-9 * limit_length);
  EXPECT_NEAR(drag<false>(spring, -speed, 20), -kFriction * kLoad, 1e-12 * kLoad);
}

TEST(Friction, SpringTurnsWithTheContactAndKeepsItsLength) {
  const laws::TangentialSpring<true> law(kTangential, kFriction, kEffectiveRadius);
  const double length = 0.1 * kFriction * kLoad / stiffness();
  Eigen::Vector3d spring(length, 0, 0);
  const Eigen::Vector3d tilted = Eigen::Vector3d(0.6, 0, 0.8);
  const auto force =
      eigen(law.force(spring.data(), plain(tilted), Vector3{}, std::sqrt(kOverlap), kLoad, kStep));
  EXPECT_NEAR(spring.norm(), length, 1e-12 * length);
  EXPECT_NEAR(spring.dot(tilted), 0, 1e-12 * length);
  EXPECT_NEAR((force + stiffness() * spring).norm(), 0, 1e-12 * stiffness() * length);
}

constexpr double kWallFriction = 0.3;

/// Gravity turned by `slope` (tangent of the angle) towards +x.
Eigen::Vector3d tilted_gravity(double slope) {
  const double angle = std::atan(slope);
  return 9.81 * Eigen::Vector3d(std::sin(angle), 0, -std::cos(angle));
}

SimulationSettings on_incline(Model model, double slope) {
  auto settings = weightless(model, {}, 2e-6);
  settings.wall_contact.friction = kWallFriction;
  settings.gravity = tilted_gravity(slope);
  return settings;
}

/// A model A grain on a plane; m/s gained along the slope between 20 ms and 40 ms.
double speed_gained(double slope, SpringLimit limit) {
  auto settings = on_incline(Model::a, slope);
  settings.spring_limit = limit;
  Simulation simulation(settings, {plane_wall()});
  NewGrain grain;
  grain.position = {0, 0, settings.shape.sphere_radius - 4.4e-8};
  simulation.add_grains({grain});
  run_steps(simulation, 10000);
  const double before = velocity_of(simulation, 0).x();
  run_steps(simulation, 10000);
  return velocity_of(simulation, 0).x() - before;
}

TEST(Friction, SphereSlidesDownAsFastAsCoulombAllows) {
  const double slope = 1.1 * kWallFriction;
  const Eigen::Vector3d gravity = tilted_gravity(slope);
  const double expected = 0.02 * (gravity.x() + kWallFriction * gravity.z());
  EXPECT_NEAR(speed_gained(slope, SpringLimit::cut_back), expected, 1e-4 * expected);
  EXPECT_NEAR(speed_gained(slope, SpringLimit::free), expected, 1e-2 * expected);
}

TEST(Friction, SphereSticksBelowTheFrictionAngle) {
  const auto settings = on_incline(Model::a, 0.9 * kWallFriction);
  Simulation simulation(settings, {plane_wall()});
  NewGrain grain;
  grain.position = {0, 0, settings.shape.sphere_radius - 4.4e-8};
  simulation.add_grains({grain});
  // Once the first swing of the spring has been cut back at the limit, the grain swings about one place.
  run_steps(simulation, 10000);
  double low = 1, high = -1;
  for (int k = 0; k < 20000; ++k) {
    simulation.step();
    low = std::min(low, position_of(simulation, 0).x());
    high = std::max(high, position_of(simulation, 0).x());
  }
  const double load = settings.shape.mass * 9.81;
  const double overlap = simulation.deepest_overlap();
  const double give =
      load / (settings.wall_contact.tangential * std::sqrt(overlap / settings.shape.sphere_radius));
  EXPECT_LT(high - low, give);
}

/// A D grain on three arms: body axis (1, 1, 1) down, one arm pointing down the slope.
NewGrain tripod(const GrainShape& shape) {
  const Eigen::Vector3d down = Eigen::Vector3d::Ones().normalized();
  const Eigen::Vector3d foot = (Eigen::Vector3d::UnitX() - down.x() * down).normalized();
  Eigen::Matrix3d to_lab;
  to_lab.row(0) = foot;
  to_lab.row(2) = -down;
  to_lab.row(1) = to_lab.row(2).cross(to_lab.row(0));
  const Eigen::Quaterniond q(to_lab);
  NewGrain grain;
  grain.orientation = {q.w(), q.x(), q.y(), q.z()};
  grain.position.z() = shape.sphere_radius * (1 + 2 / std::sqrt(3.0)) - 2e-8;
  return grain;
}

class TripodOnIncline : public ::testing::TestWithParam<LeverArm> {};

TEST_P(TripodOnIncline, SlidesAboveTheFrictionAngleAndRestsBelow) {
  for (const double share : {0.85, 1.2}) {
    auto settings = on_incline(Model::d, share * kWallFriction);
    settings.lever_arm = GetParam();
    Simulation simulation(settings, {plane_wall()});
    simulation.add_grains({tripod(settings.shape)});
    run_steps(simulation, 10000);
    const double place = position_of(simulation, 0).x(), speed = velocity_of(simulation, 0).x();
    run_steps(simulation, 10000);
    if (share < 1) {
      EXPECT_LT(std::abs(position_of(simulation, 0).x() - place), 1e-3 * settings.shape.sphere_radius);
    } else {
      const double expected = 0.02 * (settings.gravity.x() + kWallFriction * settings.gravity.z());
      EXPECT_NEAR(velocity_of(simulation, 0).x() - speed, expected, 1e-2 * expected);
    }
    EXPECT_LT(simulation.angular_velocity(0).norm(), 1);
  }
}

INSTANTIATE_TEST_SUITE_P(BothLeverArms, TripodOnIncline,
                         ::testing::Values(LeverArm::center, LeverArm::contact));

}  // namespace
}  // namespace diefill::engine
