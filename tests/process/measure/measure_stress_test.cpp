// Smooth stress against powders whose stress is known.
#include <gtest/gtest.h>

#include <random>

#include "process/measure/fields/stress_field.h"
#include "tests/process/measure_sample.h"

namespace diefill::process {
namespace {

constexpr double kWidth = 1e-3;  // m, sigma

/// A block of grains in which contacts carry `stress` (Pa, diagonal) at each place.
results::FillResult stressed_block(const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& stress) {
  results::FillResult result;
  result.powder = powder_of(block(13, kDiameter));
  result.solid_fraction = fraction_of(result.powder, [](const auto&) { return 0.5; });
  for (std::size_t k = 0; k < result.powder.position.size(); ++k) {
    result.contact_stress.normal.push_back(result.solid_fraction.cell_volume[k] *
                                           stress(result.powder.position[k]));
    result.contact_stress.shear.emplace_back(0, 0, 0);
  }
  return result;
}

TEST(StressField, GivesBackAnEvenStress) {
  const auto result = stressed_block([](const auto&) { return Eigen::Vector3d(-100, -200, -600); });
  const StressField field(result, kWidth);
  for (const auto& place : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1e-3, -5e-4, 2e-3)}) {
    EXPECT_NEAR(field.pressure(place), 300, 1e-9);
    EXPECT_NEAR(field.vertical(place), 600, 1e-9);
  }
  EXPECT_TRUE(std::isnan(field.pressure({0.1, 0, 0})));
}

TEST(StressField, LeavesOutOpenCells) {
  auto result = stressed_block([](const auto&) { return Eigen::Vector3d(-100, -100, -100); });
  for (std::size_t k = 0; k < result.powder.position.size(); k += 3) {
    result.solid_fraction.open[k] = 1;
    result.solid_fraction.cell_volume[k] = 1;
    result.contact_stress.normal[k].setConstant(-1e6);
  }
  EXPECT_NEAR(StressField(result, kWidth).pressure(Eigen::Vector3d::Zero()), 100, 1e-9);
}

TEST(StressField, GrainsThatFlyTogetherPressOnNothing) {
  auto result = stressed_block([](const auto&) { return Eigen::Vector3d::Zero().eval(); });
  for (auto& velocity : result.powder.velocity) velocity = {3, -1, 2};
  EXPECT_NEAR(StressField(result, kWidth).pressure(Eigen::Vector3d::Zero()), 0, 1e-9);
}

TEST(StressField, AgitatedGrainsPressAsAGasDoes) {
  auto result = stressed_block([](const auto&) { return Eigen::Vector3d::Zero().eval(); });
  constexpr double kSpeed = 0.3;  // m/s, along each axis, in both directions
  std::mt19937_64 random(3);
  for (auto& velocity : result.powder.velocity)
    for (int axis = 0; axis < 3; ++axis) velocity[axis] = random() % 2 == 0 ? kSpeed : -kSpeed;
  const double mass = result.powder.grain_mass, volume = result.solid_fraction.cell_volume[0];
  const double gas = mass * kSpeed * kSpeed / volume;
  EXPECT_NEAR(StressField(result, kWidth).pressure(Eigen::Vector3d::Zero()), gas, 0.05 * gas);
}

// Of independent velocities, whether nine grains or many make up the mean velocity around each.
TEST(StressField, KineticStressIsThatOfIndependentVelocitiesAtAnyWidth) {
  auto powder = powder_of(block(13, kDiameter));
  std::mt19937_64 random(5);
  std::normal_distribution<double> speed(0, 0.3);  // m/s
  for (auto& velocity : powder.velocity) velocity = {1 + speed(random), speed(random), speed(random)};
  for (const double width : {0.5 * kDiameter, kDiameter, 2 * kDiameter}) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& stress : motion_stress_times_volume(powder, width))
      mean -= stress / (powder.grain_mass * static_cast<double>(powder.position.size()));
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(mean[axis], 0.09, 0.1 * 0.09) << width;
  }
}

TEST(StressField, AGrainWithoutNeighboursHasNoKineticStress) {
  auto powder = powder_of({{0, 0, 0}, {0.1, 0, 0}});
  powder.velocity = {{1, 2, 3}, {-1, 0, 0}};
  for (const auto& stress : motion_stress_times_volume(powder, kWidth)) EXPECT_EQ(stress.norm(), 0);
  powder.period = {0.1, 0.1, 0};  // its own images do not count, the other grain's do
  powder.position[1] = {0.0995, 0, 0};
  EXPECT_NEAR(motion_stress_times_volume(powder, kWidth)[0].x(), -powder.grain_mass * 4 / 2, 1e-18);
}

TEST(StressField, SaysThatOlderResultsHoldNone) {
  auto result = stressed_block([](const auto&) { return Eigen::Vector3d::Zero().eval(); });
  result.contact_stress = {};
  EXPECT_THROW(StressField(result, kWidth), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::process
