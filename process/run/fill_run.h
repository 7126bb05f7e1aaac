// One filling from scene to rest: pours, steps the simulation through the schedule, removes spilled grains,
// monitors the method's limits, records probes, writes checkpoints.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "engine/limits/validity_monitor.h"
#include "process/run/free_tools.h"
#include "process/run/leak_watch.h"
#include "process/run/lost_grains.h"
#include "process/run/powder_source.h"
#include "process/run/probes.h"
#include "process/run/restart/checkpoint.h"
#include "process/run/schedule.h"
#include "process/run/snapshots.h"
#include "process/run/standstill.h"
#include "process/run/step_engine.h"
#include "process/run/stray_watch.h"
#include "process/scene/identity.h"
#include "process/tooling/grain_tally.h"
#include "process/tooling/progress.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

class FillRun;

/// How to run, as opposed to what.
struct RunOptions {
  std::filesystem::path directory;  ///< for checkpoints
  /// The files that the scene refers to, as they were when it was read; nothing: as they are now.
  std::optional<std::vector<InputFile>> inputs;
  int threads = 2;
  bool resume = false;  ///< resume from the checkpoint in the directory
  /// Where runs store their shared starts (shared_start.h); empty: nowhere.
  std::filesystem::path shared_starts;
  bool show_progress = true;
  StepEngine* engine = nullptr;  ///< computes the steps in place of the built-in engine
  const std::atomic<bool>* stop =
      nullptr;  ///< set from a signal handler: stop at the next step with a checkpoint
  /// Called with the name of every snapshot whose time has come; after a restart possibly once more, in the
  /// same state.
  std::function<void(const FillRun&, const std::string&)> snapshot;
  /// Called every few steps; must not change the run.
  std::function<void(const FillRun&)> watch;
};

/// The user stopped the run; a checkpoint has been written, unless the message says otherwise.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A run under way or finished.
class FillRun {
 public:
  /// Throws SceneError for a scene that cannot be run, and where a file that it refers to is no longer what
  /// `options.inputs` says.
  FillRun(const Scene& scene, const Tooling& tooling, const RunOptions& options);

  /// Runs to the end, until numerics.max_time is over, or until nothing can change any more while a step
  /// waits for a mass or a force; the state then lies in a checkpoint. Throws SceneError for a checkpoint of
  /// another scene, engine::OutOfRange when the method's range is left (the last good checkpoint stands),
  /// Interrupted when stopped by the user.
  void run();
  /// Whether the run ended before the scene: numerics.max_time was over, or the scene cannot end.
  bool ended_early() const { return !schedule_.finished() && (out_of_time() || cannot_end()); }
  /// Whether the scene waits for what powder at rest will never do.
  bool cannot_end() const { return standstill_.lasts(simulation_->time()); }
  /// Share of the simulated time that is over, 0 to 1, as far as can be predicted.
  double share_done() const;
  /// Why the scene is not over, for messages; empty once it is.
  std::string why_unfinished() const;

  const engine::Simulation& simulation() const { return *simulation_; }
  const Schedule& schedule() const { return schedule_; }
  /// Grains removed: spilled, discharged or cleared away.
  std::uint64_t grains_removed() const { return removed_.grains(); }
  double mass_removed() const { return removed_.mass(simulation_->types()); }  ///< kg
  /// Grains wedged between tools that were taken out (NumericsSpec::pinched_grains).
  std::uint64_t grains_sheared() const { return sheared_.grains(); }
  /// Instants kept on the way (measure.snapshot_interval); tools' poses in the laboratory frame.
  const std::vector<results::Instant>& instants() const { return instants_; }
  /// Of the scene, and the motion of free tools.
  std::vector<results::ProbeSeries> probes() const;
  double wall_seconds() const;
  std::uint64_t sphere_steps() const { return sphere_steps_; }
  /// Of the program that computes the steps.
  int ranks() const { return options_.engine != nullptr ? options_.engine->ranks() : 1; }
  double critical_time_step() const { return critical_step_; }
  std::vector<std::string> warnings() const;

 private:
  void hash_inputs();
  void start_or_resume();
  void make_step();
  std::uint64_t next_sync_step() const;
  void sync_if_due();
  bool at_sync_step() const;
  void sync_contacts();
  bool contacts_are_synced() const;
  std::optional<Checkpoint> own_checkpoint() const;
  std::optional<Checkpoint> shared_start() const;
  void resume_from(const Checkpoint& checkpoint);
  void do_periodic_tasks();
  void remove_spilled_grains();
  void shear_off_pinched_grains();
  std::string shear_warning() const;
  void feed_powder();
  void clear_powder();
  void clear_outside_cavities(double heap);
  std::optional<double> height_of_lowest(double share) const;
  void change_powder();
  void apply_changed_laws();
  void add_random_velocities(double deviation, std::size_t step);
  std::uint64_t grains_poured() const;
  void remove_grains(const std::function<bool(const Eigen::Vector3d&)>& leaves);
  void count_out(std::size_t k);
  void take_snapshots();
  void check_for_lost_grains();
  std::uint64_t steps_between_instants() const;
  void keep_instant();
  Checkpoint checkpoint() const;
  bool write_checkpoint();
  [[noreturn]] void stop_with_checkpoint();
  bool out_of_time() const;
  void look_for_standstill();
  void save_shared_start();
  bool keep(const std::function<void()>& write, const std::string& otherwise);
  void show_progress();
  std::uint64_t start_hash(const ScheduleState& schedule, double now) const;
  std::size_t place_of(std::uint64_t id) const;

  const Scene& scene_;
  const Tooling& tooling_;
  RunOptions options_;
  std::vector<InputFile> inputs_;  ///< as they were read: files may be edited while the run goes on
  std::uint64_t scene_hash_ = 0;   ///< with those contents
  double grain_diameter_;
  double critical_step_;
  std::unique_ptr<engine::Simulation> simulation_;
  Schedule schedule_;
  PowderSource source_;
  Probes probes_;
  FreeTools free_tools_;
  Snapshots snapshots_;
  engine::ValidityMonitor monitor_;
  LostGrains lost_grains_;
  LeakWatch leak_watch_;
  StrayWatch stray_watch_;
  Progress progress_;
  geometry::Box domain_;  ///< m, grains beyond it have been spilled or discharged
  std::vector<std::string> warnings_;
  std::vector<results::Instant> instants_;
  Standstill standstill_;
  GrainTally removed_, sheared_;
  std::uint64_t sphere_steps_ = 0;
  double earlier_wall_seconds_ = 0;
  std::chrono::steady_clock::time_point started_, last_checkpoint_;
};

}  // namespace diefill::process
