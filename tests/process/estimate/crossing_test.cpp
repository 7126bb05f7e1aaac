// The time of one crossing at another speed.
#include <gtest/gtest.h>

#include <cmath>

#include "process/estimate/work_of_steps.h"

namespace diefill::process::estimate {
namespace {

TEST(Crossing, AtAnotherSpeedTakesItsOwnRamps) {
  // 40 mm with 10 m/s^2: ramps of 20 ms and 2 mm each at 0.2 m/s.
  const Crossing quick{0.04 / 0.2 + 0.02, 0.2, 10};
  EXPECT_NEAR(quick.time_at(0.2), quick.time, 1e-12);
  EXPECT_NEAR(quick.time_at(0.05), 0.04 / 0.05 + 0.005, 1e-12);
  EXPECT_NEAR(quick.time_at(5), 2 * std::sqrt(0.04 / 10), 1e-12) << "it never reaches that speed";
  const Crossing without_cruise{2 * std::sqrt(0.04 / 10), 5, 10};
  EXPECT_NEAR(without_cruise.time_at(0.2), quick.time, 1e-12);
}

}  // namespace
}  // namespace diefill::process::estimate
