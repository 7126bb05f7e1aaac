#include "process/machine/force_control.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "process/machine/moving_tool.h"
#include "process/results/word_list.h"

namespace diefill::process {

double ForceControl::wanted(const ControlState& state) const {
  if (targets.empty()) return 0;
  return targets[std::min<std::size_t>(state.passed, targets.size() - 1)];
}

double ForceControl::largest_target() const {
  return *std::max_element(targets.begin(), targets.end());
}

bool ForceControl::done(const ControlState& state) const {
  constexpr double kRounding = 1e-9;
  if (pause && state.passed >= targets.size() + (retreat > 0 ? 1 : 0)) return true;
  if (ends_at_travel && state.coordinate >= travel * (1 - kRounding)) return true;
  return state.steady.steady > 0;
}

bool ForceControl::is_at_its_limit(const ControlState& state) const {
  if (targets.empty() || state.passed >= targets.size() || state.reached >= 0) return false;
  constexpr double kRounding = 1e-9;
  if (wanted(state) > state.last) return state.coordinate >= travel * (1 - kRounding);
  return state.coordinate <= -back * (1 - kRounding);
}

double ForceControl::resistance(const Eigen::Vector3d& force, const Eigen::Vector3d& torque,
                                const Eigen::Vector3d& place) const {
  if (!turns) return -axis.direction.dot(force);
  return -axis.direction.dot(torque + (place - axis.through).cross(force));
}

/// N (N m), to which deviations are relative. Powder that was pressed harder before, in this step or before
/// it, is as stiff as that load has left it.
double ForceControl::scale(const ControlState& state) const {
  if (state.passed > 0) return std::max(wanted(state), targets[state.passed - 1]);
  return back > 0 ? std::max(wanted(state), std::abs(state.load)) : wanted(state);
}

void ForceControl::pass_targets(ControlState& state, double measured, double now) const {
  if (!pause || state.passed >= targets.size()) return;
  const double target = wanted(state), whole = target > 0 ? target : scale(state);
  // The resistance of a few grains fluctuates about 0 by more than a share of what it was.
  const double before = state.passed > 0 ? 1 : state.load;
  const bool freed = !(target > 0) && measured * before <= 0;
  if (state.reached < 0 && (freed || std::abs(measured - target) <= kReached * whole)) state.reached = now;
  if (state.reached < 0 || now - state.reached < *pause) return;
  ++state.passed;
  state.reached = -1;
  state.integral = 0;
  state.turned_back = state.coordinate;
}

double ForceControl::requested_rate(ControlState& state, double measured, double interval) const {
  if (targets.empty()) return speed_limit;
  const double target = wanted(state), whole = scale(state);
  if (!(whole > 0)) return 0;
  const double proportional = gain * speed_limit * (target - measured) / whole;
  // An integral that grew on the way to the target would press beyond it. A rotor that turns steadily needs
  // it at any distance, but not while the torque nears the target by itself or the limit acts.
  const double grown = state.integral + proportional * interval / integral_time;
  const bool nears = (measured - state.last) * (target - measured) > 0;
  const bool grows = turns ? !nears && std::abs(proportional + grown) < speed_limit
                           : std::abs(target - measured) <= kNear * target;
  if (grows) state.integral = grown;
  return std::clamp(proportional + state.integral, -speed_limit, speed_limit);
}

void ForceControl::update(ControlState& state, double measured, double now, double interval) const {
  state.coordinate = state.coordinate_at(now);
  state.since = now;
  if (state.updates++ == 0) state.load = state.last = measured;
  if (steady) state.steady.add(*steady, state.coordinate, measured, interval);
  pass_targets(state, measured, now);
  double least = -back;
  if (targets.empty() || state.passed < targets.size()) {
    state.rate = requested_rate(state, measured, interval);
    state.last = measured;
  } else {
    least = std::max(-back, state.turned_back - retreat);
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
  const std::string unit = control_.turns ? " N m" : " N";
  const std::string tools = results::and_list(tools_) + (control_.turns ? " turned " : " pressed ");
  if (control_.targets.empty())
    return tools + "at " + number_text(control_.speed_limit * 30 / std::numbers::pi) + " rpm";
  std::string targets = number_text(control_.targets.front());
  if (control_.targets.size() > 1)
    targets += " to " + number_text(control_.targets.back()) + unit + " in " +
               std::to_string(control_.targets.size()) + (control_.turns ? " torques" : " loads");
  else
    targets += unit;
  return tools + "with " + targets;
}

}  // namespace diefill::process
