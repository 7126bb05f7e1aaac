// Text as TOML has it.
#pragma once

#include <string>

namespace diefill::process {

/// The text in quotes, with whatever stands in it escaped: as a value, or as a part of a key.
std::string toml_string(const std::string& text);

}  // namespace diefill::process
