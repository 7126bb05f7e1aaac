// Motions against their formulas: closed forms at chosen instants, velocity as the derivative of place at
// every one, smooth starts and stops, and several on one tool at a time.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "process/machine/force_control.h"
#include "process/machine/motions/move.h"
#include "process/machine/motions/rotation.h"
#include "process/machine/motions/rotational_oscillation.h"
#include "process/machine/motions/table_motion.h"
#include "process/machine/motions/vibration.h"
#include "process/tooling/stages.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

using std::numbers::pi;
const Eigen::Vector3d kPoint(0.03, -0.01, 0.02);  // m, of the tool

/// Where the motion puts a point of the tool, and how fast that moves.
Eigen::Vector3d place_of(const ToolMotion& motion) {
  return motion.rotation * (kPoint - motion.pivot) + motion.pivot + motion.translation;
}

Eigen::Vector3d velocity_of(const ToolMotion& motion) {
  return motion.velocity +
         motion.angular_velocity.cross(place_of(motion) - motion.pivot - motion.translation);
}

/// Compares velocities with central differences of places, at times that are no round numbers.
void expect_derivative(const std::function<ToolMotion(double)>& motion, double length, double fastest) {
  const double h = 1e-6;
  for (int n = 1; n < 400; ++n) {
    const double time = length * n / 400.3;
    if (time < h || time > length - h) continue;
    const Eigen::Vector3d slope = (place_of(motion(time + h)) - place_of(motion(time - h))) / (2 * h);
    ASSERT_NEAR((slope - velocity_of(motion(time))).norm(), 0, 2e-5 * fastest) << "at " << time;
  }
}

/// Neither place nor velocity jumps from one instant to the next.
void expect_smooth(const std::function<ToolMotion(double)>& motion, double length, double fastest,
                   double acceleration) {
  const int steps = 20000;
  const double interval = length / steps;
  for (int n = 0; n < steps; ++n) {
    const ToolMotion now = motion(n * interval), next = motion((n + 1) * interval);
    ASSERT_LE((place_of(next) - place_of(now)).norm(), 1.001 * fastest * interval + 1e-15) << n * interval;
    ASSERT_LE((velocity_of(next) - velocity_of(now)).norm(), 1.001 * acceleration * interval + 1e-12)
        << n * interval;
  }
}

Oscillation shaking(double amplitude, double frequency) {
  Oscillation oscillation;
  oscillation.amplitude = amplitude;
  oscillation.frequency = frequency;
  oscillation.phase = 0.7;
  oscillation.ramps = {.ramp = 0.1, .duration = 1.0};
  return oscillation;
}

TEST(SmoothRamp, IsTheIntegralOfItsSlopeAndHasTheIntegralItSays) {
  double value = 0, integral = 0;
  const int steps = 100000;
  for (int n = 0; n < steps; ++n) {
    const double middle = (n + 0.5) / steps;
    integral += ramp_value(middle) / steps;
    value += ramp_slope(middle) / steps;
    ASSERT_NEAR(value, ramp_value((n + 1.0) / steps), 1e-8);
    ASSERT_NEAR(integral, ramp_integral((n + 1.0) / steps), 1e-8);
  }
  EXPECT_DOUBLE_EQ(ramp_value(1), 1);
  EXPECT_DOUBLE_EQ(ramp_integral(1), 0.5);
  EXPECT_DOUBLE_EQ(ramp_integral(3), 2.5);
}

TEST(Envelope, SwellsHoldsAndDiesAwayAndKnowsItsIntegral) {
  const Envelope envelope(0.2, 1.0);
  double integral = 0;
  const int steps = 100000;
  for (int n = 0; n < steps; ++n) {
    integral += envelope.value((n + 0.5) / steps) / steps;
    ASSERT_NEAR(integral, envelope.integral((n + 1.0) / steps), 1e-8);
  }
  EXPECT_DOUBLE_EQ(envelope.value(0.5), 1);
  EXPECT_NEAR(envelope.integral(1), 0.8, 1e-12);  // two ramps count half
  EXPECT_EQ(envelope.value(1.01), 0);
  EXPECT_DOUBLE_EQ(Envelope(0.2, 0.1).end(), 0.4);  // too early: after both ramps
}

