#include "app/commands/earlier_run.h"

#include <cstdio>
#include <optional>

#include "app/commands/shared_options/scene_choice.h"
#include "app/output.h"
#include "process/results/storage/earlier_results.h"
#include "process/results/storage/result_file.h"
#include "process/run/restart/checkpoint.h"
#include "process/run/restart/input_record.h"

namespace diefill::app {
namespace {

constexpr const char* kRestartHint =
    "; run without --resume, which moves them to previous-1, or choose another directory";

results::FillResult earlier_results(const std::filesystem::path& directory) {
  try {
    return results::read_results(directory);
  } catch (const results::ResultError& error) {
    throw results::ResultError(error.what() + std::string(kRestartHint));
  }
}

/// Whether the results are of this scene and these CAD files.
bool are_of(const results::FillResult& result, const process::Scene& scene, const process::Tooling& tooling) {
  std::vector<std::string> now, then;
  for (const auto& tool : tooling.tools) now.push_back(tool.file_hash);
  for (const auto& tool : result.tools) then.push_back(tool.mesh_hash);
  return process::scene_identity(scene.text, scene.file, now) ==
         process::scene_identity(result.scene_text, scene.file, then);
}

/// The first file that the scene refers to and whose contents are no longer those of the results; nothing
/// where they are the same, and for results of versions that did not keep them.
std::optional<std::string> changed_input(const results::FillResult& result, const process::Scene& scene) {
  const auto then = process::recorded_input_files(result);
  if (!then) return std::nullopt;
  return process::changed_file(process::input_files(scene.text, scene.file), *then);
}

bool is_complete(const results::FillResult& result) {
  const auto finished = result.figures.find("finished");
  return finished == result.figures.end() || finished->second != 0;
}

}  // namespace

void refuse_inputs_to_be_moved(const process::Scene& scene, const std::filesystem::path& directory) {
  if (scene.pour.state && results::would_be_moved(directory, scene.pour.state->directory))
    throw process::SceneError(scene.file.string() + ':' + std::to_string(scene.pour.line) +
                              ": pour.state: found " + scene.pour.state->directory.string() +
                              ", but this run would move these results out of " + directory.string() +
                              "; choose another directory with --out");
  for (const auto& file : input_files_of(scene))
    if (results::would_be_moved(directory, file))
      throw process::SceneError("--out: found " + directory.string() + ", but this run would move " +
                                file.string() +
                                ", which the scene reads, out of it with the earlier results; choose another "
                                "directory");
}

void refuse_changed_inputs(const process::Scene& scene, const std::vector<process::InputFile>& files,
                           const std::filesystem::path& directory) {
  const auto checkpoint = process::checkpoint_file(directory);
  const auto then = process::read_input_record(directory);
  if (!then || !std::filesystem::exists(checkpoint)) return;
  if (const auto changed = process::changed_file(files, *then))
    throw process::SceneError(checkpoint.string() +
                              ": the checkpoint belongs to a different scene: the contents of " + *changed +
                              " have changed since the run of " + scene.file.string() +
                              " read it; run without --resume, which moves it to a backup folder, or choose "
                              "another directory");
}

bool is_finished(const std::filesystem::path& directory, const process::Scene& scene,
                 const process::Tooling& tooling) {
  if (std::filesystem::exists(process::checkpoint_file(directory)) ||
      !std::filesystem::exists(directory / "results.h5"))
    return false;
  const auto result = earlier_results(directory);
  if (!are_of(result, scene, tooling))
    throw process::SceneError(directory.string() +
                              ": the results belong to a different scene or different CAD files than " +
                              scene.file.string() + kRestartHint);
  if (const auto changed = changed_input(result, scene))
    throw process::SceneError(directory.string() +
                              ": the results belong to a different scene: the contents of " + *changed +
                              " have changed since " + scene.file.string() + " was run" + kRestartHint);
  if (!is_complete(result)) return false;
  std::printf(
      "%s: this run is already finished (state %s), nothing was computed; without --resume it starts again "
      "and moves these results to previous-1\n",
      directory.c_str(), result.state_hash.c_str());
  return true;
}

void clear_for_run(const std::filesystem::path& directory, bool resume,
                   const std::vector<process::InputFile>& files) {
  if (resume && std::filesystem::exists(process::checkpoint_file(directory))) return;
  write_output([&] {
    if (const auto folder = results::back_up_results(directory))
      std::fprintf(stderr, "note: earlier results and pictures in %s were moved to %s\n", directory.c_str(),
                   folder->c_str());
    process::write_input_record(directory, files);
  });
}

void remove_checkpoint(const std::filesystem::path& directory) {
  std::filesystem::remove(process::checkpoint_file(directory));
  std::filesystem::remove(process::input_record_file(directory));
}

}  // namespace diefill::app
