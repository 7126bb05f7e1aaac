// Where the program's files go, and what it says when they cannot be written.
#pragma once

#include <filesystem>
#include <functional>

namespace diefill::app {

/// Makes the directory, with those above it, before hours are spent on what is to go there. Throws
/// std::runtime_error, in one line, when it cannot be made or written to.
void make_output_directory(const std::filesystem::path& directory);

/// Calls `write`. A results::ResultError of writing, as on a full disk, goes on as a std::runtime_error: not
/// the scene's fault.
void write_output(const std::function<void()>& write);

}  // namespace diefill::app
