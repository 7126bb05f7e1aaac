// Files of earlier runs in the results directory.
#pragma once

#include <filesystem>

#include "process/scene/scene.h"
#include "process/tooling/tooling.h"

namespace diefill::app {

/// For a run with --resume: whether the directory already holds its finished results, so that nothing is left
/// to do; prints a note. Throws process::SceneError or results::ResultError where it holds results
/// of another scene, or damaged ones, and no checkpoint.
bool is_finished(const std::filesystem::path& directory, const process::Scene& scene,
                 const process::Tooling& tooling);

/// Moves earlier results and checkpoints to a backup folder unless the run continues from a checkpoint there,
/// and prints where.
void keep_earlier_results(const std::filesystem::path& directory, bool resume);

}  // namespace diefill::app
