// The steps of a scene during a run: when each began and ended, and the resulting poses of the tools.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "process/machine/force_control.h"
#include "process/machine/ringing_watch.h"
#include "process/machine/step.h"
#include "process/tooling/rest.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

/// State of a condition.
struct ConditionState {
  double armed = -1;  ///< s, since when its measured parts count; negative: not yet
  RestWatch rest;
};

/// State of a step. All that a restart needs; a plain value, so that a checkpoint can store it.
struct StepState {
  double started = -1;         ///< s; negative: not yet
  double stop_requested = -1;  ///< s, when its plan requested the stop; negative: not yet
  double ended = -1;           ///< s; negative: not yet
  ConditionState start, until;
  ControlState control;          ///< of a step under force control
  RingingWatch ringing;          ///< the same
  std::uint64_t grains_fed = 0;  ///< of a step that lets powder in

  bool is_pending() const { return started < 0; }
  bool is_active() const { return started >= 0 && ended < 0; }
  bool has_ended() const { return ended >= 0; }
};

/// A settling, the scene's steps, and a settling that waits for all of them, unless the scene ends with one.
struct Stages {
  std::vector<std::shared_ptr<const Step>> steps;
  bool settle_added = false;  ///< at the end

  explicit Stages(const Scene& scene);
  std::size_t size() const { return steps.size(); }
  /// Number of the step of that name; the first, a settling without name, if there is none.
  std::size_t index_of(const std::string& name) const;
  /// True if every step that moves the tool leaves it at its place in the long run.
  bool stays(const std::string& tool) const;
  bool moves(const std::string& tool) const;
};

/// s from which on a condition counts: what it comes after or with, its time and its delay are then
/// fulfilled. Nothing as long as that is not known, and before the poured powder has come to rest.
std::optional<double> counts_from(const Condition& condition, const Stages& stages,
                                  const std::vector<StepState>& states);

/// s after which the step is over that was stopped at `stop_requested`, or not (negative); both since
/// its start. Infinite while it is left open.
double step_length(const Step& step, double stop_requested);

/// Pose of a tool at `time` (s), with the displacements of all steps, the first of the scene applied first.
ToolPose pose_of(const Stages& stages, const std::vector<StepState>& states, const std::string& tool,
                 double time);

/// States after a run in which everything goes as predicted: what a step measures is fulfilled at once, and
/// the powder takes `settling_time` (s) to come to rest or to do whatever else an open step waits for. Steps
/// must have been prepared.
std::vector<StepState> predicted(const Stages& stages, double settling_time);

/// Instants (s) of a predicted run at which to examine tools: dense during every step that moves one; some
/// dozens, spread over all phases, and those farthest out where it moves about one place.
/// Sorted.
std::vector<double> instants(const Stages& stages, const std::vector<StepState>& states, int dense);

}  // namespace diefill::process
