// A film of a run for other commands, made by `diefill film`.
#pragma once

#include <filesystem>
#include <string>

namespace diefill::app {

/// A film of the run whose results are in `directory`, or its frames beside `film` where ffmpeg is missing:
/// by the command in a program of its own, because frames are drawn by forked processes, and what this one
/// may have drawn with has threads that forks lack. Throws std::runtime_error with what that program says.
void make_film(const std::filesystem::path& directory, const std::filesystem::path& film,
               const std::string& colour_by);

}  // namespace diefill::app
