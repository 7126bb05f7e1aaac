// What earlier runs have left in the directory that a run is to write into.
#pragma once

#include <filesystem>

#include "process/run/tooling.h"
#include "process/scene/scene.h"

namespace diefill::app {

/// For a run that is to go on where it was stopped: whether the directory holds its finished results, so that
/// nothing is left to do; says so. Throws process::SceneError or results::ResultError where it holds results
/// of another scene, or damaged ones, and no checkpoint.
bool is_finished(const std::filesystem::path& directory, const process::Scene& scene,
                 const process::Tooling& tooling);

/// Keeps earlier results and checkpoints aside, unless the run goes on from a checkpoint there, and says
/// where.
void keep_earlier_results(const std::filesystem::path& directory, bool resume);

}  // namespace diefill::app
