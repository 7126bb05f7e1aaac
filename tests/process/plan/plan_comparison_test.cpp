// What variants take together, compared with numbers by hand.
#include <gtest/gtest.h>

#include "process/plan/comparison_forecast.h"

namespace diefill::process::plan {
namespace {

/// 0.2 s that take 10 s, 0.5 s that take 100 s, nothing, 0.1 s that take 4 s.
Forecast three_phases() {
  Forecast forecast;
  const double phases[][2] = {{0.2, 10}, {0.5, 100}, {0, 0}, {0.1, 4}};
  for (const auto& [seconds, wall] : phases) {
    PhaseForecast part;
    part.phase.seconds = seconds;
    part.wall_seconds = wall;
    forecast.phases.push_back(part);
  }
  forecast.wall_seconds = 114;
  return forecast;
}

TEST(PlanComparison, WhatIsSharedIsTakenOffTheFirstPhases) {
  const Forecast forecast = three_phases();
  EXPECT_NEAR(*wall_seconds_after(forecast, 0), 114, 1e-9);
  EXPECT_NEAR(*wall_seconds_after(forecast, 0.1), 109, 1e-9);
  EXPECT_NEAR(*wall_seconds_after(forecast, 0.2), 104, 1e-9);
  EXPECT_NEAR(*wall_seconds_after(forecast, 0.45), 54, 1e-9);
  EXPECT_NEAR(*wall_seconds_after(forecast, 0.7), 4, 1e-9);
  EXPECT_NEAR(*wall_seconds_after(forecast, 2), 0, 1e-9);
}

TEST(PlanComparison, KnowsNoTimeWithoutAPilot) {
  Forecast forecast = three_phases();
  forecast.wall_seconds.reset();
  EXPECT_FALSE(wall_seconds_after(forecast, 0.1));
}

}  // namespace
}  // namespace diefill::process::plan
