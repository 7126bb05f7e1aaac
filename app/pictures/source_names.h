// What pictures of several results call each of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace diefill::app {

/// A name for each directory, fit for file names: as many of the last folders of its path as it takes to tell
/// it from the others, without those at the end that this does not take. Of `fast/seed-1` and `slow/seed-1`
/// that is `fast` and `slow`, of `fast/seed-1` and `fast/seed-2` the seeds. A directory given twice gets a
/// number.
std::vector<std::string> source_names(const std::vector<std::filesystem::path>& directories);

}  // namespace diefill::app
