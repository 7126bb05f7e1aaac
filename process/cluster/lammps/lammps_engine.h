// The engine of runs on many ranks: rank 0 has the run and sends commands to the others.
#pragma once

#include <deque>

#include "process/cluster/lammps/rank_engine.h"
#include "process/run/step_engine.h"

namespace diefill::process::cluster {

/// On rank 0. Other ranks serve() meanwhile and continue when it is destroyed.
class LammpsEngine final : public StepEngine {
 public:
  explicit LammpsEngine(RankEngine& ranks) : ranks_(ranks) {}
  ~LammpsEngine() override;
  LammpsEngine(const LammpsEngine&) = delete;
  LammpsEngine& operator=(const LammpsEngine&) = delete;

  void step(engine::Simulation& simulation, std::uint64_t sync_step) override;
  void sync_grains(engine::Simulation& simulation) override;
  void sync_contacts(engine::Simulation& simulation) override;
  bool contacts_are_synced() const override { return contacts_synced_; }
  std::string description() const override;
  int ranks() const override { return ranks_.ranks(); }
  /// The next step may be that of another simulation.
  void forget();

 private:
  void compute(engine::Simulation& simulation, std::uint64_t steps);

  RankEngine& ranks_;
  std::deque<engine::ComputedStep> computed_;   ///< steps that the simulation has not taken yet
  std::uint64_t searches_ = ~std::uint64_t{0};  ///< of the simulation when it and the ranks last agreed
  bool grains_synced_ = true, contacts_synced_ = true;
  std::vector<std::uint64_t> shares_;
};

/// What ranks other than 0 do until rank 0 has no more to do.
void serve(RankEngine& ranks);

}  // namespace diefill::process::cluster
