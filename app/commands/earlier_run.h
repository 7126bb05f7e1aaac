// Files of earlier runs in the results directory.
#pragma once

#include <filesystem>
#include <vector>

#include "process/results/fill_result.h"
#include "process/scene/identity.h"
#include "process/scene/scene.h"
#include "process/tooling/tooling.h"

namespace diefill::app {

/// Throws process::SceneError where the scene reads a file, or the state of pour.state, that
/// back_up_earlier_results() would move out of the directory: the run could be neither resumed nor repeated.
void refuse_inputs_to_be_moved(const process::Scene& scene, const std::filesystem::path& directory);

/// Keeps with the results which files the scene referred to when it was read, for is_finished().
void add_input_files(const std::vector<process::InputFile>& files, results::FillResult& result);

/// For a run with --resume: whether the directory already holds its finished results, so that nothing is left
/// to do; prints a note. Throws process::SceneError or results::ResultError where it holds results
/// of another scene, or damaged ones, and no checkpoint.
bool is_finished(const std::filesystem::path& directory, const process::Scene& scene,
                 const process::Tooling& tooling);

/// Moves earlier results and checkpoints to a backup folder unless the run continues from a checkpoint there,
/// and prints where.
void back_up_earlier_results(const std::filesystem::path& directory, bool resume);

}  // namespace diefill::app
