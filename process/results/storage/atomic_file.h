// Files that are written whole or not at all, so that a crash or a full disk never leaves half a result.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace diefill::results {

/// Calls `write` with a temporary path beside `target`, then flushes that file to the disk and renames it to
/// `target`. If `write` throws or the disk is full the temporary file is removed, `target` is as before, and
/// ResultError is thrown.
void write_atomically(const std::filesystem::path& target,
                      const std::function<void(const std::filesystem::path&)>& write);

/// Writes `text` to `target` in the same way.
void write_text_atomically(const std::filesystem::path& target, std::string_view text);

/// Removes temporary files in `directory` that writers of the above have left and that are no longer running,
/// such as a killed run. The caller must have locked the directory.
void remove_abandoned_files(const std::filesystem::path& directory);

}  // namespace diefill::results
