#include "app/commands/earlier_run.h"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "app/commands/scene_choice.h"
#include "app/output.h"
#include "process/results/storage/earlier_results.h"
#include "process/results/storage/result_file.h"
#include "process/run/checkpoint.h"

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

constexpr const char* kInputFiles = "input files";  // topic of the results

/// The first file that the scene refers to and whose contents are no longer those of the results; nothing
/// where they are the same, and for results of versions that did not keep them.
std::optional<std::string> changed_input(const results::FillResult& result, const process::Scene& scene) {
  const auto then = std::find_if(result.topics.begin(), result.topics.end(),
                                 [](const results::Topic& topic) { return topic.topic == kInputFiles; });
  if (then == result.topics.end()) return std::nullopt;
  const auto now = process::input_files(scene.text, scene.file);
  for (std::size_t k = 0; k < now.size(); ++k)
    if (k >= then->text.size() || then->text[k] != now[k].hash) return now[k].name;
  return std::nullopt;
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
                              ", results which this run would move away from " + directory.string() +
                              "; choose another directory with --out");
  for (const auto& file : input_files_of(scene))
    if (results::would_be_moved(directory, file))
      throw process::SceneError("--out: found " + directory.string() + ", out of which this run would move " +
                                file.string() +
                                ", which the scene reads, with earlier results; choose another directory");
}

void add_input_files(const std::vector<process::InputFile>& files, results::FillResult& result) {
  if (files.empty()) return;
  results::Topic topic{kInputFiles, {}, {}};
  for (const auto& file : files) {
    topic.name.push_back(file.name);
    topic.text.push_back(file.hash);
  }
  result.topics.push_back(std::move(topic));
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

void back_up_earlier_results(const std::filesystem::path& directory, bool resume) {
  if (resume && std::filesystem::exists(process::checkpoint_file(directory))) return;
  write_output([&] {
    if (const auto folder = results::back_up_results(directory))
      std::fprintf(stderr, "note: earlier results and pictures in %s were moved to %s\n", directory.c_str(),
                   folder->c_str());
  });
}

}  // namespace diefill::app
