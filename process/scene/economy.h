// Approximations that save time: the table [economy].
#pragma once

#include <optional>
#include <string>

namespace diefill::process {

/// Each can be switched; process/scene/README.md states what each saves and costs.
struct EconomySpec {
  bool sleep = false;          ///< settled grains are held until something moves near them
  double sleep_after = 5e-3;   ///< s that a grain and its neighbours must have been slow
  double sleep_energy = 1e-4;  ///< over m g d: kinetic energy of a grain that counts as slow
  double wake_force = 0.5;     ///< over m g: change of the force on a sleeping grain that wakes it
  /// m beside every cavity: powder in the shoe that is farther away moves as a block.
  std::optional<double> carry_beyond;
  std::optional<int> mirror;              ///< 0: half model across the plane x = 0, 1: across y = 0
  bool drop_spilled = true;               ///< grains that leave the tools are taken out at once
  bool skip_far_walls = true;             ///< walls that powder cannot reach, or is far from, cost nothing
  std::string mirror_place, carry_place;  ///< of the keys in the scene file, for messages
};

}  // namespace diefill::process
