// A field with arrows on it: velocities, displacements.
#pragma once

#include <vector>

#include "process/results/fill_result.h"

namespace diefill::results {

/// An arrow in a plane: its foot in the field's coordinates, its components in the unit of the quantity along
/// the first and second coordinate as lengths (azimuth: along the circumference).
struct PlaneArrow {
  double first = 0, second = 0;
  double along_first = 0, along_second = 0;
};

/// A magnitude in a plane, and the directions that go with it.
struct ArrowField {
  Field2D field;     ///< the magnitude, all three components
  std::string unit;  ///< of values and arrows, such as "m/s"
  std::vector<PlaneArrow> arrows;
};

}  // namespace diefill::results
