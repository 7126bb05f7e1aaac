#include "process/machine/force_control.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "process/machine/moving_tool.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kForce = {Dimension::force, "5 N", "0 N", "1e6 N", true};
constexpr QuantityRule kTorque = {Dimension::torque, "0.02 N m", "0 N m", "1e5 N m", true};
constexpr QuantityRule kSpeed = {Dimension::velocity, "0.02 m/s", "0 m/s", "10 m/s", true};
constexpr QuantityRule kTurnSpeed = {Dimension::angular_velocity, "60 rpm", "0 rpm", "60000 rpm", true};
constexpr QuantityRule kTravel = {Dimension::length, "20 mm", "0 mm", "10 m", true};
constexpr QuantityRule kDuration = {Dimension::time, "1 s", "0 s", "1000 s", true};
constexpr QuantityRule kIntegralTime = {Dimension::time, "20 ms", "0 s", "100 s", true};
constexpr NumberRule kGain = {0, 1000, true, "0.5"};

constexpr QuantityRule kPause = {Dimension::time, "10 ms", "0 s", "1000 s"};
constexpr std::size_t kMostForces = 1000;

/// What translation and rotation have in common; targets and speed limit are known.
std::shared_ptr<Step> finished(TableReader& table, const std::vector<std::string>& tools,
                               ForceControl control) {
  // At rest without resistance twice the default gain would ask for the speed limit; a seventh of what
  // becomes unstable (engine/STABILITY.md, force-controlled pistons).
  control.gain = table.number("gain", kGain).value_or(0.5);
  control.integral_time = table.quantity("integral_time", kIntegralTime).value_or(0.02);
  // Several forces end by themselves.
  const auto duration = control.pause ? std::nullopt : table.quantity("duration", kDuration);
  return std::make_shared<ControlledTool>(tools, control, duration);
}

/// `force`, held until the step ends, or `forces`, each held for a `pause`.
void read_forces(TableReader& table, ForceControl& control) {
  if (!table.has("forces")) {
    control.targets = {table.required_quantity("force", kForce)};
    return;
  }
  if (table.has("force")) table.reject("force", "forces are given as well; remove one of the two");
  if (table.has("duration")) table.reject("duration", "a step with forces ends by itself; remove the key");
  control.targets = table.quantities("forces", kForce);
  if (control.targets.size() > kMostForces)
    table.reject("forces", "allowed: at most " + std::to_string(kMostForces) + " forces");
  control.pause = table.quantity("pause", kPause).value_or(0);
  control.retreat = table.quantity("retreat", kTravel).value_or(0);
}

}  // namespace

double ForceControl::wanted(const ControlState& state) const {
  return targets[std::min<std::size_t>(state.passed, targets.size() - 1)];
}

double ForceControl::largest_target() const {
  return *std::max_element(targets.begin(), targets.end());
}

bool ForceControl::done(const ControlState& state) const {
  return pause && state.passed >= targets.size() + (retreat > 0 ? 1 : 0);
}

double ForceControl::resistance(const Eigen::Vector3d& force, const Eigen::Vector3d& torque,
                                const Eigen::Vector3d& place) const {
  if (!turns) return -axis.direction.dot(force);
  return -axis.direction.dot(torque + (place - axis.through).cross(force));
}

void ForceControl::pass_targets(ControlState& state, double measured, double now) const {
  if (!pause || state.passed >= targets.size()) return;
  const double target = wanted(state);
  if (state.reached < 0 && std::abs(measured - target) <= kReached * target) state.reached = now;
  if (state.reached < 0 || now - state.reached < *pause) return;
  ++state.passed;
  state.reached = -1;
  state.integral = 0;
  state.turned_back = state.coordinate;
}

double ForceControl::asked_rate(ControlState& state, double measured, double interval) const {
  const double target = wanted(state);
  // Powder that was pressed harder before is as stiff as that has left it.
  const double scale = state.passed > 0 ? std::max(target, targets[state.passed - 1]) : target;
  const double proportional = gain * speed_limit * (target - measured) / scale;
  // An integral that grew on the way to the powder would press beyond the target. A rotor turns steadily
  // against its torque and needs it at all times, but while the limit acts.
  const double grown = state.integral + proportional * interval / integral_time;
  const bool grows =
      turns ? std::abs(proportional + grown) < speed_limit : std::abs(target - measured) <= kNear * target;
  if (grows) state.integral = grown;
  return std::clamp(proportional + state.integral, -speed_limit, speed_limit);
}

void ForceControl::update(ControlState& state, double measured, double now, double interval) const {
  state.coordinate = state.coordinate_at(now);
  state.since = now;
  pass_targets(state, measured, now);
  double least = 0;
  if (state.passed < targets.size()) {
    state.rate = asked_rate(state, measured, interval);
  } else {
    least = std::max(0.0, state.turned_back - retreat);
    if (state.passed == targets.size() && state.coordinate - least <= 1e-9 * retreat) ++state.passed;
    state.rate = -speed_limit;
  }
  state.rate =
      std::clamp(state.rate, (least - state.coordinate) / interval, (travel - state.coordinate) / interval);
}

ToolMotion ForceControl::motion(double coordinate, double rate) const {
  if (turns) return axis.turned(coordinate, rate);
  ToolMotion motion;
  motion.translation = coordinate * axis.direction;
  motion.velocity = rate * axis.direction;
  return motion;
}

ToolMotion ControlledTool::motion(double time) const {
  const double way = control_.speed_limit * time;
  return control_.motion(std::min(way, control_.travel), way < control_.travel ? control_.speed_limit : 0);
}

std::string ControlledTool::description() const {
  std::string targets = number_text(control_.targets.front());
  if (control_.targets.size() > 1)
    targets += " to " + number_text(control_.targets.back()) + " N in " +
               std::to_string(control_.targets.size()) + " loads";
  else
    targets += control_.turns ? " N m" : " N";
  return names_text(tools_) + (control_.turns ? " turned with " : " pressed with ") + targets;
}

std::shared_ptr<Step> read_piston(TableReader& table, const std::vector<ToolSpec>& tools) {
  const auto moving = read_moving_tools(table, tools);
  ForceControl control;
  table.require("direction", "\"-z\"");
  control.axis.direction = *table.direction("direction");
  read_forces(table, control);
  control.speed_limit = table.required_quantity("speed_limit", kSpeed);
  control.travel = table.required_quantity("travel", kTravel);
  return finished(table, moving, control);
}

std::shared_ptr<Step> read_rotor(TableReader& table, const std::vector<ToolSpec>& tools) {
  const auto moving = read_moving_tools(table, tools);
  ForceControl control;
  control.turns = true;
  control.axis = read_rotation_axis(table);
  control.targets = {table.required_quantity("torque", kTorque)};
  control.speed_limit = table.required_quantity("speed_limit", kTurnSpeed);
  control.travel = std::numeric_limits<double>::infinity();
  return finished(table, moving, control);
}

}  // namespace diefill::process