TEST(Vibration, FollowsItsSineOnceItHasSwollen) {
  const Oscillation given = shaking(1e-3, 32);
  const Vibration vibration({"shoe"}, Eigen::Vector3d(0, 0.6, 0.8), given);
  for (const double time : {0.2, 0.4567, 0.8}) {
    const double angle = 2 * pi * 32 * time + 0.7;
    const ToolMotion motion = vibration.motion(time);
    EXPECT_TRUE(motion.translation.isApprox(1e-3 * std::sin(angle) * Eigen::Vector3d(0, 0.6, 0.8), 1e-12));
    EXPECT_TRUE(
        motion.velocity.isApprox(1e-3 * 2 * pi * 32 * std::cos(angle) * Eigen::Vector3d(0, 0.6, 0.8), 1e-12));
  }
  EXPECT_EQ(vibration.motion(0).translation.norm(), 0);
  EXPECT_EQ(vibration.motion(1).translation.norm(), 0);
  EXPECT_EQ(vibration.motion(1).velocity.norm(), 0);
}

TEST(Vibration, MovesSmoothlyFromRestToRest) {
  const Vibration vibration({"shoe"}, Eigen::Vector3d::UnitX(), shaking(1e-3, 8));
  const auto motion = [&](double time) { return vibration.motion(time); };
  expect_derivative(motion, 1, 0.1);
  const double omega = 2 * pi * 8;
  // RampTimes adds at most 2 s' omega + s'' with s' < 1.9 / ramp and s'' < 5.8 / ramp^2.
  expect_smooth(motion, 1, 1e-3 * (omega + 19), 1e-3 * (omega * omega + 38 * omega + 580));
}

TEST(Vibration, DiesAwayWhenItIsToldToStop) {
  Oscillation endless = shaking(1e-3, 8);
  endless.ramps.duration.reset();
  const Vibration vibration({"shoe"}, Eigen::Vector3d::UnitX(), endless);
  EXPECT_TRUE(vibration.open_ended());
  const double stop = 3.21;
  EXPECT_NEAR(vibration.stopping_time(stop), 0.1, 1e-12);
  const auto motion = [&](double time) { return vibration.motion_stopped(time, stop); };
  expect_derivative(motion, stop + 0.1, 0.1);
  EXPECT_EQ(motion(stop + 0.1).translation.norm(), 0);
  EXPECT_TRUE(motion(stop).translation.isApprox(vibration.motion(stop).translation, 1e-12));
  EXPECT_TRUE(motion(stop).velocity.isApprox(vibration.motion(stop).velocity, 1e-12));
}

TEST(Vibration, KnowsWhereItIsFarthestOut) {
  const double length = 1;
  for (const double phase : {-3.0, 0.0, 0.4, 3.0})
    for (const double frequency : {2.0, 8.0, 32.0}) {
      const Vibration shaking({"die"}, Eigen::Vector3d::UnitY(),
                              {.amplitude = 1e-3,
                               .frequency = frequency,
                               .phase = phase,
                               .ramps = {.ramp = 0.03, .duration = length}});
      const auto points = shaking.turning_points(length);
      ASSERT_EQ(points.size(), 2U) << frequency;
      EXPECT_EQ(shaking.motion(points[0]).translation, -shaking.motion(points[1]).translation);
      for (const double time : points) {
        EXPECT_EQ(std::abs(shaking.motion(time).translation[1]), 1e-3) << frequency << ' ' << phase;
        EXPECT_GE(time, 0.03);
        EXPECT_LE(time, length - 0.03);
      }
      EXPECT_TRUE(shaking.turning_points(0.03).empty());
    }
}

TEST(RotationalOscillation, TurnsAboutItsAxisByEquation61) {
  RotationAxis axis;
  axis.through = {0.01, 0, 0};
  const RotationalOscillation step({"die"}, axis, shaking(5 * pi / 180, 8));
  const double time = 0.4321, angle = 5 * pi / 180 * std::sin(2 * pi * 8 * time + 0.7);
  const ToolMotion motion = step.motion(time);
  const Eigen::Vector3d expected =
      Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * (kPoint - axis.through) + axis.through;
  EXPECT_TRUE(place_of(motion).isApprox(expected, 1e-12));
  expect_derivative([&](double t) { return step.motion(t); }, 1, 0.1);
  EXPECT_EQ(step.motion(1).rotation, Eigen::Matrix3d::Identity());
}

