// Numbers in messages with as many digits as needed: what was found and what is allowed must not look the
// same.
#pragma once

#include <string>
#include <utility>

namespace diefill::process {

/// Two different numbers with so many digits, six or more, that they differ as text, too.
std::pair<std::string, std::string> numbers_apart(double one, double other);

}  // namespace diefill::process
