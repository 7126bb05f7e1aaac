// Powder that leaks below the cavity: moving tools leave an opening there, which their CAD at rest does not
// show.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "process/tooling/tooling.h"

namespace diefill::process {

/// All that a restart needs of a watch.
struct LeakState {
  std::uint64_t grains = 0;  ///< that left beneath the cavities
  bool warned = false;       ///< by LeakWatch::first_warning()
};

/// Counts grains that left the computation below the cavities, however they were closed in the end.
class LeakWatch {
 public:
  /// `grain_diameter`: m, of the largest grains.
  LeakWatch(const Tooling& tooling, double grain_diameter);

  /// Counts a grain that was removed at `place` (m, frame of the die); one beside the cavities was
  /// spilled.
  void count_removed(const Eigen::Vector3d& place);
  std::uint64_t grains() const { return state_.grains; }
  const LeakState& state() const { return state_; }
  void restore(const LeakState& state) { state_ = state; }

  /// The message about `poured` grains in all; nothing for a few stray ones.
  std::optional<std::string> warning(std::uint64_t poured) const;
  /// The same at its first occurrence; nothing from then on.
  std::optional<std::string> first_warning(std::uint64_t poured);

 private:
  const Tooling& tooling_;
  geometry::Box below_;  ///< m, frame of the die; empty without a cavity
  LeakState state_;
};

}  // namespace diefill::process
