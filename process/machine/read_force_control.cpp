// The keys of pistons and rotors.
#include <algorithm>
#include <limits>

#include "process/machine/force_control.h"
#include "process/machine/motion_limits.h"
#include "process/machine/moving_tool.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kForce = {Dimension::force, "5 N", "0 N", "1e6 N", true};
constexpr QuantityRule kTorque = {Dimension::torque, "0.02 N m", "0 N m", "1e5 N m", true};
constexpr QuantityRule kSpeed = {Dimension::velocity, "0.02 m/s", "0 m/s", motion_limits::kFastest, true};
constexpr QuantityRule kTurnSpeed = {Dimension::angular_velocity, "60 rpm", "0 rpm",
                                     motion_limits::kFastestTurn, true};
constexpr QuantityRule kTravel = {Dimension::length, "20 mm", "0 mm", motion_limits::kFarthest, true};
constexpr QuantityRule kDuration = {Dimension::time, "1 s", "0 s", motion_limits::kLongest, true};
constexpr QuantityRule kIntegralTime = {Dimension::time, "20 ms", "0 s", "100 s", true};
constexpr NumberRule kGain = {0, 1000, true, "0.5"};

constexpr QuantityRule kPause = {Dimension::time, "10 ms", "0 s", "1000 s"};
constexpr QuantityRule kTorques = {Dimension::torque, "0.02 N m", "0 N m", "1e5 N m"};
constexpr QuantityRule kBack = {Dimension::length, "1 mm", "0 mm", motion_limits::kFarthest};
constexpr QuantityRule kBackTurn = {Dimension::angle, "5 deg", "0 deg", "360 deg"};
constexpr QuantityRule kTurn = {Dimension::angle, "90 deg", "0 deg", "360000 deg", true};
constexpr QuantityRule kStretch = {Dimension::angle, "20 deg", "0 deg", "360 deg", true};
constexpr NumberRule kWithin = {0, 1, true, "0.02"};
constexpr std::size_t kMaxForces = 1000;

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
  if (control.targets.size() > kMaxForces)
    table.reject("forces", "allowed: at most " + std::to_string(kMaxForces) + " forces");
  control.pause = table.quantity("pause", kPause).value_or(0);
  control.retreat = table.quantity("retreat", kTravel).value_or(0);
}

/// `torques`, each held for a `pause`.
void read_torques(TableReader& table, ForceControl& control) {
  for (const char* key : {"duration", "angle", "steady"})
    if (table.has(key)) table.reject(key, "a step with torques ends by itself; remove the key");
  control.targets = table.quantities("torques", kTorques);
  if (control.targets.size() > kMaxForces)
    table.reject("torques", "allowed: at most " + std::to_string(kMaxForces) + " torques");
  control.pause = table.quantity("pause", kPause).value_or(0);
  if (std::count(control.targets.begin(), control.targets.end(), 0.0) > 0 && control.back == 0)
    table.reject("torques",
                 "a torque of 0 requires the tool to turn back; set the limit, such as back = \"5 deg\"");
}

/// Where the rotor ends, if it turns far enough.
void read_turn(TableReader& table, ForceControl& control) {
  const auto angle = table.quantity("angle", kTurn);
  control.ends_at_travel = angle.has_value();
  control.travel = angle.value_or(std::numeric_limits<double>::infinity());
  auto steady = table.table("steady");
  if (!steady) return;
  control.steady = {steady->number("within", kWithin).value_or(0.02), 0};
  control.steady->over = steady->required_quantity("over", kStretch);
  steady->finish();
}

}  // namespace

std::shared_ptr<Step> read_piston(TableReader& table, const std::vector<ToolSpec>& tools) {
  const auto moving = read_moving_tools(table, tools);
  ForceControl control;
  table.require("direction", "\"-z\"");
  control.axis.direction = *table.direction("direction");
  read_forces(table, control);
  control.speed_limit = table.required_quantity("speed_limit", kSpeed);
  control.travel = table.required_quantity("travel", kTravel);
  control.back = table.quantity("back", kBack).value_or(0);
  return finished(table, moving, control);
}

std::shared_ptr<Step> read_rotor(TableReader& table, const std::vector<ToolSpec>& tools) {
  const auto moving = read_moving_tools(table, tools);
  ForceControl control;
  control.turns = true;
  control.axis = read_rotation_axis(table);
  control.speed_limit = table.required_quantity("speed_limit", kTurnSpeed);
  control.back = table.quantity("back", kBackTurn).value_or(0);
  control.travel = std::numeric_limits<double>::infinity();
  const auto torque = table.quantity("torque", kTorque);
  if (table.has("torques")) {
    if (torque) table.reject("torque", "torques are given as well; remove one of the two");
    read_torques(table, control);
    return finished(table, moving, control);
  }
  read_turn(table, control);
  if (torque) {
    control.targets = {*torque};
    return finished(table, moving, control);
  }
  for (const char* key : {"gain", "integral_time", "back"})
    if (table.has(key))
      table.reject(key,
                   "without a torque the tool turns at its speed_limit; remove the key, or add a torque");
  return std::make_shared<ControlledTool>(moving, control, table.quantity("duration", kDuration));
}

}  // namespace diefill::process
