#include "engine/simulation/step_policy.h"

#include "engine/simulation/every_grain.h"
#include "engine/simulation/riding_policy.h"
#include "engine/simulation/step_phases.h"

namespace diefill::engine {

void StepPolicy::move_tools(SimulationState& state) {
  move_bodies(state);
}

std::unique_ptr<StepPolicy> policy_for(const SimulationSettings& settings) {
  if (!settings.sleep) return std::make_unique<EveryGrain>();
  if (!settings.sleep->carrier) return std::make_unique<SleepPolicy>();
  return std::make_unique<RidingPolicy>();
}

}  // namespace diefill::engine
