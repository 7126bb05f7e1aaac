// When force control is said to ring.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/numerics/out_of_range.h"
#include "process/machine/force_control.h"
#include "process/machine/ringing_watch.h"

namespace diefill::process {
namespace {

constexpr double kInterval = 1e-4, kLongest = 0.05;  // s

/// Looks at 1 + `amplitude` sin(2 pi f t), over the wanted resistance, for `duration` (s).
RingingWatch after_swinging(double amplitude, double frequency, double duration) {
  RingingWatch watch;
  for (double now = 0; now < duration; now += kInterval)
    watch.add(1 + amplitude * std::sin(2 * std::numbers::pi * frequency * now), now, kLongest);
  return watch;
}

TEST(RingingWatch, CountsSwingsThatGoFarEnough) {
  const RingingWatch watch = after_swinging(0.8, 100, 0.1);
  EXPECT_EQ(watch.swings, 20U);  // two a period
  EXPECT_NEAR(watch.lowest, 0.2, 0.01);
  EXPECT_NEAR(watch.highest, 1.8, 0.01);
  EXPECT_EQ(after_swinging(0.4, 100, 0.1).swings, 0U);
}

TEST(RingingWatch, ForgetsWhatIsLongAgo) {
  EXPECT_LE(after_swinging(0.8, 5, 10).swings, 1U);
  RingingWatch watch = after_swinging(0.8, 100, 0.1);
  watch.add(1, 1, kLongest);
  EXPECT_EQ(watch.swings, 0U);
}

TEST(RingingWatch, ApproachFromNothingIsNoSwing) {
  RingingWatch watch;
  for (double now = 0; now < 1; now += kInterval) watch.add(std::min(1.2, now), now, kLongest);
  EXPECT_EQ(watch.swings, 0U);
}

/// A spring of `stiffness` (N/m) pressed under control with `gain`, updated as a run does, with the mean
/// force of each interval, for `duration` (s).
void press_a_spring(double stiffness, double gain, double duration) {
  ForceControl control;
  control.targets = {1};
  control.speed_limit = 0.05;
  control.gain = gain;
  control.integral_time = 0.02;
  control.travel = 1;
  ControlState state;
  RingingWatch watch;
  for (double now = kInterval; now < duration; now += kInterval) {
    const double from = state.coordinate, to = state.coordinate_at(now);
    const double mean = stiffness * 0.5 * (from + to);
    control.update(state, mean, now, kInterval);
    watch_for_ringing(watch, control, 1, mean, now, "piston");
  }
}

TEST(RingingWatch, StopsBeyondTheGainOfTheoryAndNotBelow) {
  // 2 F / (K v T): beyond, every answer undoes more than the difference it answers.
  constexpr double kStiffness = 2e5;
  const double limit = 2 / (kStiffness * 0.05 * kInterval);
  EXPECT_NO_THROW(press_a_spring(kStiffness, 0.8 * limit, 0.5));
  EXPECT_THROW(press_a_spring(kStiffness, 1.2 * limit, 0.5), engine::OutOfRange);
  try {
    press_a_spring(kStiffness, 10 * limit, 0.5);
    FAIL();
  } catch (const engine::OutOfRange& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("force control of piston is unstable"), std::string::npos) << what;
    EXPECT_NE(what.find("reduce gain (now 20)"), std::string::npos) << what;
  }
}

}  // namespace
}  // namespace diefill::process
