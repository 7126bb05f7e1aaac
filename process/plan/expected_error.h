// What is known of the error of a run: measured points, each with its source. Nothing is guessed between
// them.
#pragma once

#include <optional>
#include <string>

#include "process/scene/scene.h"

namespace diefill::process::plan {

/// A measured error that applies to a scene.
struct ExpectedError {
  std::string quantity;  ///< such as "mean solid fraction of settled powder"
  double error = 0;      ///< over the value that it is held against
  std::string source;    ///< table that it comes from
};

/// The error to be expected with grains of this diameter (m) in a cavity of this narrowest width (m, 0:
/// none); nothing where it has not been measured.
std::optional<ExpectedError> expected_error(const PowderSpec& powder, double grain_diameter, double width);

}  // namespace diefill::process::plan
