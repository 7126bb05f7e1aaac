// The DEM: owns powder, tools and contacts, and steps them through time.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "engine/contact/air_flow.h"
#include "engine/contact/pair_loop.h"
#include "engine/integrate/grain_integrator.h"
#include "engine/numerics/phase_timers.h"
#include "engine/powder/particle_types.h"
#include "engine/search/adaptive_skin.h"
#include "engine/search/neighbour_list.h"
#include "engine/simulation/energy_ledger.h"
#include "engine/simulation/sleeping.h"
#include "engine/simulation/state.h"

namespace diefill::engine {

/// All that stays the same during a run. SI units.
struct SimulationSettings {
  std::vector<ParticleType> types = {{}};  ///< of the powder; grains refer to them by number
  /// Between all materials of grains, and of grains with walls.
  ContactLaws contact = one_powder({}, {});
  /// Of clumps; single spheres have none or their surface, after GrainShape::rotates.
  LeverArm lever_arm = LeverArm::contact;
  Eigen::Vector3d gravity = {0, 0, -9.81};  ///< m/s^2
  double air_viscosity = 0;                 ///< Pa s, Stokes drag on every sphere (Bierwisch 2009, Eq. 2.9)
  std::optional<AirFlow> air_flow;  ///< air that a tool draws through the powder; not where grains sleep
  double time_step = 0;             ///< s
  PeriodLengths period;             ///< m, box centred on the origin
  double skin = 0;                  ///< m; 0: follows the motion of the powder
  /// Tools far from all powder do not age the list of near pairs by moving.
  bool skip_far_walls = true;
  std::optional<SleepSettings> sleep;  ///< settled grains are put to sleep
  int threads = 1;
  InstructionSet instructions = best_instruction_set();  ///< all give the same bits

  /// Of the first type, which is the only one of most powders.
  GrainShape& shape() { return types.front().shape; }
  const GrainShape& shape() const { return types.front().shape; }
};

/// A grain to be added.
struct NewGrain {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();          ///< m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< m/s
  Quaternion orientation = {1, 0, 0, 0};                       ///< (w, x, y, z), body to laboratory
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s, laboratory frame
  TypeNumber kind = 0;                                         ///< of SimulationSettings::types
};

/// Force and torque of the powder on a wall body. Torque about the origin of the body's frame.
struct WallLoad {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< N m
};

/// The force of one contact on a grain, from another or from a wall.
struct ContactForce {
  std::size_t grain;          ///< place in Grains
  std::size_t other;          ///< the same; kNoGrain: a wall
  Eigen::Vector3d force;      ///< N, on grain
  Eigen::Vector3d arm;        ///< m, from the grain's centre to the contact
  Eigen::Vector3d other_arm;  ///< m, the same from the other's
};
inline constexpr std::size_t kNoGrain = static_cast<std::size_t>(-1);

/// Powder, tools and time. Same settings, grains and steps give bitwise the same state on any number of
/// threads.
class Simulation {
 public:
  /// Throws std::invalid_argument when the time step, the shape, the kinds or a period cannot work.
  Simulation(const SimulationSettings& settings, std::vector<WallBodySpec> walls);

  /// Adds grains at rest or moving; ids continue from the last one given. Throws std::invalid_argument for a
  /// kind that there is not.
  void add_grains(const std::vector<NewGrain>& grains);
  /// Takes out every grain for which `leaves(position)` is true, asked in their order; returns how many.
  std::size_t remove_grains(const std::function<bool(const Eigen::Vector3d&)>& leaves);
  /// Takes out the grains of these ids; returns how many there were.
  std::size_t remove_grains(const std::vector<std::uint64_t>& ids);
  /// Prescribes a body's motion from now on: pose and velocity at time t (s since the start of the run).
  void set_motion(std::size_t body, std::function<BodyMotion(double)> motion);

