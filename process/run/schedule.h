// Runs a simulation through the steps of its scene: which are active, since when, and where they move the
// tools.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "process/machine/step.h"
#include "process/results/fill_result.h"
#include "process/tooling/stages.h"
#include "process/tooling/tooling.h"

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::process {

/// The powder's load on a tool, summed since the last update of the schedule.
struct LoadSum {
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
};

/// All that a restart needs of a schedule.
struct ScheduleState {
  std::vector<StepState> steps;
  std::vector<LoadSum> loads;      ///< one a tool; empty where not needed
  std::uint64_t loads_summed = 0;  ///< time steps
  double last_update = 0;          ///< s
};

/// The scene's steps with a settling before the first and, unless the scene ends with one, after the last.
/// They begin and end at calls of update().
class Schedule {
 public:
  /// Steps must have been prepared. Keeps references to all three.
  Schedule(const Scene& scene, const Tooling& tooling, double grain_diameter);
  Schedule(const Schedule&) = delete;
  Schedule& operator=(const Schedule&) = delete;

  /// Starts the first step, or resumes with `state`; gives the simulation's bodies (in the order of the
  /// tools) their motions, which refer to this schedule.
  void begin(engine::Simulation& simulation, const ScheduleState& state = {});
  /// To be called after every time step: sums the loads on tools, where a step or condition asks for them.
  void observe(const engine::Simulation& simulation);
  /// Ends steps that are over and starts those that are due, each once; true if there were any. Sets the
  /// speed of tools under force control until the next call; throws engine::OutOfRange when one oscillates.
  bool update(engine::Simulation& simulation);
  /// Whether `condition` holds now; `watch` stores its state. For snapshots.
  bool holds(const Condition& condition, ConditionState& watch, const engine::Simulation& simulation) const;

  /// Steps that are over, each with its tools and its time.
  std::vector<results::Stage> completed_stages() const;
  bool finished() const;
  const ScheduleState& state() const { return state_; }
  const Stages& stages() const { return stages_; }
  /// Of the scene's step k (from 0).
  const StepState& of_step(std::size_t k) const { return state_.steps[k + 1]; }
  /// Counts grains that step k of the scene fed.
  void count_inflow(std::size_t k, std::size_t grains) { state_.steps[k + 1].grains_fed += grains; }

  /// Whether the schedule waits for a mass or a force that powder at rest will not change: no tool moves, and
  /// time alone ends and starts no step.
  bool waits_for_powder(const engine::Simulation& simulation) const;
  /// What it then waits for, with the value now: "scene.toml:12:9: step.until waits for 5 g in the cavity,
  /// which holds 3.2 g".
  std::string unmet_condition(const engine::Simulation& simulation) const;

  /// The active steps as text; "done" after the last.
  std::string description() const;
  /// s that remain at least, with `settling_time` s for whatever is not known in advance.
  double time_left(double now, double settling_time) const;
  /// Box (m) round everything the tools reach in all steps.
  geometry::Box swept() const;

 private:
  void set_motions(engine::Simulation& simulation);
  bool starts(std::size_t k, const engine::Simulation& simulation);
  bool ends(std::size_t k, const engine::Simulation& simulation);
  bool stops(std::size_t k, const engine::Simulation& simulation);
  bool measured(const Condition& condition, ConditionState& watch,
                const engine::Simulation& simulation) const;
  bool time_fulfils(const Condition& condition, double now) const;
  bool has_no_way_left(std::size_t k) const;
  std::string why_no_way_left(std::size_t k) const;
  bool goes_on_by_itself(std::size_t k, const engine::Simulation& simulation) const;
  bool lets_powder_in(std::size_t k, const engine::Simulation& simulation) const;
  const Condition* unmet_by(std::size_t k, double now) const;
  double mean_force(const std::string& tool) const;
  double mean_resistance(const Step& step, const engine::Simulation& simulation) const;
  bool control(engine::Simulation& simulation);
  bool prescribed_motion_is_on() const;

  const Tooling& tooling_;
  double grain_diameter_;
  const Scene& scene_;
  Stages stages_;
  bool needs_loads_ = false;
  ScheduleState state_;
};

}  // namespace diefill::process
