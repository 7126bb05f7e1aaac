// Numbers from one unit into another, where the units come from a user's file and not from a key's rule.
#pragma once

#include <string>
#include <string_view>

#include "process/input/units.h"

namespace diefill::process {

/// What one `from` is in `to`; "1", "-" and "" are plain numbers, "%" hundredths. Throws UnitError for a unit
/// that is unknown, or of another dimension.
double unit_factor(std::string_view from, std::string_view to);

/// Whether unit_factor() knows both units and takes one into the other.
bool has_same_dimension(std::string_view one, std::string_view other);

/// A number and the unit after it, "1" where there is none.
struct NumberWithUnit {
  double number = 0;
  std::string unit;
};

/// Reads "12.1 g" or "0.31". Throws UnitError for a text that does not begin with a finite number, and for an
/// unknown unit.
NumberWithUnit number_with_unit(std::string_view text);

}  // namespace diefill::process
