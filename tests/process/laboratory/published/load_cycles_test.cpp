// Beds pressed in cycles: what is read off their curves, and the beds themselves.
#include "process/laboratory/published/lactose/load_cycles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "process/laboratory/published/bed_window.h"
#include "process/laboratory/published/lactose/adhesive_bed.h"

namespace diefill::process::laboratory {
namespace {

/// Adds rows from the last place to `height`, with the load on a straight line to `stress`.
void go_to(LoadCurve& curve, double height, double stress) {
  constexpr int kRows = 200;
  const double from = curve.height.back(), load = curve.stress.back();
  for (int n = 1; n <= kRows; ++n) {
    curve.height.push_back(from + (height - from) * n / kRows);
    curve.stress.push_back(load + (stress - load) * n / kRows);
  }
}

TEST(LoadCycles, ChordsOfAKnownCurve) {
  LoadCurve curve;
  curve.height = {1.25e-3}, curve.stress = {50};
  go_to(curve, 1e-3, 15e3);
  // Unloads with 3 MPa and loads again with 2 MPa to the half load, over h_1, then steeper to where it was.
  for (int cycle = 0; cycle < 5; ++cycle) {
    go_to(curve, 1e-3 * (1 + 14.5e3 / 3e6), 500);
    go_to(curve, 1e-3 * (1 + 14.5e3 / 3e6 - 7e3 / 2e6), 7.5e3);
    go_to(curve, 1e-3, 15e3);
  }
  const Stiffness found = stiffness_of(curve, {});
  EXPECT_NEAR(found.beta, 0.2, 0.003);
  EXPECT_NEAR(found.unloading, 3e6, 0.03e6);
  EXPECT_NEAR(found.loading, 2e6, 0.02e6);
}

/// Rows are means over a time: 525 Pa for 500 Pa that was reached for an instant, 14.7 kPa for 15 kPa.
TEST(LoadCycles, CountWhereNoRowShowsTheLoadItself) {
  LoadCurve curve;
  curve.height = {1.25e-3}, curve.stress = {50};
  go_to(curve, 1e-3, 15e3);
  for (int cycle = 0; cycle < 5; ++cycle) {
    go_to(curve, 1e-3 * (1 + 14.475e3 / 3e6), 525);
    go_to(curve, 1e-3 * (1 + 14.475e3 / 3e6 - 6.975e3 / 2e6), 7.5e3);
    go_to(curve, 1e-3, 14.75e3);
  }
  const Stiffness found = stiffness_of(curve, {});
  EXPECT_NEAR(found.unloading, 3e6, 0.1e6);
  EXPECT_NEAR(found.loading, 2e6, 0.02e6);
}

TEST(LoadCycles, ACurveThatEndsTooSoonHasNoStiffness) {
  LoadCurve curve;
  curve.height = {1.25e-3}, curve.stress = {50};
  EXPECT_TRUE(std::isnan(stiffness_of(curve, {}).beta));
  go_to(curve, 1e-3, 15e3);
  go_to(curve, 1.01e-3, 500);
  const Stiffness found = stiffness_of(curve, {});
  EXPECT_NEAR(found.beta, 0.2, 0.003);
  EXPECT_TRUE(std::isnan(found.loading));
}

TEST(LoadCycles, TensionIsThePeakLessWhatStaysOnThePlate) {
  PullCurve curve;
  for (int n = 0; n <= 1000; ++n) {
    const double travel = 1e-6 * n;
    curve.travel.push_back(travel);
    // Rises to 1 N beside 0.2 N of weight, and falls in a straight line.
    curve.pull.push_back(0.2 + (n <= 100 ? n / 100.0 : std::max(0.0, 1 - (n - 100) / 400.0)));
  }
  const Tension tension = tension_of(curve);
  EXPECT_NEAR(tension.strength, 1, 1e-12);
  EXPECT_NEAR(tension.fracture, 360e-6, 2e-6);
  EXPECT_TRUE(std::isnan(tension_of({}).strength));
}

TEST(AdhesiveBed, StiffnessAndDampingAreThoseOfTheSource) {
  const AdhesivePowder coarse = lh100(), fine = lh220();
  EXPECT_NEAR(coarse.loading_stiffness(), 151, 0.5);
  EXPECT_NEAR(fine.loading_stiffness(), 28.0, 0.05);
  // A linear spring with this dashpot rebounds with e: its logarithmic decrement.
  const double mass = 0.5 * coarse.mass(), k = coarse.loading_stiffness(), c = coarse.damping();
  const double share = c / (2 * std::sqrt(mass * k));
  EXPECT_NEAR(std::exp(-std::numbers::pi * share / std::sqrt(1 - share * share)), coarse.restitution, 1e-12);
}

TEST(AdhesiveBed, SpheresOfClustersStopBeforeTheyStickAndThoseOfMotionDoNot) {
  AdhesiveBed bed;
  EXPECT_NE(packed_bed_lines(lh100(), bed).find("step.stick.at_rest = true\n"), std::string::npos);
  bed.packing = Packing::motion;
  EXPECT_NE(packed_bed_lines(lh100(), bed).find("step.stick.at_rest = false\n"), std::string::npos);
}

TEST(AdhesiveBed, FractionCountsTheCutSpheres) {
  results::PowderState powder;
  powder.grain_diameter = 2, powder.sphere_radius = 1;
  powder.period = {2, 2, 0};
  for (int n = 0; n < 10; ++n) powder.position.push_back({0, 0, 1.0 + 2 * n});
  // A sphere in a box that touches it.
  EXPECT_NEAR(fraction_between(powder, 4, 10), std::numbers::pi / 6, 1e-12);
  EXPECT_NEAR(fraction_between(powder, 5, 9), std::numbers::pi / 6, 1e-12);
  EXPECT_DOUBLE_EQ(surface_of(powder), 16);  // of the highest five
}

}  // namespace
}  // namespace diefill::process::laboratory
