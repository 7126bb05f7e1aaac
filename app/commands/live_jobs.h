// The page live.html of a command that does many runs: how far each is, with links to their own pages.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "process/compare/run_jobs.h"

namespace diefill::app {

/// For JobOptions::watch: keeps `directory`/live.html under this title. Where the page cannot be written the
/// runs continue without it.
std::function<void(const process::JobListProgress&)> live_jobs(const std::filesystem::path& directory,
                                                               const std::string& title);

}  // namespace diefill::app
