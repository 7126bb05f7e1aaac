// Quantities with unit on the command line, such as --averaging-width '1 mm', within limits.
#pragma once

#include <string>

#include "process/input/units.h"

namespace diefill::app {

/// Limits in SI units.
struct QuantityLimits {
  double least = 0, most = 0;
  bool above_least = false;  ///< `least` itself is not allowed
  std::string reason;        ///< why, such as "a tenth of a grain to the cavity"; may be empty
};

/// The value of `text` in SI units. Throws process::SceneError, in one line that begins with `option`, for
/// anything but a quantity of that dimension within the limits.
double bounded_quantity(const std::string& option, const std::string& text, process::Dimension dimension,
                        const QuantityLimits& limits);

/// The same of a quantity above 0 with the widest limits that make sense for powder, dies and presses.
double positive_quantity(const std::string& option, const std::string& text, process::Dimension dimension);

/// m: a place in a scene, up to 1 km from its origin.
double coordinate(const std::string& option, const std::string& text);

}  // namespace diefill::app
