// Keeps what earlier runs left in a results directory when a new run begins there.
#pragma once

#include <filesystem>
#include <optional>

namespace diefill::results {

/// Whether back_up_results() on `directory` would move `file`: that directory itself, or what a run has left
/// in it.
bool would_be_moved(const std::filesystem::path& directory, const std::filesystem::path& file);

/// Moves what runs, films and `diefill map` have left in `directory`, known by the names that they give
/// (those of pictures of one result, with or without a number at the end), into its folder `previous-1`, or
/// the first free number; other files stay, also other pictures. Nothing is deleted or replaced. Gives that
/// folder; nothing where there is nothing to move. Throws ResultError where files cannot be moved.
std::optional<std::filesystem::path> back_up_results(const std::filesystem::path& directory);

}  // namespace diefill::results
