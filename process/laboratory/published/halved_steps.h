// Runs of an experiment whose time step proved too long, for the contacts or for the control of a force,
// which acts every so many steps: they are made again at half of it, and once more at a quarter. The folder
// of the runs lists them, so that a later call makes the same runs.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "process/compare/job_folder.h"
#include "process/scene/scene.h"
#include "process/scene/variants.h"

namespace diefill::process::laboratory {

inline constexpr const char* kHalvedSteps = "halved_steps.txt";  ///< a run's name a line, once for each time
inline constexpr int kMostHalvings = 2;

/// How often the time step of each run is halved that the folder lists; none where it has no list.
std::map<std::string, int> halvings_of_runs(const std::filesystem::path& directory);

/// The scene with half its time step.
Scene at_half_step(const Scene& scene);

/// Adds to the folder's list the runs of `list` that ended because of their time step and may be halved once
/// more; each is reported. Returns whether there are any. Throws results::ResultError.
bool halve_steps_that_were_too_long(const std::filesystem::path& directory, const results::JobList& list,
                                    const NoteCallback& on_note);

}  // namespace diefill::process::laboratory
