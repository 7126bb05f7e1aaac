#include "app/commands/earlier_run.h"

#include <cstdio>

#include "app/output.h"
#include "process/results/storage/earlier_results.h"
#include "process/results/storage/result_file.h"
#include "process/run/checkpoint.h"
#include "process/scene/identity.h"

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

bool is_complete(const results::FillResult& result) {
  const auto finished = result.figures.find("finished");
  return finished == result.figures.end() || finished->second != 0;
}

}  // namespace

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
  if (!is_complete(result)) return false;
  std::printf(
      "%s: this run is already finished (state %s), nothing was computed; without --resume it starts again "
      "and moves these results to previous-1\n",
      directory.c_str(), result.state_hash.c_str());
  return true;
}

void keep_earlier_results(const std::filesystem::path& directory, bool resume) {
  if (resume && std::filesystem::exists(process::checkpoint_file(directory))) return;
  write_output([&] {
    if (const auto folder = results::set_aside(directory))
      std::fprintf(stderr, "note: files of an earlier run in %s were moved to %s\n", directory.c_str(),
                   folder->c_str());
  });
}

}  // namespace diefill::app
