// The step that leaves sleeping grains where they are.
#pragma once

#include "engine/simulation/step_policy.h"

namespace diefill::engine {

/// Blocks in which all grains, and all that their pairs reach, sleep are computed once, when contacts have
/// been searched; in the others the awake grains are moved. The rules are in sleep_rules.h.
class SleepPolicy : public StepPolicy {
 public:
  void move_tools(SimulationState& state) override;
  double advance_block(SimulationState& state, std::size_t b) override;
  std::size_t sort(SimulationState& state, std::vector<std::uint32_t>& order) override;
  void after_search(SimulationState& state) override;
  void compute_forces(SimulationState& state) override;
  void end_step(SimulationState& state) override;

 protected:
  /// The contacts of a block that rests, and what follows from them.
  virtual void compute_resting_block(SimulationState&, std::size_t) {}
  virtual void finish_resting_block(SimulationState&, std::size_t) {}
  /// `contacts`: gathered for the block's grains.
  virtual void finish_block(SimulationState& state, std::size_t b, const ContactSums& contacts);
  /// Puts candidates (sleep_candidates()) to sleep; at every check.
  virtual void put_candidates_to_sleep(SimulationState& state);

  /// Whether any grain falls asleep: contacts must then be searched.
  static bool fall_asleep(SimulationState& state);
  void wake_all(SimulationState& state);

 private:
  void wake_these(SimulationState& state, const std::vector<std::uint32_t>& sleepers);
  const ContactSums& gathered_copy(const SimulationState& state, std::size_t b,
                                   BlockWorkspace& workspace) const;
  void compute_blocks_at_rest(SimulationState& state);
  void update_forces_on_sleepers(SimulationState& state) const;

  std::vector<std::uint8_t> rests_;  ///< one a block: 1 where neither pairs nor grains need work
};

}  // namespace diefill::engine
