// The DEM: owns powder, tools and contacts, and steps them through time.
#pragma once

#include <functional>

#include "engine/powder/new_grain.h"
#include "engine/simulation/settings.h"
#include "engine/simulation/simulation_state.h"
#include "engine/simulation/snapshot.h"
#include "engine/simulation/step_policy.h"

namespace diefill::engine {

struct ComputedStep;
struct NamedContacts;

/// Powder, tools and time. Same settings, grains and steps give bitwise the same state on any number of
/// threads. Figures that take more than a look at the state are free functions in ../observe.
class Simulation {
 public:
  /// Throws std::invalid_argument when the time step, the shapes, the types or a period cannot work.
  Simulation(const SimulationSettings& settings, std::vector<WallBodySpec> walls);
  // Defined in the source: every file that names a simulation would compile them again.
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// One time step (Bierwisch 2009, section 2.2). Throws OutOfRange when grains have flown beyond all bounds,
  /// where no contacts can be searched.
  void step();

  /// Adds grains at rest or moving; ids continue from the last one given. Throws std::invalid_argument for a
  /// particle type that there is not, and std::length_error for more spheres than can be numbered.
  void add_grains(const std::vector<NewGrain>& grains);
  /// Takes out every grain for which `leaves(position)` is true, called in their order; returns how many.
  std::size_t remove_grains(const std::function<bool(const Eigen::Vector3d&)>& leaves);
  /// Takes out the grains of these ids; returns how many there were.
  std::size_t remove_grains(const std::vector<std::uint64_t>& ids);
  /// From now on calls watch(k, before, now) for every grain k (its place in grains()) that is put back into
  /// the periodic box, from `before` to `now` (m); in a fixed order, and before grains are taken out.
  void watch_borders(std::function<void(std::size_t, const Eigen::Vector3d&, const Eigen::Vector3d&)> watch) {
    state_.border_watch = std::move(watch);
  }
  /// Prescribes a body's motion from now on: pose and velocity at time t (s since the start of the run).
  void set_motion(std::size_t body, std::function<BodyMotion(double)> motion);

  /// Gravity (m/s^2) from now on. All grains wake.
  void set_gravity(const Eigen::Vector3d& gravity);
  /// Contact laws from now on, for the same types and walls. Contacts keep the history of those parts of
  /// their law (normal, friction, rolling, attraction) that stay the same but for parameters; that of the
  /// others begins at 0. Where one loop is Bierwisch's tuned one and the other is not, all history begins at
  /// 0. All grains wake. Throws std::invalid_argument as the constructor does; the time step is the caller's
  /// to keep below the new critical one.
  void set_contact(const ContactLaws& contact);
  /// Every grain comes to rest: no velocity, no rotation. All grains wake.
  void stop_grains();
  /// Gives every grain added(id) (m/s) more velocity. All grains wake.
  void add_velocities(const std::function<Eigen::Vector3d(std::uint64_t)>& added);

  /// One time step that another program has computed (computed_step.h). Grains and contacts stay as they were
  /// until apply_computed_grains() is called.
  void apply_computed_step(const ComputedStep& computed);
  /// The powder as another program has computed it up to the present time: the same grains by their ids, in
  /// any order. Without contacts near pairs are those of before, and nothing that is derived from contacts is
  /// valid. Throws std::invalid_argument for other grains.
  void apply_computed_grains(const Grains& computed);
  void apply_computed_grains(const Grains& computed, const NamedContacts& of_grains,
                             const NamedContacts& of_walls);

  Snapshot snapshot() const;
  /// Resumes from `snapshot`, which must come from the same settings and walls; bodies' motions must have
  /// been set.
  void restore(const Snapshot& snapshot);
  std::uint64_t hash() const { return state_hash(state_.step, state_.grains); }

  /// All that there is, for functions that read it.
  const SimulationState& state() const { return state_; }
  const SimulationSettings& settings() const { return state_.settings; }
  std::uint64_t steps() const { return state_.step; }
  double time() const { return state_.time; }

  const Grains& grains() const { return state_.grains; }
  const ParticleTypes& types() const { return state_.types; }
  /// Of grain k.
  const GrainShape& shape_of(std::size_t k) const { return state_.shape_of(k); }
  /// rad/s, laboratory frame, of grain k.
  Eigen::Vector3d angular_velocity(std::size_t k) const;
  /// Spheres as the last contact computation saw them, grain after grain, images last.
  const SphereField& spheres() const { return state_.spheres; }
  /// m, of sphere k of spheres().
  double sphere_radius(std::size_t k) const {
    return state_.types.classes()[state_.spheres.class_of(k)].radius;
  }

  const std::vector<WallBody>& bodies() const { return state_.bodies; }
  /// Pose of body b at the present time.
  const BodyMotion& body_motion(std::size_t b) const { return state_.body_motion[b]; }
  /// Load on body b in the last step.
  const WallLoad& wall_load(std::size_t b) const { return state_.wall_loads[b]; }

  const NeighbourList& neighbours() const { return state_.list; }
  std::uint64_t searches() const { return state_.searches; }
  /// Pairs that touched in the last step.
  std::uint64_t touching_pairs() const { return state_.touching; }
  /// m, deepest overlap of the last step and of the whole run.
  double deepest_overlap() const { return state_.overlap.any(); }
  double deepest_overlap_of_run() const { return state_.overlap_of_run.any(); }
  /// The same, among grains and with walls.
  const DeepestOverlap& overlaps() const { return state_.overlap; }
  const DeepestOverlap& overlaps_of_run() const { return state_.overlap_of_run; }
  const Ledger& ledger() const { return state_.ledger; }
  const PhaseTimers& timers() const { return state_.timers; }
  /// From now on loop_times() gives how long each worker was busy (ThreadPool::time_loops).
  void time_loops() { state_.pool.time_loops(); }
  LoopTimes loop_times() const { return state_.pool.loop_times(); }

 private:
  template <class Change>
  void change_energy(const Change& change);
  std::size_t keep_grains(const std::vector<std::uint32_t>& staying);

  SimulationState state_;
  std::unique_ptr<StepPolicy> policy_;
};

}  // namespace diefill::engine
