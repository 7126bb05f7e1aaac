// The powder that a calibration starts from, put into the scenes of its measurements, and the powder that it
// has found as a file.
#pragma once

#include <filesystem>
#include <string>

#include "process/scene/scene.h"

namespace diefill::process::calibration {

/// The text of the scene file with [powder], [contact] and [walls] of `powder` (a scene, or a powder file) in
/// place of its own; its grain_diameter stays where it gives one. With an empty `powder`, the scene as it is,
/// its powder file filled in. What the powder was fitted with is left out. Throws SceneError.
std::string with_starting_powder(const std::filesystem::path& scene, const std::filesystem::path& powder);

/// The same of a scene's text, read from `file`.
std::string with_starting_powder(const std::string& text, const std::filesystem::path& file,
                                 const std::filesystem::path& powder);

/// [powder], [contact] and [walls] of a scene's text as a powder file, with what they were fitted with and,
/// at its end, `account` (TOML, the table [calibration]). `comment`: lines at the top.
std::string powder_file_text(const Scene& scene, const std::string& comment, const std::string& account,
                             const std::string& program_version);

}  // namespace diefill::process::calibration
