// Frames into a film file, with the program that can: ffmpeg.
#pragma once

#include <filesystem>

namespace diefill::app {

/// Names of the films in a run's directory, which its report shows.
inline constexpr const char *kFilmFile = "film.mp4", *kTurntableFile = "turntable.mp4";

/// Whether ffmpeg is installed.
bool ffmpeg_is_there();

/// Makes `film` (H.264) of the frames 00000.png, 00001.png, ... in a folder, completely or not at all. False,
/// with a hint on standard error, where ffmpeg is not installed. Throws std::runtime_error where it fails.
bool write_film(const std::filesystem::path& frames, const std::filesystem::path& film,
                int frames_a_second = 20);

}  // namespace diefill::app
