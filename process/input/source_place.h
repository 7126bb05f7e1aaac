// Where a value stands in a file, for messages about it.
#pragma once

#include <toml++/impl/forward_declarations.h>

#include <filesystem>
#include <string>

namespace diefill::process {

/// "file:line:column"; "--set, change 2" of what comes from elsewhere (parse_changes).
std::string source_place(const std::filesystem::path& file, const toml::source_region& region);

}  // namespace diefill::process
