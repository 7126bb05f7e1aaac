// The unit of a quantity as it is written, such as "m/s^2" or "Pa s": names of units, powers, products and
// quotients, and nothing else. The grammar of udunits2 also accepts numbers, origins and logarithms, which
// would change the value silently, so udunits2 is queried for single names only.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "process/input/unit_system.h"

namespace diefill::process {

/// A text that is no unit. The message says what is wrong with it.
struct UnitTextError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The unit, and how many of its names are angles.
struct ParsedUnit {
  Unit unit;
  int angles = 0;
};

/// Reads names ("mm", "inch"), powers ("s^2", "s2", "s-1", a superscript, 1 to 9), products (blank, "*", ".",
/// "-"), quotients ("/", "per", "1/s") and parentheses. Throws UnitTextError.
ParsedUnit parse_unit(std::string_view text);

/// `text` with blanks, minus signs and multiplication dots of typesetting as those of a keyboard.
std::string as_typed(std::string_view text);

}  // namespace diefill::process
