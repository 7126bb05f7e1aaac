// Empty words on the command line, such as --out '' of a variable without content: they would count as not
// given.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace diefill::app {

/// What is wrong with the first empty or blank word of `words` (those behind the program's name), or with an
/// option given as "--name="; nothing where there is none.
std::optional<std::string> empty_argument(const std::vector<std::string>& words);

}  // namespace diefill::app
