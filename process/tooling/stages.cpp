#include "process/tooling/stages.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "process/machine/actions/powder_inflow.h"
#include "process/machine/actions/settle.h"
#include "process/machine/motions/passage.h"

namespace diefill::process {

namespace {

constexpr double kUnknown = -1;

bool moves_tool(const Step& step, const std::string& tool) {
  const auto tools = step.tools();
  return std::find(tools.begin(), tools.end(), tool) != tools.end();
}

/// s from the step's start that are looked at: of very many passages the first four, as powder may have come
/// on the second time to where it was not on the first; more go the same way again.
double looked_at(const Step& step, double length) {
  constexpr int kMany = 8, kEnough = 4;  // passages
  const auto* passage = dynamic_cast<const Passage*>(&step);
  if (passage == nullptr || passage->spec().passages <= kMany) return length;
  return length * kEnough / passage->spec().passages;
}

/// Whether the first step is the settling of the poured powder.
bool begins_with_settling(const std::vector<std::shared_ptr<const Step>>& steps) {
  const auto* settle = steps.empty() ? nullptr : dynamic_cast<const Settle*>(steps.front().get());
  return settle != nullptr && settle->from_start();
}

/// A settling that starts by itself after all others is one that ends the scene.
bool ends_with_settling(const std::vector<std::shared_ptr<const Step>>& steps) {
  if (steps.empty()) return true;
  const bool in_turn =
      std::all_of(steps.begin(), steps.end(), [](const auto& step) { return !step->plan.start; });
  const Step& last = *steps.back();
  return in_turn && last.open_ended() && last.tools().empty() && last.inflow() == nullptr && !last.plan.until;
}

ToolMotion motion_at(const Step& step, const StepState& state, double time) {
  const double stop = state.stop_requested < 0 ? kUnknown : state.stop_requested - state.started;
  const double since = std::clamp(time - state.started, 0.0, step_length(step, stop));
  ToolMotion motion;
  if (const ForceControl* control = step.control())
    motion =
        control->motion(state.control.coordinate_at(state.has_ended() ? std::min(time, state.ended) : time),
                        state.control.rate);
  else
    motion = stop < 0 ? step.motion(since) : step.motion_stopped(since, stop);
  if (!state.has_ended()) return motion;
  motion.velocity.setZero();
  motion.angular_velocity.setZero();
  return motion;
}

double predicted_start(std::size_t k, const Stages& stages, const std::vector<StepState>& states) {
  if (k == 0) return 0;
  const auto& start = stages.steps[k]->plan.start;
  if (start) return counts_from(*start, stages, states).value_or(kUnknown);
  if (!(stages.settle_added && k + 1 == stages.size())) return states[k - 1].ended;
  double last = 0;
  for (std::size_t other = 0; other < k; ++other) {
    if (states[other].ended < 0) return kUnknown;
    last = std::max(last, states[other].ended);
  }
  return last;
}

/// Whether the step ends when its mass is fed, unless its plan stops it before.
bool feeds_mass(const Step& step) {
  return step.inflow() != nullptr && step.inflow()->mass;
}

/// s that it takes to feed the step's mass at its rate, where it has both.
std::optional<double> feeding_time(const Step& step) {
  if (!feeds_mass(step) || !step.inflow()->rate) return std::nullopt;
  return *step.inflow()->mass / *step.inflow()->rate;
}

void predict_end(std::size_t k, const Stages& stages, std::vector<StepState>& states, double settling_time) {
  const Step& step = *stages.steps[k];
  StepState& state = states[k];
  const auto duration = step.duration();
  double stop = state.started + feeding_time(step).value_or(settling_time);
  if (step.plan.until && (step.open_ended() || feeds_mass(step))) {
    const auto counts = counts_from(*step.plan.until, stages, states);
    if (!counts) return;
    const double met = std::max(*counts, state.started) + (step.plan.until->measures() ? settling_time : 0.0);
    stop = step.open_ended() ? met : std::min(stop, met);
  }
  if (!step.open_ended() && duration) {
    state.ended = state.started + *duration;
  } else if (step.tools().empty() || step.control() != nullptr) {
    state.ended = stop;
  } else {
    state.stop_requested = stop;
    state.ended = state.started + step_length(step, stop - state.started);
  }
  // Under force control: as far as it may go.
  if (const ForceControl* control = step.control()) {
    state.control.since = state.ended;
    const double lasted = state.ended - state.started;
    state.control.coordinate = std::min(control->travel, control->speed_limit * lasted);
    state.control.rate = state.control.coordinate / lasted;
  }
}

}  // namespace

Stages::Stages(const Scene& scene) {
  // Grains that a file places are at rest, and those that nothing moves; other scenes may say how long to
  // wait.
  const bool rests = scene.pour.grains_file || (scene.gravity.isZero() && scene.pour.rim_speed == 0) ||
                     begins_with_settling(scene.steps);
  steps.push_back(std::make_shared<Settle>(rests ? std::optional(0.0) : std::nullopt));
  steps.insert(steps.end(), scene.steps.begin(), scene.steps.end());
  settle_added = !ends_with_settling(scene.steps);
  if (settle_added) steps.push_back(std::make_shared<Settle>(std::nullopt));
}

std::size_t Stages::index_of(const std::string& name) const {
  for (std::size_t k = 1; k < steps.size(); ++k)
    if (!name.empty() && steps[k]->plan.name == name) return k;
  return 0;
}

bool Stages::moves(const std::string& tool) const {
  return std::any_of(steps.begin(), steps.end(), [&](const auto& step) { return moves_tool(*step, tool); });
}

bool Stages::stays(const std::string& tool) const {
  return std::all_of(steps.begin(), steps.end(),
                     [&](const auto& step) { return step->stays() || !moves_tool(*step, tool); });
}

std::optional<double> counts_from(const Condition& condition, const Stages& stages,
                                  const std::vector<StepState>& states) {
  const StepState& settling = states.front();
  if (!settling.has_ended()) return std::nullopt;
  double since = settling.ended;
  if (!condition.after.empty()) {
    const StepState& other = states[stages.index_of(condition.after)];
    if (!other.has_ended()) return std::nullopt;
    since = std::max(since, other.ended);
  }
  if (!condition.with.empty()) {
    const StepState& other = states[stages.index_of(condition.with)];
    if (other.is_pending()) return std::nullopt;
    since = std::max(since, other.started);
  }
  if (condition.at) since = std::max(since, settling.ended + *condition.at);
  return since + condition.delay;
}

double step_length(const Step& step, double stop_requested) {
  const double whole = step.open_ended() ? std::numeric_limits<double>::infinity()
                                         : step.duration().value_or(std::numeric_limits<double>::infinity());
  return stop_requested < 0 ? whole : std::min(whole, stop_requested + step.stopping_time(stop_requested));
}

ToolPose pose_of(const Stages& stages, const std::vector<StepState>& states, const std::string& tool,
                 double time) {
  ToolPose pose;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    if (states[k].is_pending() || time < states[k].started || !moves_tool(*stages.steps[k], tool)) continue;
    pose = compose(motion_at(*stages.steps[k], states[k], time), pose);
  }
  return pose;
}

