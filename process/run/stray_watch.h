// Powder that comes into tools where no powder was expected, so that they carry no wall spheres there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "process/tooling/tooling.h"

namespace diefill::process {

/// A grain inside a tool that came in where the tool carries no wall spheres.
struct StrayGrain {
  std::uint64_t id = 0;
  std::size_t tool = 0;                             ///< index in Tooling::tools
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< m, laboratory frame
};

/// All that a restart needs of a watch.
struct StrayState {
  std::uint64_t grains = 0;                         ///< that came in
  std::uint64_t tool = 0;                           ///< of the first: index in Tooling::tools
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< m, of the first, laboratory frame
  double time = 0;                                  ///< s, when it was found
};

/// Counts grains that were removed because they had come into a tool where it has no wall spheres.
class StrayWatch {
 public:
  /// `tooling` must outlive it.
  explicit StrayWatch(const Tooling& tooling) : tooling_(tooling) {}

  /// Counts a grain that was removed at `time` (s).
  void count_removed(const StrayGrain& grain, double time);
  const StrayState& state() const { return state_; }
  void restore(const StrayState& state) { state_ = state; }

  /// How many of `poured` grains, where the first came in, and what to do; nothing where there were none.
  std::optional<std::string> warning(std::uint64_t poured) const;

 private:
  const Tooling& tooling_;
  StrayState state_;
};

}  // namespace diefill::process
