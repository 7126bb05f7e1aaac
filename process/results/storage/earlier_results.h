// Keeps what earlier runs left in a results directory when a new run begins there.
#pragma once

#include <filesystem>
#include <optional>

namespace diefill::results {

/// Whether a run has left results or a checkpoint in the directory.
bool holds_results(const std::filesystem::path& directory);

/// Moves what runs and pictures of runs have left in `directory` into its folder `previous-1`, or the first
/// free number; other files stay. Nothing is deleted or replaced. Gives that folder; nothing where the
/// directory holds no results. Throws ResultError where files cannot be moved.
std::optional<std::filesystem::path> set_aside(const std::filesystem::path& directory);

}  // namespace diefill::results
