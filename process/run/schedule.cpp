#include "process/run/schedule.h"

#include <algorithm>
#include <cmath>

#include "engine/simulation/simulation.h"
#include "process/machine/actions/powder_inflow.h"
#include "process/machine/free_motion.h"
#include "process/machine/moving_tool.h"
#include "process/powder/material.h"
#include "process/results/word_list.h"
#include "process/tooling/die_frame.h"
#include "process/tooling/half_model.h"

namespace diefill::process {

namespace {

bool asks_for_loads(const Step& step) {
  const auto by_force = [](const std::optional<Condition>& condition) {
    return condition && condition->force.has_value();
  };
  return step.control() != nullptr || by_force(step.plan.start) || by_force(step.plan.until);
}

engine::BodyMotion body_motion(const ToolPose& pose) {
  return {pose.rotation, pose.translation, pose.velocity, pose.angular_velocity};
}

}  // namespace

Schedule::Schedule(const Scene& scene, const Tooling& tooling, double grain_diameter)
    : tooling_(tooling), grain_diameter_(grain_diameter), scene_(scene), stages_(scene) {
  for (const auto& step : stages_.steps) needs_loads_ = needs_loads_ || asks_for_loads(*step);
  for (const auto& snapshot : scene.snapshots)
    needs_loads_ = needs_loads_ || (snapshot.when && snapshot.when->force.has_value());
}

void Schedule::begin(engine::Simulation& simulation, const ScheduleState& state) {
  state_ = state;
  state_.steps.resize(stages_.size());
  if (needs_loads_) state_.loads.resize(tooling_.tools.size());
  if (state_.steps.front().is_pending()) state_.steps.front().started = simulation.time();
  set_motions(simulation);
}

void Schedule::observe(const engine::Simulation& simulation) {
  if (!needs_loads_) return;
  for (std::size_t k = 0; k < state_.loads.size(); ++k) {
    const engine::WallLoad load = whole_load(tooling_, simulation.wall_load(k));
    state_.loads[k].force += load.force;
    state_.loads[k].torque += load.torque;
  }
  ++state_.loads_summed;
}

bool Schedule::update(engine::Simulation& simulation) {
  if (finished()) return false;
  const double now = simulation.time();
  bool changed = false;
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    StepState& state = state_.steps[k];
    if (state.is_pending() ? !starts(k, simulation) : !state.is_active() || !ends(k, simulation)) continue;
    (state.is_pending() ? state.started : state.ended) = now;
    if (state.has_ended()) {
      state.control.coordinate = state.control.coordinate_at(now);
      state.control.rate = 0;
    }
    state.control.since = now;
    changed = true;
  }
  const bool controlled = control(simulation);
  for (auto& load : state_.loads) load = {};
  state_.loads_summed = 0;
  state_.last_update = now;
  if (changed || controlled) set_motions(simulation);
  return changed;
}

bool Schedule::starts(std::size_t k, const engine::Simulation& simulation) {
  const auto& start = stages_.steps[k]->plan.start;
  if (start) return holds(*start, state_.steps[k].start, simulation);
  if (!(stages_.settle_added && k + 1 == stages_.size())) return state_.steps[k - 1].has_ended();
  return std::all_of(state_.steps.begin(), state_.steps.end() - 1,
                     [](const StepState& state) { return state.has_ended(); });
}

bool Schedule::ends(std::size_t k, const engine::Simulation& simulation) {
  const Step& step = *stages_.steps[k];
  StepState& state = state_.steps[k];
  const double now = simulation.time();
  // Motions continue from their state at this call, so a stop requested now begins now.
  if (state.stop_requested < 0 && stops(k, simulation)) state.stop_requested = now;
  const double stop = state.stop_requested < 0 ? -1 : state.stop_requested - state.started;
  return now - state.started >= step_length(step, stop);
}

bool Schedule::stops(std::size_t k, const engine::Simulation& simulation) {
  const Step& step = *stages_.steps[k];
  StepState& state = state_.steps[k];
  if (const PowderInflow* inflow = step.inflow(); inflow != nullptr && inflow->mass) {
    const double mass_of_one = copies(tooling_) * mean_grain_mass(scene_, *inflow, simulation);
    // As PowderSource counts them: the product of both may be less than the mass by rounding.
    if (static_cast<double>(state.grains_fed) >= std::ceil(*inflow->mass / mass_of_one)) return true;
  }
  if (const ForceControl* law = step.control(); law != nullptr && law->done(state.control)) return true;
  if (step.plan.until) return holds(*step.plan.until, state.until, simulation);
  const bool only_waits = step.open_ended() && step.tools().empty() && step.inflow() == nullptr;
  return only_waits && state.until.rest.at_rest(simulation, grain_diameter_);
}

bool Schedule::holds(const Condition& condition, ConditionState& watch,
                     const engine::Simulation& simulation) const {
  const double now = simulation.time();
  const auto since = counts_from(condition, stages_, state_.steps);
  if (!since || now < *since) return false;
  if (watch.armed < 0) watch.armed = now;
  return measured(condition, watch, simulation);
}