  /// Gravity (m/s^2) from now on. All grains wake.
  void set_gravity(const Eigen::Vector3d& gravity);
  /// Contact laws from now on, for the same types and walls. Contacts keep their history where the new laws
  /// remember the same numbers, and otherwise begin anew. All grains wake. Throws std::invalid_argument as
  /// the constructor does; the time step is the caller's to keep below the new critical one.
  void set_contact(const ContactLaws& contact);
  /// Gives every grain added(id) (m/s) more velocity. All grains wake.
  void add_velocities(const std::function<Eigen::Vector3d(std::uint64_t)>& added);

  /// One time step (Bierwisch 2009, section 2.2). Throws OutOfRange when grains have flown beyond all bounds,
  /// where no contacts can be searched.
  void step();

  std::uint64_t steps() const { return step_; }
  double time() const { return time_; }
  const SimulationSettings& settings() const { return settings_; }
  const Grains& grains() const { return grains_; }
  const ParticleTypes& types() const { return types_; }
  /// Of grain k.
  const GrainShape& shape_of(std::size_t k) const { return types_.shape(grains_.type_of(k)); }
  /// m, of sphere k of spheres().
  double sphere_radius(std::size_t k) const { return types_.classes()[spheres_.class_of(k)].radius; }
  /// Spheres of all grains.
  std::size_t sphere_count() const;
  /// kg, of grains [begin, end), added in their order.
  double mass_of(std::size_t begin, std::size_t end) const;
  const std::vector<WallBody>& bodies() const { return bodies_; }
  /// Pose of body b at the present time.
  const BodyMotion& body_motion(std::size_t b) const { return body_motion_[b]; }
  /// Load on body b in the last step.
  const WallLoad& wall_load(std::size_t b) const { return wall_loads_[b]; }
  const NeighbourList& neighbours() const { return list_; }
  const Ledger& ledger() const { return ledger_; }
  const PhaseTimers& timers() const { return timers_; }
  std::uint64_t searches() const { return searches_; }
  /// Pairs that touched in the last step.
  std::uint64_t touching_pairs() const { return touching_; }
  /// m, deepest overlap of the last step and of the whole run.
  double deepest_overlap() const { return overlap_now_.any(); }
  double deepest_overlap_of_run() const { return overlap_ever_.any(); }
  /// The same, among grains and with walls.
  const DeepestOverlap& overlaps() const { return overlap_now_; }
  const DeepestOverlap& overlaps_of_run() const { return overlap_ever_; }
  /// Those of the last step in block b of neighbours().
  const DeepestOverlap& overlaps_in_block(std::size_t b) const { return tallies_[b].overlap; }
  /// Angular velocity (rad/s) of grain k in the laboratory frame.
  Eigen::Vector3d angular_velocity(std::size_t k) const;
  /// Spheres as the last contact computation saw them, grain after grain, images last.
  const SphereField& spheres() const { return spheres_; }

  /// Visits the forces of all contacts of the last step, in a fixed order, with places and velocities as they
  /// are now; none before the first. For figures asked for now and then.
  void visit_contact_forces(const std::function<void(const ContactForce&)>& visit) const;

  /// Sleeping grains, and the sphere-steps that resting blocks have saved so far; 0 where no grains sleep.
  bool asleep(std::size_t k) const { return sleeping_ && sleeping_->asleep(k); }
  std::size_t sleepers() const { return sleeping_ ? sleeping_->sleepers() : 0; }
  std::uint64_t sphere_steps_left_out() const {
    return sleeping_ ? sleeping_->state().sphere_steps_left_out : 0;
  }

  /// Bytes that one step reads and writes at least: state of grains and spheres, near pairs and what touching
  /// ones remember, each counted once a pass.
  double bytes_moved_per_step() const;

  /// Energy of the powder now, summed in a fixed order.
  Energy energy() const;
  /// Difference between the energy there is and the energy the ledger expects, over the energy turned over so
  /// far.
  double energy_balance_error() const;