TEST(Rotation, TurnsAtItsSpeedAndStopsWhenTold) {
  const Rotation rotation({"stirrer"}, RotationAxis{}, 2 * pi, {.ramp = 0.2, .duration = {}});
  EXPECT_NEAR(rotation.motion(0.7).angular_velocity.z(), 2 * pi, 1e-12);
  const auto stopped = [&](double time) { return rotation.motion_stopped(time, 1.0); };
  expect_derivative(stopped, 1.2, 0.2);
  // Full speed from 0.2 s to 1 s, half a turn's worth of ramps: one turn in all.
  EXPECT_TRUE(stopped(1.2).rotation.isApprox(Eigen::Matrix3d::Identity(), 1e-12));
  EXPECT_EQ(stopped(1.2).angular_velocity.norm(), 0);
}

TEST(Move, GoesFromStationToStationAndRestsThere) {
  MoveSpec spec;
  spec.tools = {"lower punch"};
  spec.stations = {0.02, -0.005, 0};
  spec.velocity = 0.1;
  spec.pause = 0.05;
  const Move move(spec);
  const double first = 0.02 / 0.1 + 0.01, second = 0.025 / 0.1 + 0.01, third = 0.005 / 0.1 + 0.01;
  EXPECT_NEAR(*move.duration(), first + second + third + 0.1, 1e-12);
  EXPECT_NEAR(move.motion(first + 0.03).translation.z(), -0.02, 1e-15);
  EXPECT_NEAR(move.motion(first + 0.05 + second / 2).velocity.z(), 0.1, 1e-12);
  EXPECT_NEAR(move.motion(first + second + 0.08).translation.z(), 0.005, 1e-15);
  EXPECT_NEAR(move.motion(*move.duration()).translation.norm(), 0, 1e-15);
  expect_derivative([&](double t) { return move.motion(t); }, *move.duration(), 0.1);
}

TEST(Move, BrakesOnItsWayWhenItIsToldToStop) {
  MoveSpec spec;
  spec.tools = {"lower punch"};
  spec.stations = {0.02};
  const Move move(spec);
  const double stop = 0.5;
  const auto motion = [&](double time) { return move.motion_stopped(time, stop); };
  const double end = stop + move.stopping_time(stop);
  expect_derivative(motion, end, 0.02);
  EXPECT_EQ(motion(end).velocity.norm(), 0);
  EXPECT_GT(-motion(end).translation.z(), -move.motion(stop).translation.z());
  EXPECT_LT(-motion(end).translation.z(), 0.02);
}

class TableFile : public testing::Test {
 protected:
  support::TemporaryFolder folder_;
};

TEST_F(TableFile, GoesThroughItsPointsSmoothly) {
  const MotionTable table = read_motion_table(
      folder_.write("motion.csv", "time [ms], x mm, angle deg\n0, 0, 0\n100, 10, 5\n250, -5, 0\n400,0,-10\n"),
      "");
  ASSERT_EQ(table.time.size(), 4U);
  EXPECT_DOUBLE_EQ(table.position[1][0], 0.01);
  EXPECT_DOUBLE_EQ(table.position[3][3], -10 * pi / 180);
  const TableMotion motion({"shoe"}, {}, table);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_NEAR(motion.motion(table.time[k]).translation.x(), table.position[k][0], 1e-15);
  expect_derivative([&](double t) { return motion.motion(t); }, *motion.duration(), 0.3);
  expect_smooth([&](double t) { return motion.motion(t); }, *motion.duration(), 0.3, 10);
  EXPECT_NEAR(motion.motion(0.4).velocity.norm(), 0, 1e-15);
}

