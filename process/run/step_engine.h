// The interface between a run and an engine other than the built-in one, as on many machines. The run's
// simulation stays the one that is read, changed and stored; such an engine computes its steps.
#pragma once

#include <cstdint>
#include <string>

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::process {

/// Computes the steps of a simulation. Grains that come or go, laws, gravity and velocities that change are
/// noticed by themselves.
class StepEngine {
 public:
  virtual ~StepEngine() = default;

  /// Takes `simulation` one step further. Until its step `sync_step` grains are not needed, so that steps up
  /// to there may be computed at once; time, tools, loads and overlaps are right after every step. Motions of
  /// tools do not change before.
  virtual void step(engine::Simulation& simulation, std::uint64_t sync_step) = 0;
  /// Brings the simulation's grains to the present step, which must be a sync step.
  virtual void sync_grains(engine::Simulation& simulation) = 0;
  /// The same for grains and contacts: all of the state can then be read, changed and stored.
  virtual void sync_contacts(engine::Simulation& simulation) = 0;
  /// Whether this has been done at the present step.
  virtual bool contacts_are_synced() const = 0;

  /// For reports: "LAMMPS 20210929 on 4 ranks ...".
  virtual std::string description() const = 0;
  virtual int ranks() const = 0;
};

}  // namespace diefill::process