  Snapshot snapshot() const;
  /// Goes on from `snapshot`, which must come from the same settings and walls; bodies' motions must have
  /// been set.
  void restore(const Snapshot& snapshot);
  std::uint64_t hash() const { return state_hash(step_, grains_); }

 private:
  void advance_grains();
  void move_bodies();
  double remaining_skin(const Block& block) const;
  bool list_is_old() const;
  void wrap_grains();
  std::size_t keep_grains(const std::vector<std::uint32_t>& staying);
  void check_places() const;
  void sort_and_search();
  /// What touching pairs remember, by the numbers that spheres have in a new order.
  struct ContactHistories {
    ContactHistory grains, walls;
  };
  std::vector<std::uint32_t> order_in_space();
  ContactHistories remember_contacts(std::vector<std::uint32_t>& order);
  void search_again(const std::vector<std::uint32_t>& order, const ContactHistories& histories);
  void search_in_order(std::vector<std::uint32_t> order);
  template <class Change>
  void change_energy(const Change& change);
  void wake_everybody();
  void make_integrator();
  void search(const ContactHistory& history, const ContactHistory& wall_history);
  void remember_reference(std::size_t awake);
  void allow_motion();
  double farthest_allowance() const;
  void find_images();
  void compute_contacts();
  void compute_block(std::size_t b);
  void finish_grains();
  void finish_block(std::size_t b);
  void compute_and_finish();
  void gather(std::size_t b, ContactSums& contacts) const;
  void draw_air(std::size_t b, ContactSums& contacts);
  void book_step();
  ContactScene contact_scene(const LocalSpheres& local) const;

  // Where settled grains are put to sleep.
  std::vector<Eigen::AlignedBox3d> moving_tools() const;
  bool carries() const { return sleeping_ && settings_.sleep->carrier.has_value(); }
  BodyMotion carrier() const;
  void mind_tools(const BodyMotion& carrier_before);
  void take_to(const Eigen::Vector3d& velocity);
  void advance_awake(std::size_t b);
  void carry(const Block& block);
  void compute_resting();
  void slide(std::size_t b);
  const ContactSums& gathered_copy(std::size_t b) const;
  void finish_awake(std::size_t b, const ContactSums& contacts);
  void weigh_sleepers();
  void look_after_sleepers();
  bool fall_asleep();
  Eigen::Vector3d force_on_resting(std::size_t b) const;
  void settle_motion_of_sleepers();
  bool rests(std::size_t b) const { return sleeping_ && sleeping_->rests(b); }

  ParticleTypes types_;
  SimulationSettings settings_;
  ThreadPool pool_;
  PeriodicBox box_;
  std::vector<WallBody> bodies_;
  std::vector<BodyMotion> body_motion_;
  std::vector<WallLoad> wall_loads_;
  std::unique_ptr<PairLoop> grain_loop_, wall_loop_;
  NeighbourList list_;
  ListReference reference_;
  AdaptiveSkin skin_;
  GrainIntegrator integrator_;
  std::optional<Sleeping> sleeping_;

  Grains grains_;
  SphereField spheres_;
  std::vector<BlockTally> tallies_;
  /// Of blocks that a block still waits for in this step.
  std::vector<std::atomic<std::uint32_t>> awaited_;
  /// m a block, at most leeway(); 0: not known. Nobody's places need be looked at while it lasts.
  std::vector<double> remaining_skin_;
  std::vector<double> clearance_;  ///< m a body, how far it stood from the powder when contacts were searched
  Eigen::Vector3d carried_ = Eigen::Vector3d::Zero();  ///< m, how far sleepers are carried in this step

  std::size_t awake_in_order_ = 0;  ///< grains that were awake when the present order was made

  std::uint64_t step_ = 0, next_id_ = 0, searches_ = 0, touching_ = 0;
  double time_ = 0;
  DeepestOverlap overlap_now_, overlap_ever_;
  Ledger ledger_;
  PhaseTimers timers_;
};

}  // namespace diefill::engine
