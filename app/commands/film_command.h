// The command that makes films.
#pragma once

#include <filesystem>
#include <string>

#include "app/commands/commands.h"

namespace diefill::app {

/// A film of the run whose results are in `directory`, or its frames beside `film` where ffmpeg is missing.
/// Throws what the command throws.
void make_film(const std::filesystem::path& directory, const std::filesystem::path& film,
               const std::string& colour_by);

void add_film(CLI::App& program, Action& chosen);

}  // namespace diefill::app
