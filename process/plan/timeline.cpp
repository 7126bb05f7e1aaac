#include "process/plan/timeline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "process/machine/actions/clear.h"
#include "process/machine/actions/powder_inflow.h"
#include "process/powder/material.h"
#include "process/powder/powder_mixture.h"
#include "process/setup/pour.h"
#include "process/tooling/half_model.h"

namespace diefill::process::plan {

namespace {

bool is_active(const StepState& state, double time) {
  return !state.is_pending() && state.started <= time && (state.ended < 0 || time < state.ended);
}

/// Grains that the cavities hold when they are full.
double grains_in_cavity(const Scene& scene, const Tooling& tooling, const engine::GrainShape& shape) {
  return tooling.cavity.found
             ? tooling.all_cavities().volume * expected_solid_fraction(scene) / shape.solid_volume
             : 0;
}

/// Grains, of both halves in a half model, that a step has let in by `time`. Without rate and mass it follows
/// what runs out, so that their number stays.
double grains_let_in(const Scene& scene, const PowderInflow& inflow, const StepState& state, double time) {
  const double elapsed = (state.has_ended() ? std::min(time, state.ended) : time) - state.started;
  const double mass_of_one = mean_of_inflow(scene, inflow).mass;
  if (inflow.rate)
    return std::min(*inflow.rate * elapsed, inflow.mass.value_or(std::numeric_limits<double>::infinity())) /
           mass_of_one;
  const double lasted = std::max(1e-12, state.ended - state.started);
  return inflow.mass.value_or(0) / mass_of_one * std::min(1.0, elapsed / lasted);
}

/// Grains over those poured at `time`: steps let some in and take some away.
double share_at(double time, const Scene& scene, const Tooling& tooling, const Stages& stages,
                const std::vector<StepState>& states) {
  const auto shape = mean_grain(scene);
  const double poured = copies(tooling) * static_cast<double>(grains_to_pour(scene));
  double grains = poured;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    if (states[k].is_pending() || states[k].started > time) continue;
    if (const PowderInflow* inflow = stages.steps[k]->inflow())
      grains += grains_let_in(scene, *inflow, states[k], time);
    const PowderRemoval* removal = stages.steps[k]->removal();
    if (removal == nullptr || removal->above) continue;
    grains = removal->lowest ? *removal->lowest * grains
                             : std::min(grains, grains_in_cavity(scene, tooling, shape));
  }
  return grains / poured;
}

}  // namespace

const char* description(PhaseKind kind) {
  switch (kind) {
    case PhaseKind::fall:
      return "settling of the poured powder";
    case PhaseKind::motion:
      return "motion";
    case PhaseKind::rest:
      break;
  }
  return "rest";
}

double fall_time(const Scene& scene, const Tooling&) {
  const double height =
      std::max(0.0, pour_height(scene, engine_settings(scene, 1.0)) - scene.pour.fill_height);
  constexpr double kWeakest = 1;  // m/s^2: without gravity nothing falls
  return std::sqrt(2 * height / std::max(kWeakest, scene.gravity.norm()));
}

PhaseKind kind_of(const Stages& stages, const std::vector<StepState>& states) {
  if (states.front().is_active()) return PhaseKind::fall;
  for (std::size_t k = 0; k < stages.size(); ++k)
    if (states[k].is_active() && (!stages.steps[k]->tools().empty() || stages.steps[k]->inflow() != nullptr))
      return PhaseKind::motion;
  return PhaseKind::rest;
}

std::vector<Phase> timeline(const Scene& scene, const Tooling& tooling, const RestTimes& rest) {
  const Stages stages(scene);
  const auto states = predicted(stages, rest.after_motion);
  std::vector<double> times;
  for (const auto& state : states) {
    times.push_back(state.started);
    times.push_back(state.ended);
  }
  std::sort(times.begin(), times.end());
  std::vector<Phase> phases = {{PhaseKind::fall, fall_time(scene, tooling) + rest.after_fall, 1}};
  const double settled = states.front().ended;
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    if (times[k] < settled || times[k + 1] <= times[k]) continue;
    const double middle = 0.5 * (times[k] + times[k + 1]);
    std::vector<StepState> now = states;
    for (auto& state : now)
      if (is_active(state, middle)) state.ended = -1;
    const double share = share_at(middle, scene, tooling, stages, states);
    phases.push_back({kind_of(stages, now), times[k + 1] - times[k], share});
  }
  return phases;
}

}  // namespace diefill::process::plan
