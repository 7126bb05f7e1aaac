// The step that computes every grain.
#pragma once

#include <atomic>

#include "engine/simulation/step_policy.h"

namespace diefill::engine {

/// No grain sleeps. Large beds finish each block as soon as no other one needs its grains as they are.
class AllGrainsPolicy final : public StepPolicy {
 public:
  double advance_block(SimulationState& state, std::size_t b) override;
  void compute_forces(SimulationState& state) override;

 private:
  void compute_interleaved(SimulationState& state);

  /// Of blocks that a block still waits for in this step.
  std::vector<std::atomic<std::uint32_t>> awaited_;
};

}  // namespace diefill::engine
