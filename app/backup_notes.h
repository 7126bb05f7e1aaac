// Notes about earlier results that a command has moved to another folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace diefill::app {

/// A line on standard error.
void print_note(const std::string& line);

/// Reports where earlier tables and charts were moved, if they were.
void note_moved_results(const std::optional<std::filesystem::path>& folder);

}  // namespace diefill::app
