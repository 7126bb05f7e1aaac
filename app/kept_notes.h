// What is said of earlier results that a command keeps aside.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace diefill::app {

/// A line on standard error.
void say_note(const std::string& line);

/// Says where earlier tables and charts are kept, if they are.
void say_what_is_kept(const std::optional<std::filesystem::path>& folder);

}  // namespace diefill::app