TEST(SeveralMotions, AddUpOnOneToolWithExactVelocities) {
  Scene scene;
  RotationAxis axis;
  axis.through = {0.02, 0.01, 0};
  MoveSpec travel;
  travel.tools = {"shoe"};
  travel.direction = -Eigen::Vector3d::UnitX();
  travel.stations = {0.06};
  scene.steps = {
      std::make_shared<RotationalOscillation>(std::vector<std::string>{"shoe"}, axis, shaking(0.1, 4)),
      std::make_shared<Vibration>(std::vector<std::string>{"shoe", "die"}, Eigen::Vector3d::UnitY(),
                                  shaking(1e-3, 8)),
      std::make_shared<Move>(travel)};
  const Stages stages(scene);
  std::vector<StepState> states(stages.size());
  for (auto& state : states) state.started = 0.25;
  const auto point_at = [&](double time) {
    const ToolPose pose = pose_of(stages, states, "shoe", time);
    return Eigen::Vector3d(pose.rotation * kPoint + pose.translation);
  };
  for (const double time : {0.3, 0.5, 0.777, 1.1}) {
    const ToolPose pose = pose_of(stages, states, "shoe", time);
    const ToolMotion turn = scene.steps[0]->motion(time - 0.25), shake = scene.steps[1]->motion(time - 0.25),
                     way = scene.steps[2]->motion(time - 0.25);
    // Turned first, then shifted by the other two.
    EXPECT_TRUE(point_at(time).isApprox(place_of(turn) + shake.translation + way.translation, 1e-13));
    const double h = 1e-6;
    const Eigen::Vector3d slope = (point_at(time + h) - point_at(time - h)) / (2 * h);
    const Eigen::Vector3d velocity =
        pose.velocity + pose.angular_velocity.cross(point_at(time) - pose.translation);
    EXPECT_NEAR((slope - velocity).norm(), 0, 1e-8) << time;
    const ToolPose die = pose_of(stages, states, "die", time);
    EXPECT_EQ(die.translation, shake.translation);
    EXPECT_EQ(die.rotation, Eigen::Matrix3d::Identity());
  }
}

TEST(SeveralMotions, LeaveAToolThatEndsElsewhereThere) {
  Scene scene;
  MoveSpec down;
  down.tools = {"punch"};
  down.stations = {0.02};
  scene.steps = {std::make_shared<Move>(down),
                 std::make_shared<Vibration>(std::vector<std::string>{"punch"}, Eigen::Vector3d::UnitX(),
                                             shaking(1e-3, 8))};
  const Stages stages(scene);
  const auto states = predicted(stages, 0.25);
  EXPECT_NEAR(states[2].started, 0.25 + *scene.steps[0]->duration(), 1e-12);
  const ToolPose end = pose_of(stages, states, "punch", 100);
  EXPECT_NEAR((end.translation - Eigen::Vector3d(0, 0, -0.02)).norm(), 0, 1e-15);
  EXPECT_EQ(end.velocity.norm(), 0);
}

/// A spring of stiffness `stiffness` that resists from `contact` on.
double settle_against_spring(const ForceControl& control, double stiffness, double contact, double duration) {
  ControlState state;
  const double interval = 1e-4;
  double resistance = 0;
  for (int n = 1; n * interval < duration; ++n) {
    resistance = stiffness * std::max(0.0, state.coordinate_at(n * interval) - contact);
    control.update(state, resistance, n * interval, interval);
    EXPECT_LE(std::abs(state.rate), control.speed_limit);
    EXPECT_LE(state.coordinate, control.travel * (1 + 1e-12));
  }
  return resistance;
}

TEST(ForceControl, ReachesItsForceWithinTheSpeedLimit) {
  ForceControl control;
  control.targets = {2};
  control.speed_limit = 0.02;
  control.gain = 0.5;
  control.integral_time = 0.02;
  control.travel = 0.05;
  EXPECT_NEAR(settle_against_spring(control, 1e4, 5e-3, 2), 2, 2e-3);
  EXPECT_NEAR(settle_against_spring(control, 1e5, 5e-3, 2), 2, 2e-3);
  // Out of reach: it stops at the end of its travel.
  EXPECT_EQ(settle_against_spring(control, 1e4, 0.06, 4), 0);
}

TEST(ForceControl, MeasuresResistanceAlongItsLineOrAboutItsAxis) {
  ForceControl line;
  line.axis.direction = -Eigen::Vector3d::UnitZ();
  EXPECT_DOUBLE_EQ(line.resistance({1, 2, 3}, {0, 0, 0}, {0, 0, 0}), 3);
  ForceControl turn;
  turn.turns = true;
  turn.axis.through = {0.1, 0, 0};
  // 2 N along y, 0.2 m off the axis, and 0.5 N m besides.
  EXPECT_NEAR(turn.resistance({0, 2, 0}, {0, 0, 0.5}, {0.3, 0, 0}), -0.9, 1e-12);
}

}  // namespace
}  // namespace diefill::process
