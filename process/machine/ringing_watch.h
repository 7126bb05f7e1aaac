// Detects unstable force control: with too high a gain a tool overcorrects every deviation and bounces on the
// powder instead of pressing it (engine/STABILITY.md, force-controlled pistons).
#pragma once

#include <cstdint>
#include <string>

namespace diefill::process {

struct ForceControl;

/// Counts oscillations of the powder's resistance about the target. A plain value, so that a checkpoint can
/// store it.
struct RingingWatch {
  static constexpr std::uint32_t kMaxSwings = 40;   ///< swings in a row before control is said to ring
  static constexpr double kLow = 0.5, kHigh = 1.5;  ///< ends of a swing, over the wanted resistance

  std::uint32_t swings = 0;        ///< from one end to the other, in a row
  bool high = false;               ///< at which end the last one ended
  double last = 0;                 ///< s, when it did
  double lowest = 0, highest = 0;  ///< of the resistance over the wanted one, since the first of them

  /// Adds the resistance over the target at `now` (s); a pause longer than `longest` (s) ends a row.
  void add(double share, double now, double longest);
  bool rings() const { return swings >= kMaxSwings; }
};

/// Checks the `measured` resistance (N or N m) of powder to `tools` under `control` with a `target`, where
/// nothing else moves tools. Throws engine::OutOfRange when it keeps oscillating.
void watch_for_ringing(RingingWatch& watch, const ForceControl& control, double target, double measured,
                       double now, const std::string& tools);

}  // namespace diefill::process
