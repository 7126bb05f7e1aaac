// The engine against the slow reference of reference_dem.h: the same small scenes through both.
#include <gtest/gtest.h>

#include "tests/engine/engine_test_support.h"
#include "tests/engine/reference_dem.h"

namespace diefill::engine {
namespace {

struct ReferenceCase {
  std::string name;
  Model model;
  LeverArm arm = LeverArm::center;
  SpringLimit limit = SpringLimit::cut_back;
  double work_of_adhesion = 0;
  double friction = 0.5;
  bool periodic = false;
};

/// A plate that slides and a paddle that turns about the y axis.
std::vector<WallBodySpec> moving_tools(double below) {
  const auto sliding = [below](double time) {
    BodyMotion motion;
    motion.velocity = {0.3, 0.1, 0};
    motion.translation = motion.velocity * time - Eigen::Vector3d(0, 0, below);
    return motion;
  };
  const auto turning = [below](double time) {
    BodyMotion motion;
    motion.angular_velocity = {0, 150, 0};
    motion.rotation = Eigen::AngleAxisd(150 * time, Eigen::Vector3d::UnitY()).toRotationMatrix();
    motion.translation = {-1.5 * below, 0, 0};
    return motion;
  };
  WallBodySpec paddle = plate(3e-4, 1e-4, turning);
  paddle.name = "paddle";
  return {plate(1.5e-3, 1.5e-4, sliding), paddle};
}

class Reference : public ::testing::TestWithParam<ReferenceCase> {};

TEST_P(Reference, EngineMovesGrainsAlike) {
  const auto& given = GetParam();
  auto settings = weightless(given.model,
                             {.friction = given.friction,
                              .work_of_adhesion = given.work_of_adhesion,
                              .rolling_friction = given.model == Model::b ? 3.75e-5 : 0},
                             1e-6);
  wall_contact(settings)->friction = given.friction == 0 ? 0 : 0.15;
  settings.gravity = {0, 0, -9.81};
  settings.air_viscosity = 2e-5;
  settings.lever_arm = given.arm;
  set_spring_limit(settings, given.limit);
  const double size = 2 * half_size(settings.shape());
  if (given.periodic) settings.period = {3.3 * size, 3.3 * size};
  const auto walls = moving_tools(1.45 * size);
  const auto cloud = converging_cloud({3, 3, 3}, 1.02 * size, 0.3, 42);

  Simulation simulation(settings, walls);
  simulation.add_grains(cloud);
  ReferenceDem reference(settings, walls);
  for (const auto& grain : cloud) reference.add(grain);
  PeriodicBox box(settings.period);
  double worst_place = 0, worst_speed = 0, worst_spin = 0;
  for (int k = 0; k < 400; ++k) {
    simulation.step();
    reference.step();
  }
  for (std::size_t id = 0; id < cloud.size(); ++id) {
    const auto& expected = reference.grains()[id];
    const std::size_t k = place_of(simulation, id);
    const Eigen::Vector3d apart = box.wrapped(simulation.grains().position[k] - expected.position);
    worst_place = std::max(worst_place, apart.norm() / size);
    worst_speed = std::max(worst_speed, (simulation.grains().velocity[k] - expected.velocity).norm() / 0.3);
    worst_spin = std::max(worst_spin, (simulation.grains().spin[k] - expected.spin).norm() * size / 0.3);
  }
  EXPECT_LT(worst_place, 1e-12);
  EXPECT_LT(worst_speed, 1e-10);
  EXPECT_LT(worst_spin, 1e-9);
  EXPECT_GT(simulation.touching_pairs(), 0U);
  EXPECT_GT(simulation.searches(), 2U);
  EXPECT_NE(simulation.ledger().wall_work, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Reference,
    ::testing::Values(
        ReferenceCase{"A", Model::a},
        ReferenceCase{"ACohesive", Model::a, LeverArm::center, SpringLimit::cut_back, 1e-2, 1},
        ReferenceCase{"B", Model::b},
        ReferenceCase{"BFreeSpring", Model::b, LeverArm::center, SpringLimit::free, 1e-3},
        ReferenceCase{"BPeriodic", Model::b, LeverArm::center, SpringLimit::cut_back, 0, 0.5, true},
        ReferenceCase{"CCenter", Model::c},
        ReferenceCase{"CContactCohesive", Model::c, LeverArm::contact, SpringLimit::cut_back, 0.2, 1},
        ReferenceCase{"DCenter", Model::d, LeverArm::center},
        ReferenceCase{"DContact", Model::d, LeverArm::contact},
        ReferenceCase{"DFrictionless", Model::d, LeverArm::contact, SpringLimit::cut_back, 0, 0},
        ReferenceCase{"DCenterFreeSpringCohesive", Model::d, LeverArm::center, SpringLimit::free, 0.01, 1},
        ReferenceCase{"DContactFreeSpringPeriodic", Model::d, LeverArm::contact, SpringLimit::free, 0, 0.5,
                      true},
        ReferenceCase{"DCenterCohesivePeriodic", Model::d, LeverArm::center, SpringLimit::cut_back, 0.15, 1,
                      true}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace diefill::engine