std::vector<StepState> predicted(const Stages& stages, double settling_time) {
  std::vector<StepState> states(stages.size());
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t k = 0; k < stages.size(); ++k) {
      if (states[k].has_ended()) continue;
      if (states[k].is_pending()) states[k].started = predicted_start(k, stages, states);
      if (states[k].is_pending()) continue;
      predict_end(k, stages, states, settling_time);
      changed = changed || states[k].has_ended();
    }
  }
  return states;
}

std::vector<double> instants(const Stages& stages, const std::vector<StepState>& states, int dense) {
  constexpr int kSpread = 48;
  constexpr double kGoldenRatio = 0.6180339887498949;
  std::vector<double> times;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    if (stages.steps[k]->tools().empty()) continue;
    const double from = states[k].started, length = looked_at(*stages.steps[k], states[k].ended - from);
    const int count = stages.steps[k]->stays() ? kSpread : dense;
    for (int n = 1; n < count; ++n) {
      const double share =
          stages.steps[k]->stays() ? std::fmod(n * kGoldenRatio, 1.0) : static_cast<double>(n) / count;
      times.push_back(from + length * share);
    }
    for (const double point : stages.steps[k]->turning_points(length)) times.push_back(from + point);
    times.push_back(states[k].ended);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace diefill::process
