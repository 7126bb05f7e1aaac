// A hash of a file's contents at its end, checked before any of them is used.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace diefill::results {

/// The contents with their hash (FNV-1a, 64 bits: any single changed byte changes it) in one line of text
/// after them.
std::string with_hash(std::string contents);

/// Whether the file ends in such a line.
bool ends_in_hash(const std::filesystem::path& file);

/// The contents of such a file without the hash; nothing where they are not what was written. Throws
/// ResultError where the file cannot be read.
std::optional<std::string> read_hashed(const std::filesystem::path& file);

}  // namespace diefill::results
