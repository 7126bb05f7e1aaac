// Whether the schedule can go on while the powder is at rest.
#include "engine/simulation/simulation.h"
#include "process/machine/actions/powder_inflow.h"
#include "process/powder/material.h"
#include "process/results/formatted.h"
#include "process/results/rounding.h"
#include "process/results/word_list.h"
#include "process/run/schedule.h"
#include "process/tooling/die_frame.h"
#include "process/tooling/half_model.h"

namespace diefill::process {

/// Whether a condition will be met without any change of the powder, but for steps that it waits for.
bool Schedule::time_fulfils(const Condition& condition, double now) const {
  const auto since = counts_from(condition, stages_, state_.steps);
  if (!since) return false;  // waits for another step
  return now < *since || !(condition.filled_mass || condition.force);
}

/// Whether powder still comes in: not where the box is so full that the step lags behind its rate.
bool Schedule::lets_powder_in(std::size_t k, const engine::Simulation& simulation) const {
  constexpr double kLag = 2;  // grains
  const PowderInflow& inflow = *stages_.steps[k]->inflow();
  if (!inflow.rate) return false;  // as fast as room comes free, so that it has come in already
  const StepState& state = state_.steps[k];
  const double mass_of_one = copies(tooling_) * mean_grain_mass(scene_, inflow, simulation);
  const double due = *inflow.rate * (simulation.time() - state.started) / mass_of_one;
  return static_cast<double>(state.grains_fed) > due - kLag;
}

/// Whether step k has brought its tools to the end of their way before the powder bears what it is to bear.
bool Schedule::has_no_way_left(std::size_t k) const {
  const ForceControl* law = stages_.steps[k]->control();
  return law != nullptr && law->is_at_its_limit(state_.steps[k].control);
}

std::string Schedule::why_no_way_left(std::size_t k) const {
  const ForceControl& law = *stages_.steps[k]->control();
  const ControlState& state = state_.steps[k].control;
  const char* unit = law.turns ? "N m" : "N";
  const bool forward = law.wanted(state) > state.last;
  return results::and_list(stages_.steps[k]->tools()) +
         results::formatted(
             " at the end of the way that \"%s\" allows: waits for %.3g %s, but the powder bears %.3g %s",
             !forward    ? "back"
             : law.turns ? "angle"
                         : "travel",
             law.wanted(state), unit, state.last, unit);
}

/// Whether step k moves something, or ends or starts as time passes or powder comes to rest.
bool Schedule::goes_on_by_itself(std::size_t k, const engine::Simulation& simulation) const {
  const Step& step = *stages_.steps[k];
  const StepState& state = state_.steps[k];
  const double now = simulation.time();
  if (state.has_ended()) return false;
  if (state.is_pending()) return step.plan.start && time_fulfils(*step.plan.start, now);
  if (state.stop_requested >= 0 || (!step.tools().empty() && !has_no_way_left(k))) return true;
  if (!step.open_ended() && step.duration()) return true;
  if (step.inflow() != nullptr && lets_powder_in(k, simulation)) return true;
  if (step.plan.until) return time_fulfils(*step.plan.until, now);
  return step.inflow() == nullptr && step.tools().empty();  // waits for rest
}

bool Schedule::waits_for_powder(const engine::Simulation& simulation) const {
  for (std::size_t k = 0; k < stages_.size(); ++k)
    if (goes_on_by_itself(k, simulation)) return false;
  return !finished();
}

/// The condition of step k that only powder could meet; null: there is none.
const Condition* Schedule::unmet_by(std::size_t k, double now) const {
  const StepState& state = state_.steps[k];
  const StepPlan& plan = stages_.steps[k]->plan;
  if (state.has_ended()) return nullptr;
  const auto& condition = state.is_pending() ? plan.start : plan.until;
  if (!condition || !condition->measures()) return nullptr;
  const auto since = counts_from(*condition, stages_, state_.steps);
  return since && now >= *since ? &*condition : nullptr;
}

std::string Schedule::unmet_condition(const engine::Simulation& simulation) const {
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    const Condition* condition = unmet_by(k, simulation.time());
    if (condition == nullptr) continue;
    if (condition->filled_mass)
      return condition->where + " waits for " + results::mass_text(*condition->filled_mass) +
             " in the cavity, which holds " + results::mass_text(filled_mass(simulation, tooling_));
    return condition->where + results::formatted(" waits for %.3g N on ", *condition->force) + condition->on +
           results::formatted(", which bears %.3g N", mean_force(condition->on));
  }
  for (std::size_t k = 0; k < stages_.size(); ++k)
    if (state_.steps[k].is_active() && has_no_way_left(k)) return why_no_way_left(k);
  return description() + " waits for room to let powder in";
}

}  // namespace diefill::process
