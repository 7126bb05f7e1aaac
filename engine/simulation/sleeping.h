// Settled grains put to sleep. A sleeping grain is held where it is: it is not carried through the steps, and
// where all grains of a block sleep, and all that its pairs reach, its pairs are not computed either. Awake
// grains meet sleeping ones as if these were part of a wall, friction springs included.
//
// A grain falls asleep when it and every grain it touches have been slow for a while, and no tool near it
// moves. It wakes when the force on it changes, when a grain that touches it is fast, or when a tool near it
// moves, and wakes those it touches with it. What sleeping costs is what awake powder would still have done:
// creep below the limits, and loads that pass through sleeping powder without being passed on until it wakes.
//
// Grains may sleep in the frame of a body that moves without turning: powder that rides in a shoe is carried
// along as a block.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/powder/particle_types.h"
#include "engine/search/neighbour_list.h"

namespace diefill::engine {

/// When grains fall asleep, and when they wake.
struct SleepSettings {
  double energy = 1e-4;  ///< over m g d: kinetic energy of a grain below which it counts as slow
  double time = 5e-3;    ///< s for which a grain and those it touches must have been slow
  double force = 0.5;    ///< over m g: by how much the force on a sleeping grain changes before it wakes
  double speed = 10;     ///< of a grain that wakes what it touches, over that at which it is just slow
  double stray = 0;      ///< over d: how far a grain may have got within `time`; 0: as far as it likes
  /// Number of the body in whose frame grains sleep; nothing: they stand still. Tools at rest in the
  /// laboratory then do not wake what is carried over them.
  std::optional<std::size_t> carrier;
  double acceleration = 0.1;               ///< over g: of the carrier, at which all wake
  std::vector<Eigen::AlignedBox3d> awake;  ///< m, laboratory frame: where nobody sleeps
};

/// Powder that rides on the body of number `carrier` sleeps in spite of what it feels of a floor it slides
/// over, bump by bump: what counts is that it gets nowhere, and it wakes when neighbours flow away. Powder
/// that must be free to flow is for SleepSettings::awake to name.
SleepSettings riding_on(std::size_t carrier);

/// All that a restart needs; entry k of every array belongs to grain k.
struct SleepState {
  std::vector<std::uint8_t> asleep;
  /// Looks in a row: of an awake grain those at which it was slow, of a sleeping one those since it fell
  /// asleep.
  std::vector<std::uint32_t> looks;
  std::vector<Eigen::Vector3d> force;  ///< N, on a sleeping grain when it was first looked at
  /// m, of an awake grain against its carrier when it began to be slow; empty where it may stray.
  std::vector<Eigen::Vector3d> place;
  std::uint64_t sphere_steps_left_out = 0;  ///< spheres of blocks at rest, summed over steps
};

/// Who sleeps, and which blocks rest.
class Sleeping {
 public:
  /// Sleepers are looked at every so many steps.
  static constexpr std::uint64_t kStepsPerLook = 10;

  /// Throws std::invalid_argument for limits that are not positive. `gravity` in m/s^2, `time_step` in s.
  Sleeping(const SleepSettings& settings, ParticleTypes kinds, const Eigen::Vector3d& gravity,
           double time_step);

  /// Limits follow the weight of the grains.
  void set_gravity(const SleepSettings& settings, const Eigen::Vector3d& gravity);

  const SleepState& state() const { return state_; }
  void restore(const SleepState& state) { state_ = state; }
  bool asleep(std::size_t grain) const { return state_.asleep[grain] != 0; }
  std::size_t sleepers() const;

  /// Sorts `order` so that awake grains come first, and follows it: entry k becomes the former entry
  /// order[k] of `grains`, of which the last ones may be new. Returns how many are awake.
  std::size_t reorder(std::vector<std::uint32_t>& order, std::size_t grains);
  /// Finds out which blocks rest.
  void sort_blocks(const NeighbourList& list);
  /// Whether neither pairs nor grains of block b need work.
  bool rests(std::size_t b) const { return rests_[b] != 0; }
  void count_step(const NeighbourList& list);

  /// Calls action(first, last) for each run of awake grains [first, last) within [begin, end).
  template <class Action>
  void for_awake(std::size_t begin, std::size_t end, const Action& action) const {
    for (std::size_t first = begin; first < end;) {
      if (asleep(first)) {
        ++first;
        continue;
      }
      std::size_t last = first + 1;
      while (last < end && !asleep(last)) ++last;
      action(first, last);
      first = last;
    }
  }

  /// J, of grain k against sleepers, which move with `carried` (m/s).
  double kinetic_energy(const Grains& grains, std::size_t k, const Eigen::Vector3d& carried) const;
  /// Takes down how slow every grain is against `carrier`; `grains.force` must be up to date for sleepers as
  /// well.
  void look(const Grains& grains, const BodyMotion& carrier);
  /// Sleepers that forces or fast neighbours wake now.
  std::vector<std::uint32_t> disturbed(const Grains& grains, const Eigen::Vector3d& carried,
                                       const NeighbourList& list, const SphereField& spheres) const;
  /// Sleepers in any of the boxes.
  std::vector<std::uint32_t> within(const std::vector<Eigen::AlignedBox3d>& boxes,
                                    const Grains& grains) const;
  /// Wakes these sleepers, and those that they touch.
  void wake(const std::vector<std::uint32_t>& sleepers, const NeighbourList& list,
            const SphereField& spheres);
  /// Grains that fall asleep now, none of them in any of the boxes: nobody while they are too few to be worth
  /// a search of contacts.
  std::vector<std::uint32_t> tired(const Grains& grains, const std::vector<Eigen::AlignedBox3d>& moving,
                                   const NeighbourList& list, const SphereField& spheres) const;
  void put_to_sleep(const std::vector<std::uint32_t>& grains);
  void wake_all(const NeighbourList& list);

 private:
  void watch(const Grains& grains, std::size_t k, const BodyMotion& carrier);
  std::vector<std::uint8_t> calm(const Grains& grains, const std::vector<Eigen::AlignedBox3d>& moving) const;

  /// When a grain of one kind is slow, and what wakes it or those it touches.
  struct Limits {
    double slow_energy, waking_energy;  ///< J
    double waking_force;                ///< N
    double stray;                       ///< m; 0: none
  };
  ParticleTypes types_;
  std::vector<Limits> limits_;  ///< one a kind
  std::uint32_t looks_needed_;
  SleepState state_;
  std::vector<std::uint8_t> rests_;  ///< one a block
};

}  // namespace diefill::engine
