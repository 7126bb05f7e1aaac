// Results without a hash of their contents, as earlier versions wrote them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace diefill::results {

/// What `read` returns, called in a child process: whatever damaged bytes do to a library there, a crash
/// included, ends in a ResultError naming `file`. The child has a minute of processor time, and memory in
/// proportion to the file.
std::string read_in_child(const std::filesystem::path& file, const std::function<std::string()>& read);

}  // namespace diefill::results
