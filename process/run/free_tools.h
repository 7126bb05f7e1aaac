// Tools that nothing drives during a run: released and held with their steps, their motion recorded.
#pragma once

#include <vector>

#include "engine/simulation/free_bodies.h"
#include "process/results/fill_result.h"
#include "process/run/schedule.h"

namespace diefill::process {

/// All that a restart needs of them.
struct FreeToolsState {
  std::vector<engine::FreeBody> bodies;
  std::vector<std::uint64_t> numbers;  ///< in the rows of each step of free motion
  std::vector<double> rows;            ///< of all, one step after the other
};

class FreeTools {
 public:
  /// Keeps references to both.
  FreeTools(const Scene& scene, const Tooling& tooling);

  /// To be called before and after every time step.
  void before_step(const engine::Simulation& simulation) { bodies_.before_step(simulation); }
  void after_step(engine::Simulation& simulation);
  /// To be called after every update of the schedule, which sets motions of all tools: releases those whose
  /// free motion has begun now, holds those whose has ended.
  void follow(const Schedule& schedule, engine::Simulation& simulation);

  FreeToolsState state() const;
  /// To be called when the schedule has begun and before the simulation is restored.
  void restore(const FreeToolsState& state, engine::Simulation& simulation);
  /// "motion of <tool>": place and velocity of the centre of mass, and angular velocity, over time.
  std::vector<results::ProbeSeries> recorded_motions() const;

 private:
  /// A step of free motion.
  struct RecordedMotion {
    std::size_t step;  ///< of the scene
    std::size_t body;
    std::vector<double> rows;
  };

  const Scene& scene_;
  const Tooling& tooling_;
  engine::FreeBodies bodies_;
  std::vector<RecordedMotion> recorded_;
};

}  // namespace diefill::process
