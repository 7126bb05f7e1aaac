// Settled grains put to sleep. A sleeping grain is held where it is: it is not carried through the steps, and
// where all grains of a block sleep, and all that its pairs reach, its pairs are not computed either. Awake
// grains meet sleeping ones as if these were part of a wall, friction springs included.
//
// A grain falls asleep when it and every grain it touches have been slow for a while, and no tool near it
// moves. It wakes when the force on it changes, when a grain that touches it is fast, or when a tool near it
// moves, and wakes those it touches with it. What sleeping costs is what awake powder would still have done:
// creep below the limits, and loads that pass through sleeping powder without being passed on until it wakes.
//
// Grains may sleep in the frame of a body that moves without turning: powder in a moving shoe is carried
// along as a block.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

namespace diefill::engine {

/// When grains fall asleep, and when they wake.
struct SleepSettings {
  double energy = 1e-4;  ///< over m g d: kinetic energy of a grain below which it counts as slow
  double time = 5e-3;    ///< s for which a grain and those it touches must have been slow
  double force = 0.5;    ///< over m g: by how much the force on a sleeping grain changes before it wakes
  double speed = 10;     ///< of a grain that wakes what it touches, over that at which it is just slow
  double stray = 0;      ///< over d: how far a grain may have got within `time`; 0: no limit
  /// Number of the body in whose frame grains sleep; nothing: they stand still. Tools at rest in the
  /// laboratory then do not wake what is carried over them.
  std::optional<std::size_t> carrier;
  double acceleration = 0.1;               ///< over g: of the carrier, at which all wake
  std::vector<Eigen::AlignedBox3d> awake;  ///< m, laboratory frame: where no grain sleeps
};

/// Settings for powder that moves with the body of number `carrier`: it sleeps although the floor it slides
/// over exerts varying forces on it, as long as it does not move relative to the carrier, and wakes when
/// neighbours flow away. Powder that must be free to flow is for SleepSettings::awake to name.
SleepSettings co_moving_with(std::size_t carrier);

/// Throws std::invalid_argument for limits that are not positive.
void check(const SleepSettings& settings);

/// Which grains sleep, and all that a restart needs of it; entry k of every array belongs to grain k. Empty
/// where no grains are put to sleep.
struct SleepState {
  std::vector<std::uint8_t> asleep;
  /// Consecutive checks: of an awake grain those at which it was slow, of a sleeping one those since it fell
  /// asleep.
  std::vector<std::uint32_t> checks;
  std::vector<Eigen::Vector3d> force;  ///< N, on a sleeping grain when it was first checked
  /// m, of an awake grain against its carrier when it began to be slow; empty where it may stray.
  std::vector<Eigen::Vector3d> place;
  std::uint64_t sphere_steps_left_out = 0;  ///< spheres of blocks at rest, summed over steps

  bool sleeps(std::size_t grain) const { return !asleep.empty() && asleep[grain] != 0; }
  std::size_t sleepers() const;
  /// Makes room for `grains`, of which the new ones are awake.
  void resize(std::size_t grains, const SleepSettings& settings);
  /// Entry k becomes the former entry order[k]; others are lost.
  void reorder(const std::vector<std::uint32_t>& order);
  void put_to_sleep(const std::vector<std::uint32_t>& grains);
  void wake(std::size_t grain);
  void wake_all();

  /// Calls action(first, last) for each run of awake grains [first, last) within [begin, end).
  template <class Action>
  void for_awake(std::size_t begin, std::size_t end, const Action& action) const {
    for (std::size_t first = begin; first < end;) {
      if (sleeps(first)) {
        ++first;
        continue;
      }
      std::size_t last = first + 1;
      while (last < end && !sleeps(last)) ++last;
      action(first, last);
      first = last;
    }
  }
};

}  // namespace diefill::engine
