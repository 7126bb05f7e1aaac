// The stress that contacts carry (Bierwisch 2009, Eq. 3.8), against forces and lever arms known otherwise.
#include "engine/observe/contact_stress.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine/observe/contact_forces.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

/// m: a plane at height `z`, powder above.
WallBodySpec floor_at(double z) {
  WallBodySpec floor;
  floor.name = "floor";
  floor.planes = {{{0, 0, z}, Eigen::Vector3d::UnitZ()}};
  return floor;
}

struct StressCase {
  const char* name;
  Model model;
  bool periodic, walls;
  int steps;  ///< until grains of the cloud touch
};

class ContactForces : public ::testing::TestWithParam<StressCase> {};

TEST_P(ContactForces, SumUpToTheForceOnEveryGrain) {
  // Undamped, so that forces do not depend on velocities, which have changed since they were computed.
  auto settings = weightless(
      GetParam().model,
      {.damping_over_radius = 0, .friction = 0.8, .work_of_adhesion = 0.05, .rolling_friction = 1e-5}, 1e-6);
  const double size = 2 * half_size(settings.shape());
  if (GetParam().periodic) settings.period[0] = 4 * size;
  std::vector<WallBodySpec> walls;
  if (GetParam().walls) {
    // Starts below the cloud and comes up to it.
    walls.push_back(floor_at(-2.1 * size));
    walls.back().motion = [](double time) {
      BodyMotion motion;
      motion.velocity = {0, 0, 0.5};
      motion.translation = motion.velocity * time;
      return motion;
    };
  }
  Simulation simulation(settings, walls);
  simulation.add_grains(converging_cloud({4, 4, 4}, size, 0.3, 8));
  run_steps(simulation, GetParam().steps);
  const auto& grains = simulation.grains();
  std::vector<Eigen::Vector3d> sum(grains.size(), Eigen::Vector3d::Zero());
  double largest = 0;
  std::size_t at_walls = 0;
  visit_contact_forces(simulation, [&](const ContactForce& contact) {
    sum[contact.grain] += contact.force;
    if (contact.other != kNoGrain) sum[contact.other] -= contact.force;
    at_walls += contact.other == kNoGrain;
    largest = std::max(largest, contact.force.norm());
    EXPECT_LT(contact.arm.norm(), half_size(settings.shape()));
    EXPECT_LT(contact.other_arm.norm(), half_size(settings.shape()));
  });
  ASSERT_GT(largest, 0);
  EXPECT_EQ(at_walls > 0, GetParam().walls);
  for (std::size_t k = 0; k < grains.size(); ++k)
    EXPECT_LT((sum[k] - grains.force[k]).norm(), 1e-12 * largest) << "grain " << k;
}

INSTANTIATE_TEST_SUITE_P(Clouds, ContactForces,
                         ::testing::Values(StressCase{"Spheres", Model::b, false, false, 250},
                                           StressCase{"ClumpsOverABorder", Model::d, true, false, 900},
                                           StressCase{"ClumpsOnAFloor", Model::d, false, true, 900}),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// N on grain 0 of two, from Hertz and damping (Bierwisch 2009, Eqs. 2.3, 2.6) between all their spheres as
/// they are and move now.
Eigen::Vector3d smooth_force(const Simulation& simulation) {
  const auto& settings = simulation.settings();
  const Grains& grains = simulation.grains();
  const double radius = settings.shape().sphere_radius, effective = 0.5 * radius;
  const auto place = [&](std::size_t k, const Eigen::Vector3d& offset) -> Eigen::Vector3d {
    return rotation_matrix(grains.orientation_of(k)) * offset;
  };
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& i : settings.shape().sphere_offsets)
    for (const auto& j : settings.shape().sphere_offsets) {
      const Eigen::Vector3d a = place(0, i), b = place(1, j);
      const Eigen::Vector3d apart = grains.position[0] + a - grains.position[1] - b;
      const double overlap = 2 * radius - apart.norm();
      if (overlap <= 0) continue;
      const Eigen::Vector3d normal = apart.normalized();
      // Both grains' velocities in the middle of the overlap.
      const Eigen::Vector3d arm = -(radius - 0.5 * overlap) * normal;
      const Eigen::Vector3d velocity = grains.velocity[0] + simulation.angular_velocity(0).cross(a + arm) -
                                       grains.velocity[1] - simulation.angular_velocity(1).cross(b - arm);
      const double elastic =
          2.0 / 3 * grain_contact(settings).reduced_modulus * std::sqrt(effective) * std::pow(overlap, 1.5);
      sum += (elastic -
              grain_contact(settings).damping * std::sqrt(effective * overlap) * velocity.dot(normal)) *
             normal;
    }
  return sum;
}

