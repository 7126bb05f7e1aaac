#include "engine/simulation/step_policy.h"

#include "engine/simulation/all_grains_policy.h"
#include "engine/simulation/co_moving_policy.h"
#include "engine/simulation/step_phases.h"

namespace diefill::engine {

void StepPolicy::move_tools(SimulationState& state) {
  move_bodies(state);
}

std::unique_ptr<StepPolicy> policy_for(const SimulationSettings& settings) {
  if (!settings.sleep) return std::make_unique<AllGrainsPolicy>();
  if (!settings.sleep->carrier) return std::make_unique<SleepPolicy>();
  return std::make_unique<CoMovingPolicy>();
}

}  // namespace diefill::engine
