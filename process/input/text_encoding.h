// Whether the bytes of a file are text in UTF-8, and which encoding they seem to be in where they are not.
#pragma once

#include <filesystem>
#include <string>

namespace diefill::process {

/// What a text is to be, for messages.
enum class TextKind { scene, calibration, csv };

/// Throws SceneError, naming `file` and the line, for UTF-16, UTF-32, bytes that are not UTF-8 and control
/// characters other than tab and line ends.
void refuse_wrong_encoding(const std::string& text, const std::filesystem::path& file,
                           TextKind kind = TextKind::scene);

}  // namespace diefill::process
