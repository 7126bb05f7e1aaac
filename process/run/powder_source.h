// Feeds powder into a running simulation: grains at random free places of a box, at a mass rate or as room
// becomes free.
#pragma once

#include <vector>

#include "engine/powder/new_grain.h"
#include "geometry/solid/solid_query.h"
#include "process/machine/actions/powder_inflow.h"
#include "process/run/schedule.h"
#include "process/tooling/tooling.h"

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::process {

/// All the steps of a scene that feed powder. Randomness depends on the scene's seed and the number of the
/// time step alone, so a restart needs no history. Powders and sizes of grains follow the scene's shares as
/// evenly as possible, one grain after the other, so that masses are met.
class PowderSource {
 public:
  /// Keeps references to both.
  PowderSource(const Scene& scene, const Tooling& tooling);

  bool any() const { return !sources_.empty(); }
  /// Adds what the active steps feed now, and counts it in the schedule; returns how many grains.
  std::size_t feed(engine::Simulation& simulation, Schedule& schedule) const;

 private:
  std::size_t owed(const PowderInflow& inflow, const StepState& state,
                   const engine::Simulation& simulation) const;
  std::vector<engine::NewGrain> placed(const PowderInflow& inflow, std::size_t wanted, std::size_t come,
                                       std::uint64_t seed, const engine::Simulation& simulation) const;
  bool free_of_tools(const Eigen::Vector3d& place, double radius, const engine::Simulation& simulation) const;

  const Scene& scene_;
  const Tooling& tooling_;
  std::vector<std::size_t> sources_;  ///< numbers of the steps
  std::vector<geometry::SolidQuery> solids_;
};

}  // namespace diefill::process
