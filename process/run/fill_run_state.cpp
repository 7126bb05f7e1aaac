// How a run keeps its state and goes on from what was kept.
#include "process/input/units.h"
#include "process/results/storage/result_file.h"
#include "process/run/fill_run.h"
#include "process/run/restart/input_record.h"
#include "process/run/restart/shared_start.h"

namespace diefill::process {

/// Once, as soon as all of them have been read.
void FillRun::hash_inputs() {
  inputs_ = input_files(scene_.text, scene_.file);
  if (const auto changed = changed_file(inputs_, options_.inputs.value_or(inputs_)))
    throw SceneError(scene_.file.string() + ": the contents of " + *changed +
                     " have changed while the run was being prepared; run the same command again");
  std::vector<std::string> tools;
  for (const Tool& tool : tooling_.tools) tools.push_back(tool.file_hash);
  scene_hash_ = scene_identity(scene_.text, scene_.file, tools);
}

void FillRun::start_or_resume() {
  if (const auto own = own_checkpoint()) {
    resume_from(*own);
    progress_.note("resuming at t = " + std::to_string(simulation_->time()) + " s");
  } else if (const auto shared = shared_start()) {
    resume_from(*shared);
    progress_.note("the first " + std::to_string(simulation_->time()) + " s are taken from an earlier run");
  } else if (options_.resume) {
    progress_.note("no checkpoint in " + options_.directory.string() + ": starting from the beginning");
  }
}

std::optional<Checkpoint> FillRun::own_checkpoint() const {
  if (!options_.resume) return std::nullopt;
  const auto path = checkpoint_file(options_.directory);
  auto checkpoint = read_checkpoint(path);
  if (checkpoint && checkpoint->scene_hash != scene_hash_)
    throw SceneError(
        path.string() + ": the checkpoint belongs to a different scene or different CAD files than " +
        scene_.file.string() +
        "; run without --resume, which moves it to a backup folder, or choose another directory");
  return checkpoint;
}

std::optional<Checkpoint> FillRun::shared_start() const {
  if (options_.shared_starts.empty()) return std::nullopt;
  auto beginning = latest_shared_start(options_.shared_starts, [this](const Checkpoint& other) {
    const double now = other.simulation.time;
    const auto schedule = with_steps(other.schedule, schedule_.stages().size());
    return schedule && other.start_hash == start_hash(*schedule, now) &&
           snapshots_.none_due_before(schedule_.stages(), schedule->steps, now);
  });
  // Those of the other scene are its own affair, and none of ours has been due.
  if (beginning) beginning->snapshots = snapshots_.state();
  return beginning;
}

void FillRun::resume_from(const Checkpoint& checkpoint) {
  schedule_.begin(*simulation_, checkpoint.schedule);
  snapshots_.restore(checkpoint.snapshots);
  apply_changed_laws();
  free_tools_.restore(checkpoint.free_tools, *simulation_);
  simulation_->restore(checkpoint.simulation);
  probes_.restore(checkpoint.probes);
  removed_ = GrainTally(checkpoint.grains_removed);
  sheared_ = GrainTally(checkpoint.grains_sheared);
  leak_watch_.restore(checkpoint.leaks);
  stray_watch_.restore(checkpoint.strays);
  standstill_ = checkpoint.standstill;
  monitor_.restore(checkpoint.warnings);
  earlier_wall_seconds_ = checkpoint.wall_seconds;
  sphere_steps_ = checkpoint.sphere_steps;
  instants_ = checkpoint.instants;
}

Checkpoint FillRun::checkpoint() const {
  Checkpoint checkpoint;
  checkpoint.scene_hash = scene_hash_;
  checkpoint.start_hash = start_hash(schedule_.state(), simulation_->time());
  checkpoint.simulation = simulation_->snapshot();
  checkpoint.schedule = schedule_.state();
  checkpoint.probes = probes_.state();
  checkpoint.free_tools = free_tools_.state();
  checkpoint.snapshots = snapshots_.state();
  checkpoint.grains_removed = removed_.by_kind();
  checkpoint.grains_sheared = sheared_.by_kind();
  checkpoint.leaks = leak_watch_.state();
  checkpoint.strays = stray_watch_.state();
  checkpoint.standstill = standstill_;
  checkpoint.warnings = monitor_.state();
  checkpoint.wall_seconds = wall_seconds();
  checkpoint.sphere_steps = sphere_steps_;
  checkpoint.instants = instants_;
  return checkpoint;
}

bool FillRun::write_checkpoint() {
  sync_contacts();
  last_checkpoint_ = std::chrono::steady_clock::now();
  const auto file = checkpoint_file(options_.directory);
  return keep([&] { process::write_checkpoint(file, checkpoint()); },
              std::filesystem::exists(file) ? "no checkpoint written, the previous one is still valid"
                                            : "no checkpoint written, and there is no earlier one");
}

void FillRun::stop_with_checkpoint() {
  const bool kept = write_checkpoint();
  const std::string stopped = "stopped at t = " + std::to_string(simulation_->time()) + " s";
  if (kept) throw Interrupted(stopped + "; run the same command with --resume to continue");
  if (std::filesystem::exists(checkpoint_file(options_.directory)))
    throw Interrupted(stopped +
                      " without space for a checkpoint; run the same command with --resume to continue from "
                      "the previous one");
  throw Interrupted(stopped + " without space for a checkpoint: the computed results are lost");
}

void FillRun::save_shared_start() {
  // Air flows through what the whole schedule makes of the tools.
  if (options_.shared_starts.empty() || scene_.suction) return;
  keep([this] { process::save_shared_start(options_.shared_starts, checkpoint()); },
       "could not store the shared start for other runs, which will compute it themselves");
}

/// Writes; where that fails for want of room, a warning tells what is so `otherwise`, and the run goes on.
/// True if it was written.
bool FillRun::keep(const std::function<void()>& write, const std::string& otherwise) {
  try {
    write();
    return true;
  } catch (const results::ResultError& error) {
    progress_.warn("warning: " + otherwise + ": " + error.what());
    return false;
  }
}

bool FillRun::out_of_time() const {
  return scene_.numerics.max_time > 0 && simulation_->time() > scene_.numerics.max_time;
}

/// Powder that has come to rest while no tool moves stays so.
void FillRun::look_for_standstill() {
  if (!schedule_.waits_for_powder(*simulation_)) {
    standstill_ = {};
    return;
  }
  if (!standstill_.rest.at_rest(*simulation_, grain_diameter_))
    standstill_.since = -1;
  else if (standstill_.since < 0)
    standstill_.since = simulation_->time();
}

std::string FillRun::why_unfinished() const {
  if (schedule_.finished()) return {};
  if (cannot_end())
    return "the scene cannot end: at t = " + number_text(simulation_->time()) +
           " s all powder is at rest, none comes in and no tool moves, but " +
           schedule_.unmet_condition(*simulation_);
  std::string why = "the scene had not ended ";
  if (out_of_time())
    why += "after numerics.max_time of " + number_text(scene_.numerics.max_time) + " s";
  else
    why += "at t = " + number_text(simulation_->time()) + " s";
  return why + " (current step: " + schedule_.description() + ')';
}

std::uint64_t FillRun::start_hash(const ScheduleState& schedule, double now) const {
  const RunFrame frame{simulation_->settings().time_step, domain_, inputs_};
  return process::start_hash(scene_, tooling_, frame, schedule, now);
}

}  // namespace diefill::process
