// When a run stores intermediate results.
#pragma once

#include <string>
#include <vector>

#include "process/run/schedule.h"

namespace diefill::process {

/// State of a snapshot of the scene; a plain value, so that a checkpoint can store it.
struct SnapshotState {
  ConditionState watch;
  std::uint64_t taken = 0;
  double first = 0;  ///< s, when it was taken the first time
};

class Snapshots {
 public:
  /// Keeps a reference to the scene.
  explicit Snapshots(const Scene& scene) : specs_(scene.snapshots), states_(scene.snapshots.size()) {}

  /// Names of those to be taken now, each given once: those that repeat with a number appended, from 0001.
  std::vector<std::string> due(const Schedule& schedule, const engine::Simulation& simulation);

  /// True if none has been due, or watched for, before `now` (s) in a run whose steps stand like this.
  bool none_due_before(const Stages& stages, const std::vector<StepState>& steps, double now) const;

  const std::vector<SnapshotState>& state() const { return states_; }
  void restore(const std::vector<SnapshotState>& state) { states_ = state; }

 private:
  const std::vector<SnapshotSpec>& specs_;
  std::vector<SnapshotState> states_;
};

}  // namespace diefill::process
