// Which grains a step computes: all of them, or only those that do not sleep. A simulation chooses once, from
// its settings; what differs between the two is in these few functions, and nowhere else.
#pragma once

#include <memory>

#include "engine/simulation/simulation_state.h"

namespace diefill::engine {

/// The parts of a step that sleeping changes, in the order in which a step comes to them.
class StepPolicy {
 public:
  virtual ~StepPolicy() = default;

  /// Puts all tools where they are at the present time.
  virtual void move_tools(SimulationState& state);
  /// Moves the grains of block b to the end of the step. Returns how far (m) any of their spheres can have
  /// moved against the drift of the powder; infinity where that is not known.
  virtual double advance_block(SimulationState& state, std::size_t b) = 0;
  /// The neighbour list has become too old and is about to be rebuilt.
  virtual void before_search(SimulationState&) {}
  /// Sorts `order`, of all grains in space, for the new list; returns how many of its first grains share
  /// blocks with each other only.
  virtual std::size_t sort(SimulationState&, std::vector<std::uint32_t>& order) { return order.size(); }
  /// There is a new list, with its histories.
  virtual void after_search(SimulationState&) {}
  /// Contact forces of all pairs, and from them the velocities of the grains.
  virtual void compute_forces(SimulationState& state) = 0;
  /// All of the step has been computed, its energies added up.
  virtual void end_step(SimulationState&) {}
};

/// The policy for these settings.
std::unique_ptr<StepPolicy> policy_for(const SimulationSettings& settings);

}  // namespace diefill::engine
