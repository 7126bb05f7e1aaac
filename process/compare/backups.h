// Backs up files in a directory of runs that do not match a new scene, by renaming them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "process/results/studies/calibration.h"
#include "process/results/studies/comparison.h"
#include "process/results/studies/tradeoff.h"

namespace diefill::process {

/// Creates the folder and its parents. Throws results::ResultError.
void make_folder(const std::filesystem::path& folder);

/// Renames a file or folder to `<name>-previous-1` or the first free number, and gives that path. Throws
/// results::ResultError where it cannot.
std::filesystem::path back_up(const std::filesystem::path& path);

/// Moves comparison.json and its companion files into `directory`/previous-1, or the first free number, where
/// it lists finished runs that `now` does not have, or cannot be read; without comparison.json, files of the
/// names of its companions. Returns that folder. Throws results::ResultError.
std::optional<std::filesystem::path> back_up_earlier_tables(const std::filesystem::path& directory,
                                                            const results::Comparison& now);

/// The same of tradeoff.json, where it lists settings with more finished runs than `now` has.
std::optional<std::filesystem::path> back_up_earlier_tables(const std::filesystem::path& directory,
                                                            const results::Tradeoff& now);

/// The same of results::calibration_tables(), where calibration.json is missing or cannot be read, where it
/// has a fit and `now` has none, and where it lists finished points of a start, search or screening that
/// `now` does not have. Points of a check follow from the best powder, which more runs move: they may change.
/// powder.toml is moved where `now` has no fit.
std::optional<std::filesystem::path> back_up_earlier_tables(const std::filesystem::path& directory,
                                                            const results::Calibration& now);

/// Moves those of the files `names` that are in the directory into `directory`/previous-1, or the first free
/// number, and gives that folder; nothing where there are none. Throws results::ResultError.
std::optional<std::filesystem::path> back_up_files(const std::filesystem::path& directory,
                                                   const std::vector<std::string>& names);

/// Moves all tables, charts, pages and films that stand in `directory` itself into `directory`/previous-1, or
/// the first free number, and gives that folder; nothing where there are none. The list of jobs stays. Throws
/// results::ResultError.
std::optional<std::filesystem::path> back_up_tables(const std::filesystem::path& directory);

}  // namespace diefill::process
