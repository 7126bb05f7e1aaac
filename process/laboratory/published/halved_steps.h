// Runs of an experiment whose time step proved too long: they are made again at half of it. The folder of the
// runs lists them, so that a later call makes the same runs.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "process/compare/job_folder.h"
#include "process/scene/scene.h"
#include "process/scene/variants.h"

namespace diefill::process::laboratory {

inline constexpr const char* kHalvedSteps = "halved_steps.txt";  ///< a run's name a line

/// Runs that the folder lists; none where it has no list.
std::set<std::string> runs_at_half_step(const std::filesystem::path& directory);

/// The scene with half its time step.
Scene at_half_step(const Scene& scene);

/// Adds to the folder's list the runs of `list` that ended because of their time step and are not in it yet;
/// each is reported. Returns whether there are any. Throws results::ResultError.
bool halve_steps_that_were_too_long(const std::filesystem::path& directory, const results::JobList& list,
                                    const NoteCallback& on_note);

}  // namespace diefill::process::laboratory
