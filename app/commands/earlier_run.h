// Files of earlier runs in the results directory.
#pragma once

#include <filesystem>
#include <vector>

#include "process/scene/identity.h"
#include "process/scene/scene.h"
#include "process/tooling/tooling.h"

namespace diefill::app {

/// Throws process::SceneError where the scene reads a file, or the state of pour.state, that
/// clear_for_run() would move out of the directory: the run could be neither resumed nor repeated.
void refuse_inputs_to_be_moved(const process::Scene& scene, const std::filesystem::path& directory);

/// For a run with --resume that has read `files`: throws process::SceneError where the run that left the
/// checkpoint in the directory had read other contents of one.
void refuse_changed_inputs(const process::Scene& scene, const std::vector<process::InputFile>& files,
                           const std::filesystem::path& directory);

/// For a run with --resume: whether the directory already holds its finished results, so that nothing is left
/// to do; prints a note. Throws process::SceneError or results::ResultError where it holds results
/// of another scene, or damaged ones, and no checkpoint.
bool is_finished(const std::filesystem::path& directory, const process::Scene& scene,
                 const process::Tooling& tooling);

/// Moves earlier results and checkpoints to a backup folder, prints where, and records the `files` that the
/// run has read; does nothing where the run continues from a checkpoint.
void clear_for_run(const std::filesystem::path& directory, bool resume,
                   const std::vector<process::InputFile>& files);

/// Removes the checkpoint of a finished run.
void remove_checkpoint(const std::filesystem::path& directory);

}  // namespace diefill::app
