// What a directory of runs holds and a new scene no longer fits is kept, under another name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "process/results/comparison.h"
#include "process/results/tradeoff.h"

namespace diefill::process {

/// Makes the folder, with those above it. Throws results::ResultError.
void make_folder(const std::filesystem::path& folder);

/// Renames a file or folder to `<name>-previous-1` or the first free number, and gives that path. Throws
/// results::ResultError where it cannot.
std::filesystem::path set_one_aside(const std::filesystem::path& path);

/// Moves comparison.json and what belongs to it into `directory`/previous-1, or the first free number, where
/// it tells of finished runs that `now` does not have, or cannot be read; gives that folder. Throws
/// results::ResultError.
std::optional<std::filesystem::path> keep_earlier_tables(const std::filesystem::path& directory,
                                                         const results::Comparison& now);

/// The same of tradeoff.json, where it tells of settings with more finished runs than `now` has.
std::optional<std::filesystem::path> keep_earlier_tables(const std::filesystem::path& directory,
                                                         const results::Tradeoff& now);

}  // namespace diefill::process
