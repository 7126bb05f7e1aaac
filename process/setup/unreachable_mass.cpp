#include "process/setup/unreachable_mass.h"

#include "process/machine/actions/powder_inflow.h"
#include "process/powder/powder_mixture.h"
#include "process/results/rounding.h"
#include "process/tooling/half_model.h"

namespace diefill::process {

namespace {

/// kg of all powder that the scene will ever have; nothing: not known before the run.
std::optional<double> whole_mass(const Scene& scene, const Tooling& tooling) {
  if (scene.pour.grains_file || scene.pour.state) return std::nullopt;
  double mass = copies(tooling) * static_cast<double>(grains_to_pour(scene)) * mean_of_poured(scene).mass;
  for (const auto& step : scene.steps) {
    const PowderInflow* inflow = step->inflow();
    if (inflow == nullptr) continue;
    if (!inflow->mass) return std::nullopt;
    mass += *inflow->mass;
  }
  return mass;
}

void refuse(const std::optional<Condition>& condition, double whole) {
  constexpr double kWholeGrains = 1.02;  // masses are met within grains, which may be few
  if (!condition || !condition->filled_mass || *condition->filled_mass <= kWholeGrains * whole) return;
  throw SceneError(condition->where + ": found a filled_mass of " +
                   results::mass_text(*condition->filled_mass) +
                   ", but all powder that is poured and let in weighs " + results::mass_text(whole) +
                   ": the condition is never met, and the run would not end; wait for less, or pour more");
}

}  // namespace

void refuse_unreachable_mass(const Scene& scene, const Tooling& tooling) {
  const auto whole = whole_mass(scene, tooling);
  if (!whole) return;
  for (const auto& step : scene.steps) {
    refuse(step->plan.start, *whole);
    if (step->open_ended()) refuse(step->plan.until, *whole);
  }
}

}  // namespace diefill::process
