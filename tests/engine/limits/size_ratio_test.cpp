// How exactly a step resolves friction between grains of very unequal size.
#include <gtest/gtest.h>

#include "engine/limits/mix_time_step.h"
#include "tests/engine/mixed_support.h"

namespace diefill::engine {
namespace {

/// Velocity (m/s) and rim speed (m/s) of a grain after it has hit another.
struct After {
  Eigen::Vector3d velocity, rim;
};

GrainMix fine_on_large(double ratio) {
  laws::LawParameters law;
  law.normal = laws::HertzMindlinNormal::Parameters{.modulus = 5e6};
  law.damping = laws::RestitutionDamping::Parameters{.restitution = 0.7, .modulus = 5e6};
  law.friction =
      laws::MindlinFriction::Parameters{.shear_modulus = 1.1e6, .friction = 0.4, .restitution = 0.7};
  return mix_of({1, ratio}, law, law, law);
}

/// A grain comes down obliquely on a still one `ratio` times as large, with steps of `fraction` of the
/// critical one.
After bounce(double ratio, double fraction) {
  constexpr double kSpeed = 0.3;
  const auto mix = fine_on_large(ratio);
  auto settings = settings_of(mix, fraction * critical_time_step(mix, {}, kSpeed));
  Simulation simulation(settings, {});
  std::vector<NewGrain> grains(2);
  grains[0].position.z() = 1.001 * kMixRadius * (1 + ratio);
  grains[0].velocity = {0.7 * kSpeed, 0, -kSpeed};
  grains[0].angular_velocity = {0, -0.5 * kSpeed / kMixRadius, 0};
  grains[1].kind = 1;
  simulation.add_grains(grains);
  bool touched = false;
  for (int k = 0; k < 2000000; ++k) {
    simulation.step();
    touched = touched || simulation.touching_pairs() > 0;
    if (touched && simulation.touching_pairs() == 0) break;
  }
  return {velocity_of(simulation, 0), kMixRadius * simulation.angular_velocity(place_of(simulation, 0))};
}

/// Error of the velocities after the bounce over the speed of impact.
double error_at(double ratio, double fraction) {
  const After found = bounce(ratio, fraction), exact = bounce(ratio, 1e-3);
  return std::max((found.velocity - exact.velocity).norm(), (found.rim - exact.rim).norm()) / 0.3;
}

TEST(SizeRatio, ImpactOnALargeGrainIsResolvedAlikeAtAllRatios) {
  // Most of the error comes from the last step in touch, whose length in terms of the contact is the same. Of
  // the critical step, which friction's spring sets here, these are 0.2 and 0.05 of what the normal one
  // allows.
  constexpr double kCoarse = 0.2 / 0.5698, kFine = 0.05 / 0.5698;
  const double coarse = error_at(3, kCoarse), fine = error_at(3, kFine);
  EXPECT_LT(coarse, 0.12);
  EXPECT_LT(fine, 0.6 * coarse);
  EXPECT_LT(error_at(1, kCoarse), coarse);
  EXPECT_LT(error_at(3, 0.2), coarse);
  for (const double ratio : {10.0, 30.0, 100.0}) {
    EXPECT_NEAR(error_at(ratio, kCoarse), coarse, 0.05 * coarse) << ratio;
    EXPECT_NEAR(error_at(ratio, kFine), fine, 0.05 * fine) << ratio;
  }
}

/// How far (over its radius) a fine grain has come that two grains `ratio` times as large squeeze out from
/// between them, a quarter of their radius above the line of their centres, moving at each other at 0.1 m/s
/// for 7.5 ms.
double squeezed_out(double ratio, double fraction) {
  const auto mix = fine_on_large(ratio);
  auto settings = settings_of(mix, fraction * critical_time_step(mix, {}, 0.3));
  const double large = ratio * kMixRadius, height = 0.25 * large, reach = large + kMixRadius;
  const double apart = std::sqrt(reach * reach - height * height);
  std::vector<NewGrain> grains(3);
  grains[0].position.z() = height;
  for (const double side : {-1.0, 1.0}) {
    NewGrain& grain = grains[side < 0 ? 1 : 2];
    grain.kind = 1;
    grain.position.x() = side * apart;
    grain.velocity.x() = -side * 0.05;
  }
  Simulation simulation(settings, {});
  simulation.add_grains(grains);
  run_steps(simulation, static_cast<int>(std::lround(7.5e-3 / settings.time_step)));
  return (position_of(simulation, 0).z() - height) / kMixRadius;
}

TEST(SizeRatio, FineGrainIsSqueezedOutBetweenLargeOnesAsWithShortSteps) {
  for (const double ratio : {3.0, 10.0, 30.0}) {
    const double exact = squeezed_out(ratio, 0.02);
    EXPECT_GT(exact, 0.1) << ratio;
    EXPECT_NEAR(squeezed_out(ratio, 0.2), exact, 5e-3 * exact) << ratio;
  }
}

}  // namespace
}  // namespace diefill::engine
