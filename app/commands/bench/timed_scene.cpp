#include "app/commands/bench/timed_scene.h"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/bench/loop_figures.h"
#include "app/commands/shared_options/scene_choice.h"
#include "app/freed_memory.h"
#include "engine/numerics/seconds_since.h"
#include "engine/observe/powder_figures.h"
#include "process/input/scene_error.h"
#include "process/results/storage/result_file.h"
#include "process/run/fill_run.h"
#include "process/run/restart/checkpoint.h"
#include "process/scene/identity.h"

namespace diefill::app {

namespace {

namespace fs = std::filesystem;

/// Steps of the built-in engine, of which those after the warm-up are timed.
class TimedSteps : public process::StepEngine {
 public:
  explicit TimedSteps(const TimedScene& wanted) : wanted_(wanted) {}

  void step(engine::Simulation& simulation, std::uint64_t) override {
    if (made_ == wanted_.warm_up) begin(simulation);
    if (made_ == wanted_.warm_up + wanted_.steps) end(simulation);
    simulation.step();
    ++made_;
    if (!begun_) return;
    spheres_ += static_cast<double>(engine::sphere_count(simulation));
  }
  void sync_grains(engine::Simulation&) override {}
  void sync_contacts(engine::Simulation&) override {}
  bool contacts_are_synced() const override { return true; }
  std::string description() const override { return "timed steps"; }
  int ranks() const override { return 1; }

  /// True once the timing is complete.
  const std::atomic<bool>& done() const { return done_; }
  const nlohmann::ordered_json& figures() const { return figures_; }

 private:
  using Clock = std::chrono::steady_clock;

  void begin(engine::Simulation& simulation) {
    begun_ = true;
    searches_ = simulation.searches();
    from_ = simulation.time();
    simulation.time_loops();
    began_ = Clock::now();
  }

  /// What the run did after the last of the steps counts.
  void end(const engine::Simulation& simulation) {
    if (done_) return;
    const double seconds = engine::seconds_since(began_);
    figures_["sphere_steps_per_second"] = spheres_ / seconds;
    figures_["spheres"] = spheres_ / wanted_.steps;
    figures_["steps"] = wanted_.steps;
    figures_["threads"] = wanted_.threads;
    figures_["seconds"] = seconds;
    figures_["from_s"] = from_;
    figures_["to_s"] = simulation.time();
    figures_["steps_per_search"] =
        wanted_.steps / std::max(1.0, static_cast<double>(simulation.searches() - searches_));
    add_loop_figures(simulation, seconds, wanted_.steps, figures_);
    figures_["state_hash"] = hash_text(simulation);
    done_ = true;
  }

  TimedScene wanted_;
  int made_ = 0;
  bool begun_ = false;
  double spheres_ = 0;  ///< spheres times steps
  std::uint64_t searches_ = 0;
  double from_ = 0;  ///< s, simulated
  Clock::time_point began_;
  std::atomic<bool> done_ = false;
  nlohmann::ordered_json figures_;
};

/// A copy of a run's checkpoint, as the run goes on from it and writes another; removed at the end.
class Checkpoint {
 public:
  explicit Checkpoint(const fs::path& run)
      : path_(fs::temp_directory_path() / ("diefill-timed-" + std::to_string(getpid()))) {
    const fs::path file = process::checkpoint_file(run);
    if (!fs::is_regular_file(file))
      throw process::SceneError("bench: " + run.string() +
                                ": no checkpoint of a run; stop one (Ctrl-C), or end it by a short "
                                "numerics.max_time, where timing is to begin");
    fs::create_directories(path_);
    fs::copy_file(file, process::checkpoint_file(path_), fs::copy_options::overwrite_existing);
  }
  ~Checkpoint() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Checkpoint(const Checkpoint&) = delete;
  Checkpoint& operator=(const Checkpoint&) = delete;
  const fs::path& directory() const { return path_; }

 private:
  fs::path path_;
};

/// Names the run that the user knows, not the copy. Throws process::SceneError where its checkpoint cannot be
/// used or is of another scene.
void refuse_other_scene(const TimedScene& wanted, const process::Scene& scene,
                        const process::Tooling& tooling) {
  std::vector<std::string> tools;
  for (const auto& tool : tooling.tools) tools.push_back(tool.file_hash);
  const std::string found = "bench: --state: found the checkpoint of " + wanted.run.string() + ", ";
  std::optional<process::Checkpoint> kept;
  try {
    kept = process::read_checkpoint(process::checkpoint_file(wanted.run));
  } catch (const results::ResultError&) {
    throw process::SceneError(found +
                              "which is damaged or of another version of the program; stop a run of " +
                              wanted.scene + " with this one");
  }
  if (kept && kept->scene_hash != process::scene_identity(scene.text, scene.file, tools))
    throw process::SceneError(found + "which is of another scene or other CAD files than " + wanted.scene +
                              "; give the directory of a stopped run of this scene");
}

}  // namespace

nlohmann::ordered_json timed(const TimedScene& wanted) {
  const Checkpoint checkpoint(wanted.run);
  process::Scene scene = chosen_scene(wanted.scene, "", {});
  const auto tooling = prepared_tooling(scene, false);
  scene = process::with_prepared_steps(std::move(scene), tooling);
  refuse_other_scene(wanted, scene, tooling);
  TimedSteps steps(wanted);
  process::RunOptions options;
  options.directory = checkpoint.directory();
  options.threads = wanted.threads;
  options.resume = true;
  options.show_progress = false;
  options.engine = &steps;
  options.stop = &steps.done();
  release_freed_memory();
  process::FillRun run(scene, tooling, options);
  try {
    run.run();
  } catch (const process::Interrupted&) {  // when the figures stand
  }
  if (!steps.done())
    throw process::SceneError("bench: " + wanted.scene +
                              " is over at t = " + std::to_string(run.simulation().time()) + " s, before " +
                              std::to_string(wanted.warm_up + wanted.steps) +
                              " steps; time fewer (--steps), or take an earlier checkpoint");
  return steps.figures();
}

}  // namespace diefill::app
