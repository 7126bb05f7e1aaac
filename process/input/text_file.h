// A text file that belongs to a scene, read whole: found, readable, and no larger than such a file can be.
#pragma once

#include <filesystem>
#include <string>

namespace diefill::process {

/// What a file is to be, for messages.
struct TextFileKind {
  std::string called;       ///< such as "scene file"
  std::string description;  ///< such as "a scene is a short TOML text"
  std::size_t largest = 0;  ///< bytes
};

/// The bytes of a regular file. Throws std::runtime_error with the reason ("found a folder, ...") when it is
/// missing, a folder, a device or a pipe, larger than its kind allows, or not readable. Never reads more than
/// its kind allows, whatever size the file states.
std::string load_text_file(const std::filesystem::path& file, const TextFileKind& kind);

}  // namespace diefill::process