bool Schedule::measured(const Condition& condition, ConditionState& watch,
                        const engine::Simulation& simulation) const {
  // Asked every time, so that the watch misses nothing while another part does not hold yet.
  const bool rests = !condition.at_rest || watch.rest.at_rest(simulation, grain_diameter_, condition.limits);
  if (condition.force && mean_force(condition.on) < *condition.force) return false;
  if (condition.filled_mass && filled_mass(simulation, tooling_) < *condition.filled_mass) return false;
  return rests;
}

double Schedule::mean_force(const std::string& tool) const {
  if (state_.loads_summed == 0) return 0;
  const LoadSum& load = state_.loads[tooling_.index_of(tool)];
  return load.force.norm() / static_cast<double>(state_.loads_summed);
}

double Schedule::mean_resistance(const Step& step, const engine::Simulation& simulation) const {
  if (state_.loads_summed == 0) return 0;
  double sum = 0;
  for (const auto& name : step.tools()) {
    const std::size_t k = tooling_.index_of(name);
    sum += step.control()->resistance(state_.loads[k].force, state_.loads[k].torque,
                                      simulation.body_motion(k).translation);
  }
  return sum / static_cast<double>(state_.loads_summed);
}

bool Schedule::prescribed_motion_is_on() const {
  const auto is_prescribed = [](const Step& step) {
    // A rotor without a torque turns at its speed, whatever the powder does.
    if (const ForceControl* law = step.control()) return law->targets.empty();
    return !step.tools().empty() && free_motion_of(step) == nullptr;
  };
  for (std::size_t k = 0; k < stages_.size(); ++k)
    if (state_.steps[k].is_active() && is_prescribed(*stages_.steps[k])) return true;
  return false;
}

bool Schedule::control(engine::Simulation& simulation) {
  const double now = simulation.time();
  const double interval = now - state_.last_update;
  bool any = false;
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    const ForceControl* law = stages_.steps[k]->control();
    StepState& state = state_.steps[k];
    if (law == nullptr || !state.is_active() || state.started >= now || !(interval > 0)) continue;
    const double resistance = mean_resistance(*stages_.steps[k], simulation);
    const double target = law->wanted(state.control);
    law->update(state.control, resistance, now, interval);
    if (prescribed_motion_is_on() || !(target > 0) || target != law->wanted(state.control))
      state.ringing = {};
    else
      watch_for_ringing(state.ringing, *law, target, resistance, now,
                        results::and_list(stages_.steps[k]->tools()));
    any = true;
  }
  return any;
}

void Schedule::set_motions(engine::Simulation& simulation) {
  for (std::size_t k = 0; k < tooling_.tools.size(); ++k)
    simulation.set_motion(k, [this, tool = tooling_.tools[k].spec.name](double time) {
      return body_motion(pose_of(stages_, state_.steps, tool, time));
    });
}

bool Schedule::finished() const {
  return std::all_of(state_.steps.begin(), state_.steps.end(),
                     [](const StepState& state) { return state.has_ended(); });
}

std::vector<results::Stage> Schedule::completed_stages() const {
  std::vector<results::Stage> completed_stages;
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    const StepState& state = state_.steps[k];
    if (!state.has_ended()) continue;
    std::string tools;
    for (const auto& tool : stages_.steps[k]->tools()) tools += (tools.empty() ? "" : ", ") + tool;
    completed_stages.push_back({tools, stages_.steps[k]->description(), state.started, state.ended});
  }
  return completed_stages;
}

std::string Schedule::description() const {
  std::string words;
  for (std::size_t k = 0; k < stages_.size(); ++k)
    if (state_.steps[k].is_active())
      words += (words.empty() ? "" : " and ") + stages_.steps[k]->description();
  return !words.empty() ? words : finished() ? "done" : "waiting for the next step";
}

double Schedule::time_left(double now, double settling_time) const {
  const auto plan = predicted(stages_, settling_time);
  // A step that has begun or ended shifts everything predicted after it by as much.
  double shift = 0, end = 0;
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    if (!state_.steps[k].is_pending()) shift = state_.steps[k].started - plan[k].started;
    if (state_.steps[k].has_ended()) shift = state_.steps[k].ended - plan[k].ended;
    if (!state_.steps[k].has_ended()) end = std::max(end, plan[k].ended);
  }
  return std::max(0.0, end + shift - now);
}

geometry::Box Schedule::swept() const {
  geometry::Box box = tooling_.all;
  const auto states = predicted(stages_, kSettlingGuess);
  for (const double time : instants(stages_, states, 200))
    for (const Tool& tool : tooling_.tools) {
      if (!stages_.moves(tool.spec.name)) continue;
      const ToolPose pose = pose_of(stages_, states, tool.spec.name, time);
      box.include(geometry::transformed(tool.mesh, pose.rotation, pose.translation).bounding_box());
    }
  return box;
}

}  // namespace diefill::process
