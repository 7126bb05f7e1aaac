// A rotor that turns at a given speed until its torque is steady, holds a torque, and frees itself of it; a
// piston that unloads powder behind its start.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "process/machine/force_control.h"

namespace diefill::process {
namespace {

constexpr double kInterval = 1e-5;                 // s
constexpr double kStiffness = 2e-4;                // N m/rad, of the powder before it slips
constexpr double kFriction = 5e-6;                 // N m, on it when it slips
constexpr double kSlips = kFriction / kStiffness;  // rad

ForceControl rotor() {
  ForceControl control;
  control.turns = true;
  control.speed_limit = 2;
  control.travel = std::numeric_limits<double>::infinity();
  control.integral_time = 0.02;
  return control;
}

/// A spring that slips beyond the friction (Coulomb's), loaded by `angle` at first.
class Coulomb {
 public:
  explicit Coulomb(double angle) : from_(-angle) {}
  double operator()(double coordinate) {
    from_ = std::clamp(from_, coordinate - kSlips, coordinate + kSlips);
    return kStiffness * (coordinate - from_);
  }

 private:
  double from_;
};

/// What a tool under control met until it ended, or `duration` (s) was over.
struct Way {
  ControlState state;
  double time = 0, resistance = 0;
  double least = std::numeric_limits<double>::infinity(), most = -least;  ///< resistance
  bool ended = false;
};

Way follow(const ForceControl& control, const std::function<double(double)>& resistance, double duration) {
  Way way;
  for (int n = 1; n * kInterval <= duration && !way.ended; ++n) {
    way.time = n * kInterval;
    way.resistance = resistance(way.state.coordinate_at(way.time));
    way.least = std::min(way.least, way.resistance), way.most = std::max(way.most, way.resistance);
    control.update(way.state, way.resistance, way.time, kInterval);
    EXPECT_LE(std::abs(way.state.rate), control.speed_limit * (1 + 1e-9));
    way.ended = control.done(way.state);
  }
  return way;
}

TEST(Rotor, TurnsAtItsSpeedWhateverThePowderResistsAndEndsAtItsAngle) {
  ForceControl control = rotor();
  control.travel = 0.5;
  control.ends_at_travel = true;
  const Way way = follow(
      control, [](double angle) { return 1e3 * std::sin(40 * angle); }, 10);
  EXPECT_TRUE(way.ended);
  EXPECT_NEAR(way.time, 0.5 / control.speed_limit, 2.5 * kInterval);
  EXPECT_NEAR(way.state.coordinate, 0.5, 1e-9);
}

TEST(Rotor, HoldsATorqueBelowTheFrictionAndDoesNotPassIt) {
  for (const double share : {0.1, 0.6, 0.9}) {
    ForceControl control = rotor();
    control.targets = {share * kFriction};
    const Way way = follow(control, Coulomb(0), 0.5);
    EXPECT_NEAR(way.resistance, share * kFriction, 1e-3 * share * kFriction);
    EXPECT_NEAR(way.state.coordinate, share * kSlips, 1e-3 * share * kSlips);
    EXPECT_LT(way.most, 1.02 * share * kFriction);
  }
}

TEST(Rotor, TurnsAtItsLimitWhereTheFrictionIsLessThanItsTorque) {
  ForceControl control = rotor();
  control.targets = {2 * kFriction};
  const Way way = follow(control, Coulomb(0), 1);
  EXPECT_NEAR(way.resistance, kFriction, 1e-12);
  EXPECT_NEAR(way.state.rate, control.speed_limit, 0.02 * control.speed_limit);
}

TEST(Rotor, FreesItselfOfTorqueByTurningBackWithoutPassingIt) {
  ForceControl control = rotor();
  control.targets = {0};
  control.pause = 5e-3;
  control.back = 2 * kSlips;
  const Way way = follow(control, Coulomb(kSlips), 1);
  EXPECT_TRUE(way.ended);
  EXPECT_NEAR(way.resistance, 0, 0.01 * kFriction);
  EXPECT_NEAR(way.state.coordinate, -kSlips, 0.01 * kSlips);
  EXPECT_GT(way.least, -0.02 * kFriction);
}

TEST(Rotor, IsFreeOfATorqueThatFluctuatesAboutZero) {
  ForceControl control = rotor();
  control.targets = {0};
  control.pause = 1e-3;
  control.back = 2 * kSlips;
  Coulomb powder(kSlips);
  double sign = 1;
  const Way way = follow(
      control, [&](double angle) { return powder(angle) + 0.3 * kFriction * (sign = -sign); }, 0.2);
  EXPECT_TRUE(way.ended);
  EXPECT_NEAR(way.state.coordinate, -kSlips, 0.5 * kSlips);
}

TEST(Rotor, WithoutTorqueFromTheStartIsFreeOfItAtOnce) {
  ForceControl control = rotor();
  control.targets = {0};
  control.pause = 0;
  control.back = 1;
  EXPECT_TRUE(follow(
                  control, [](double) { return 0.0; }, 1)
                  .ended);
}

TEST(Rotor, GoesBackNoFartherThanItMay) {
  ForceControl control = rotor();
  control.targets = {0};
  control.pause = 0;
  control.back = 0.4 * kSlips;
  const Way way = follow(control, Coulomb(kSlips), 0.5);
  EXPECT_FALSE(way.ended);
  EXPECT_NEAR(way.state.coordinate, -0.4 * kSlips, 1e-9);
  EXPECT_NEAR(way.resistance, 0.6 * kFriction, 1e-9 * kFriction);
}

/// T_s (1 - exp(-angle / bend)): means over stretches of w are T_s (1 - q^n (1 - q) bend / w) with
/// q = exp(-w / bend).
TEST(Rotor, EndsOnceTheTorqueIsSteady) {
  constexpr double kBend = 0.05, kStretch = 0.04, kWithin = 0.02;
  ForceControl control = rotor();
  control.steady = {kWithin, kStretch};
  const Way way = follow(
      control, [](double angle) { return 1e-3 * (1 - std::exp(-angle / kBend)); }, 10);
  const double q = std::exp(-kStretch / kBend), first = (1 - q) * kBend / kStretch;
  const auto mean = [&](int n) { return 1 - std::pow(q, n) * first; };
  int last = 1;
  while (mean(last) - mean(last - 1) > kWithin * mean(last)) ++last;
  EXPECT_TRUE(way.ended);
  EXPECT_EQ(way.state.steady.stretches, static_cast<std::uint64_t>(last + 1));
  EXPECT_NEAR(way.state.coordinate, (last + 1) * kStretch, (last + 2) * control.speed_limit * kInterval);
  EXPECT_NEAR(way.state.steady.mean, 1e-3 * mean(last), 1e-6);
}

TEST(Rotor, IsNotSteadyWhileItsTorqueRises) {
  ForceControl control = rotor();
  control.steady = {0.02, 0.04};
  // A stretch adds 1/n of the mean: 2 % from the 50th on.
  const Way way = follow(
      control, [](double angle) { return 1e-3 * angle; }, 10);
  EXPECT_TRUE(way.ended);
  EXPECT_NEAR(static_cast<double>(way.state.steady.stretches), 51, 1);
}

TEST(Piston, UnloadsBehindItsStartWithoutPassingItsForce) {
  constexpr double kSpring = 2e4, kPressed = 10;  // N/m, N
  for (const double target : {0.1, 4.0, 9.0}) {
    ForceControl control;
    control.targets = {target};
    control.speed_limit = 0.05;
    control.travel = 0.01;
    control.back = 1e-3;
    control.integral_time = 0.02;
    const Way way = follow(
        control, [&](double way_in) { return kPressed + kSpring * way_in; }, 0.5);
    EXPECT_NEAR(way.state.coordinate, (target - kPressed) / kSpring, 1e-3 * kPressed / kSpring) << target;
    EXPECT_GT(way.least, target - 0.02 * kPressed) << target;
  }
}

TEST(Piston, StaysAtItsStartWhereItMayNotGoBack) {
  ForceControl control;
  control.targets = {4};
  control.speed_limit = 0.05;
  control.travel = 0.01;
  control.integral_time = 0.02;
  const Way way = follow(
      control, [](double way_in) { return 10 + 2e4 * way_in; }, 0.1);
  EXPECT_EQ(way.state.coordinate, 0);
}

}  // namespace
}  // namespace diefill::process
