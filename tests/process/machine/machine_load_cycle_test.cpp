// A piston that seeks several forces in turn, unloads between them and retreats.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "process/machine/force_control.h"

namespace diefill::process {
namespace {

constexpr double kInterval = 2e-5;            // s
constexpr double kTouch = 1e-3, kEnd = 3e-2;  // m

ForceControl cycle() {
  ForceControl control;
  control.targets = {10, 0.5, 10, 0.5};
  control.speed_limit = 0.05;
  control.gain = 2;
  control.integral_time = 0.02;
  control.travel = kEnd;
  control.pause = 5e-3;
  control.retreat = 5e-4;
  return control;
}

/// What a piston met on its way.
struct Way {
  ControlState state;
  double beyond = 0;    ///< largest force beyond the target that is sought, over that target
  double held = 0;      ///< largest distance from a target that is held, over that target
  double farthest = 0;  ///< m
  int targets_met = 0;
};

/// A spring of `stiffness` (N/m), `softer` times as stiff on loading as on unloading, as powder is.
Way press(const ForceControl& control, double stiffness, double softer) {
  Way way;
  ControlState& state = way.state;
  double force = 0, deepest_rest = kTouch;
  bool before_touch = true;
  for (int n = 1; n < 2000000 && !control.done(state); ++n) {
    const double now = n * kInterval, from = state.coordinate, to = state.coordinate_at(now);
    // Along the unloading line through the present point, but not above the loading line from the touch.
    const double line = stiffness * std::max(0.0, to - deepest_rest);
    const double loading = softer * stiffness * std::max(0.0, to - kTouch);
    const double next = std::min(line, loading);
    if (loading < line) deepest_rest = to - loading / stiffness;
    const double mean = 0.5 * (force + next), target = control.wanted(state);
    force = next;
    if (force > 0) before_touch = false;
    const auto passed = state.passed;
    const bool sought = passed < control.targets.size(), pressing = passed % 2 == 0;
    if (sought && !before_touch) {
      way.beyond = std::max(way.beyond, (pressing ? force - target : target - force) / target);
      if (state.reached >= 0) way.held = std::max(way.held, std::abs(force - target) / target);
    }
    control.update(state, mean, now, kInterval);
    EXPECT_LE(std::abs(state.rate), control.speed_limit * (1 + 1e-12)) << from;
    if (state.passed != passed && sought) ++way.targets_met;
    way.farthest = std::max(way.farthest, to);
  }
  return way;
}

TEST(LoadCycle, ForcesAreMetInTurnWithinTwoPerCent) {
  for (const double stiffness : {5e3, 2e4, 1e5})
    for (const double softer : {1.0, 0.3, 0.1}) {
      const ForceControl control = cycle();
      const Way way = press(control, stiffness, softer);
      EXPECT_TRUE(control.done(way.state)) << stiffness << ' ' << softer;
      EXPECT_EQ(way.targets_met, 4);
      EXPECT_LE(way.beyond, 0.02) << stiffness << ' ' << softer;
      EXPECT_LE(way.held, 0.02) << stiffness << ' ' << softer;
    }
}

TEST(LoadCycle, ThePistonRetreatsFromWhereItIsAndNotBehindItsStart) {
  ForceControl control = cycle();
  control.targets = {10};
  Way way = press(control, 2e4, 1);
  EXPECT_NEAR(way.farthest, kTouch + 10 / 2e4, 1e-5);
  EXPECT_NEAR(way.state.coordinate, way.state.turned_back - control.retreat, 1e-12);
  control.retreat = 1;
  way = press(control, 2e4, 1);
  EXPECT_TRUE(control.done(way.state));
  EXPECT_NEAR(way.state.coordinate, 0, 1e-12);
}

TEST(LoadCycle, ASingleForceIsHeldForEver) {
  ForceControl control = cycle();
  control.pause.reset();
  ControlState state;
  for (int n = 1; n < 100000; ++n) {
    const double now = n * kInterval;
    control.update(state, 2e4 * std::max(0.0, state.coordinate_at(now) - kTouch), now, kInterval);
  }
  EXPECT_FALSE(control.done(state));
  EXPECT_EQ(state.passed, 0U);
  EXPECT_NEAR(state.coordinate, kTouch + 10 / 2e4, 1e-7);
}

}  // namespace
}  // namespace diefill::process
