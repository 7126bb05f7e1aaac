// The step in which sleeping grains move with a body that does not turn, such as a shoe.
#pragma once

#include "engine/simulation/sleep_policy.h"

namespace diefill::engine {

/// Sleepers are carried along with SleepSettings::carrier. The ledger has what holds them.
class CoMovingPolicy final : public SleepPolicy {
 public:
  void move_tools(SimulationState& state) override;
  double advance_block(SimulationState& state, std::size_t b) override;
  void before_search(SimulationState& state) override;
  void compute_forces(SimulationState& state) override;
  void end_step(SimulationState& state) override;

 protected:
  void compute_resting_block(SimulationState& state, std::size_t b) override;
  void finish_resting_block(SimulationState& state, std::size_t b) override;
  void finish_block(SimulationState& state, std::size_t b, const ContactSums& contacts) override;
  /// Powder that is carried falls asleep when contacts are searched anyway, which is often.
  void put_candidates_to_sleep(SimulationState&) override {}

 private:
  void take_to(SimulationState& state, const Eigen::Vector3d& velocity);

  Eigen::Vector3d carried_ = Eigen::Vector3d::Zero();  ///< m, how far sleepers are carried in this step
  std::vector<Eigen::Vector3d> acting_;  ///< N a block, contacts and weight of all that are carried asleep
};

}  // namespace diefill::engine
