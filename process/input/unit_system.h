// The units that udunits2 knows, and what a unit is made of.
#pragma once

#include <udunits2.h>

#include <memory>

namespace diefill::process {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

/// udunits2's database, with "deg" added. Throws std::runtime_error where it cannot be read.
ut_system* unit_system();

/// What a unit is made of.
struct UnitMakeup {
  bool proportional = true;  ///< false for origins (degree Celsius, times since a date) and logarithms
  bool pure_number = false;  ///< such as percent or pi; angles are none
  int angle = 0;             ///< power of the radian, which udunits2 takes for a number
};

UnitMakeup makeup_of(const ut_unit* unit);

}  // namespace diefill::process