TEST(TwoGrains, PushEachOtherByTheVelocitiesThatTheyHaveNow) {
  for (const Model model : {Model::a, Model::d}) {
    const auto settings = weightless(model, {.damping_over_radius = 1e6, .friction = 0}, 1e-6);
    const double size = half_size(settings.shape());
    Simulation simulation(settings, {});
    simulation.add_grains({{.position = {0, 0, 0}, .velocity = {0.3, 0, 0}, .angular_velocity = {0, 0, 20}},
                           {.position = {2.1 * size, 0.2 * size, 0}, .velocity = {-0.3, 0, 0}}});
    std::size_t touched = 0;
    for (int step = 0; step < 2000 && touched < 50; ++step) {
      simulation.step();
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      visit_contact_forces(simulation, [&](const ContactForce& contact) {
        sum += contact.grain == 0 ? contact.force : Eigen::Vector3d(-contact.force);
      });
      const Eigen::Vector3d expected = smooth_force(simulation);
      EXPECT_LE((sum - expected).norm(), 1e-9 * expected.norm()) << static_cast<int>(model);
      touched += expected.norm() > 0;
    }
    EXPECT_EQ(touched, 50U);
  }
}

TEST(ContactStress, OfTwoPressedSpheresIsForceTimesDistanceToTheContactPlane) {
  auto settings = weightless(Model::a, {.damping_over_radius = 0}, 1e-9);
  const double radius = settings.shape().sphere_radius, overlap = 0.02 * radius;
  Simulation simulation(settings, {});
  simulation.add_grains({{.position = {0, 0, 0}}, {.position = {2 * radius - overlap, 0, 0}}});
  simulation.step();
  // Hertz, R_eff = R / 2 (Bierwisch 2009, Eq. 2.3).
  const double force =
      2.0 / 3 * grain_contact(settings).reduced_modulus * std::sqrt(0.5 * radius) * std::pow(overlap, 1.5);
  for (const auto& stress : contact_stress_times_volume(simulation)) {
    EXPECT_NEAR(stress(0, 0), -force * (radius - 0.5 * overlap), 1e-9 * force * radius);
    EXPECT_LT((stress - stress(0, 0) * Eigen::Vector3d::UnitX() * Eigen::RowVector3d::UnitX()).norm(),
              1e-9 * force * radius);
  }
}

TEST(ContactStress, OfAStackCarriesTheWeightAbove) {
  auto settings = weightless(Model::a, {}, 2e-6);
  settings.gravity = {0, 0, -9.81};
  settings.air_viscosity = 1e-2;  // to rest sooner
  const double radius = settings.shape().sphere_radius, weight = settings.shape().mass * 9.81;
  Simulation simulation(settings, {floor_at(0)});
  simulation.add_grains(
      {{.position = {0, 0, radius}}, {.position = {0, 0, 3 * radius}}, {.position = {0, 0, 5 * radius}}});
  run_steps(simulation, 200000);
  const auto stress = contact_stress_times_volume(simulation);
  std::array<double, 3> height;
  for (std::size_t k = 0; k < 3; ++k) height[k] = position_of(simulation, k).z();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto above = static_cast<double>(2 - k);
    const double to_top = k < 2 ? 0.5 * (height[k + 1] - height[k]) : 0;
    const double to_bottom = k > 0 ? 0.5 * (height[k] - height[k - 1]) : 0.5 * (radius + height[0]);
    EXPECT_NEAR(stress[place_of(simulation, k)](2, 2), -weight * (above * to_top + (above + 1) * to_bottom),
                1e-6 * weight * radius);
  }
}

}  // namespace
}  // namespace diefill::engine
