// A fluid of particles with solids in it (Bierwisch 2009, appendix A): the state, search, blocks and
// integrator of the powder's simulation, with the forces of dissipative particle dynamics.
#pragma once

#include "engine/fluid/fluid_policy.h"
#include "engine/simulation/contact_search.h"
#include "engine/simulation/snapshot.h"

namespace diefill::engine {

/// Everything that a run needs to resume bit for bit.
struct FluidSnapshot {
  Snapshot particles;
  std::vector<RigidSetMotion> solids;
};

/// Fluid, solids and time. Same settings, particles and steps give bitwise the same state on any number of
/// threads.
class FluidSimulation {
 public:
  /// Throws std::invalid_argument when constants, time step or a period cannot work.
  explicit FluidSimulation(const FluidSettings& settings);

  /// Fluid at these places (m) with these velocities (m/s). Throws std::invalid_argument for unequal numbers.
  void add_fluid(const std::vector<Eigen::Vector3d>& places, const std::vector<Eigen::Vector3d>& velocities);
  /// A solid, whose particles are numbered on from those there are. Throws what RigidSets::add() throws.
  /// Returns its number.
  std::size_t add_solid(const RigidSetSpec& solid) { return add_solids({solid}); }
  /// Several; returns the number of the first.
  std::size_t add_solids(const std::vector<RigidSetSpec>& solids);
  /// Force (N) on solid s beside that of particles, and velocity (m/s) along axes that are not free.
  void set_drive(std::size_t s, const Eigen::Vector3d& drive) { policy_.sets().set_drive(s, drive); }
  void set_velocity(std::size_t s, const Eigen::Vector3d& velocity) {
    policy_.sets().set_velocity(s, velocity);
  }

  /// One time step. Throws OutOfRange when particles have flown beyond all bounds.
  void step();

  FluidSnapshot snapshot() const;
  /// Resumes from a snapshot of a simulation of the same settings, fluid and solids.
  void restore(const FluidSnapshot& snapshot);
  std::uint64_t hash() const { return state_hash(state_.step, state_.grains); }

  const FluidSettings& settings() const { return settings_; }
  const SimulationState& state() const { return state_; }
  const Grains& particles() const { return state_.grains; }
  const RigidSets& solids() const { return policy_.sets(); }
  const FluidPolicy& policy() const { return policy_; }
  double time() const { return state_.time; }
  bool is_fluid(std::size_t k) const { return solids().set_of(state_.grains.id[k]) == RigidSets::kFluid; }

 private:
  void append(const std::vector<Eigen::Vector3d>& places, const std::vector<Eigen::Vector3d>& velocities);
  void search();
  bool shear_has_aged_list() const;
  ImageFinder images();

  FluidSettings settings_;
  double shear_margin_;  ///< m, that the list allows images of a sheared box to move
  SimulationState state_;
  FluidPolicy policy_;
};

}  // namespace diefill::engine
