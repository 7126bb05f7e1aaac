// Empty command-line arguments, such as --out '' from an empty shell variable: they would count as not given.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace diefill::app {

/// A message about the first empty or blank argument in `words` (without the program's name), or about an
/// option given as "--name="; nothing where there is none.
std::optional<std::string> empty_argument(const std::vector<std::string>& words);

}  // namespace diefill::app
