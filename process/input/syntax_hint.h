// Hints on lines of a scene that are not TOML.
#pragma once

#include <string>

namespace diefill::process {

/// What to do about `line` (without blanks at its ends), which the parser refused for `reason`; begins with
/// "; ", or is empty. An example made of the line is given only where it is TOML itself.
std::string syntax_hint(const std::string& line, const std::string& reason);
/// The same of a line of changes to a scene, such as those of --set.
std::string change_hint(const std::string& line, const std::string& reason);

}  // namespace diefill::process
