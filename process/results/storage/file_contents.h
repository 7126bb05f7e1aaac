// The whole contents of a file as one string.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace diefill::results {

/// All bytes of `file`; nothing where it cannot be opened, such as a missing one. Throws ResultError where it
/// cannot be read to its end.
std::optional<std::string> contents_or_nothing(const std::filesystem::path& file);

}  // namespace diefill::results
