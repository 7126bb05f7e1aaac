// Files that `diefill map --measured` writes, so that it replaces its own and no others.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace diefill::results {

/// The first file in `directory` that the comparison with the measured file of this name (without folder and
/// ending) would replace, though no earlier comparison has written it; nothing where there is none.
std::optional<std::filesystem::path> foreign_measured_file(const std::filesystem::path& directory,
                                                           const std::string& name);

}  // namespace diefill::results
