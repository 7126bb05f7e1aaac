// Carries a simulation through the steps of its scene: which step is on, since when, and where it takes the
// tools.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "process/machine/step.h"
#include "process/results/fill_result.h"
#include "process/run/rest.h"
#include "process/run/tooling.h"

namespace diefill::process {

/// All that a restart needs of a schedule.
struct ScheduleState {
  std::uint64_t stage = 0;   ///< number of the step that is on; the number of steps when all are done
  double stage_start = 0;    ///< s, when it began
  std::vector<double> ends;  ///< s, when each of the steps before it ended
  RestWatch rest;
};

/// The scene's steps with a settling before the first and, unless the scene ends with one, after the last.
class Schedule {
 public:
  /// Steps must have been prepared.
  Schedule(const Scene& scene, const Tooling& tooling, double grain_diameter);

  /// Starts the first step, or goes on with `state`; gives the simulation's bodies (in the order of the
  /// tools) their motions.
  void begin(engine::Simulation& simulation, const ScheduleState& state = {});
  /// Ends the step that is on if it is over, and starts the next; true if it did.
  bool update(engine::Simulation& simulation);
  bool finished() const { return state_.stage >= stages_.size(); }
  const ScheduleState& state() const { return state_; }

  /// Steps that are over, each with its tool and its time.
  std::vector<results::Stage> past() const;
  /// Step that is on, in words; "done" after the last.
  std::string in_words() const;
  /// s that remain at least, counting for every wait until rest `settling_time` s.
  double time_left(double now, double settling_time) const;
  /// Box (m) round everything the tools reach in all steps.
  geometry::Box swept() const;

 private:
  void set_motions(engine::Simulation& simulation) const;
  /// Where stage `stage` finds tool k.
  ToolPose pose_before(std::size_t stage, std::size_t k) const;

  const Tooling& tooling_;
  double grain_diameter_;
  std::vector<std::shared_ptr<Step>> stages_;
  ScheduleState state_;
};

}  // namespace diefill::process
