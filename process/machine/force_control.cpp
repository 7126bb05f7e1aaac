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

/// What translation and rotation have in common; target and speed limit are known.
std::shared_ptr<Step> finished(TableReader& table, const std::vector<std::string>& tools,
                               ForceControl control) {
  // At rest without resistance twice the default gain would ask for the speed limit; a seventh of what
  // becomes unstable (engine/STABILITY.md, force-controlled pistons).
  control.gain = table.number("gain", kGain).value_or(0.5) * control.speed_limit / control.target;
  control.integral_time = table.quantity("integral_time", kIntegralTime).value_or(0.02);
  return std::make_shared<ControlledTool>(tools, control, table.quantity("duration", kDuration));
}

}  // namespace

double ForceControl::resistance(const Eigen::Vector3d& force, const Eigen::Vector3d& torque,
                                const Eigen::Vector3d& place) const {
  if (!turns) return -axis.direction.dot(force);
  return -axis.direction.dot(torque + (place - axis.through).cross(force));
}

void ForceControl::update(ControlState& state, double measured, double now, double interval) const {
  state.coordinate = state.coordinate_at(now);
  state.since = now;
  const double error = target - measured;
  const double grown = state.integral + gain * error * interval / integral_time;
  const double asked = gain * error + grown;
  // An integral that grows while the limit acts would overshoot later.
  if (std::abs(asked) < speed_limit) state.integral = grown;
  double rate = std::clamp(gain * error + state.integral, -speed_limit, speed_limit);
  rate = std::clamp(rate, state.rate - acceleration * interval, state.rate + acceleration * interval);
  state.rate = std::clamp(rate, -state.coordinate / interval, (travel - state.coordinate) / interval);
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
  return names_text(tools_) + (control_.turns ? " turned with " : " pressed with ") +
         number_text(control_.target) + (control_.turns ? " N m" : " N");
}

std::shared_ptr<Step> read_piston(TableReader& table, const std::vector<ToolSpec>& tools) {
  const auto moving = read_moving_tools(table, tools);
  ForceControl control;
  table.require("direction", "\"-z\"");
  control.axis.direction = *table.direction("direction");
  control.target = table.required_quantity("force", kForce);
  control.speed_limit = table.required_quantity("speed_limit", kSpeed);
  control.travel = table.required_quantity("travel", kTravel);
  return finished(table, moving, control);
}

std::shared_ptr<Step> read_rotor(TableReader& table, const std::vector<ToolSpec>& tools) {
  const auto moving = read_moving_tools(table, tools);
  ForceControl control;
  control.turns = true;
  control.axis = read_rotation_axis(table);
  control.target = table.required_quantity("torque", kTorque);
  control.speed_limit = table.required_quantity("speed_limit", kTurnSpeed);
  control.acceleration = 1e3;
  control.travel = std::numeric_limits<double>::infinity();
  return finished(table, moving, control);
}

}  // namespace diefill::process
