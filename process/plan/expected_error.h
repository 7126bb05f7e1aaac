// What is known of the error of a run: measured, each with its source.
#pragma once

#include <string>
#include <vector>

#include "process/scene/scene.h"

namespace diefill::process::plan {

/// A measured error that applies to a scene.
struct ExpectedError {
  std::string quantity;  ///< such as "mass in the cavity"
  double error = 0;      ///< over the value that it is held against
  double scatter = 0;    ///< standard deviation of one run over seeds, over the same; 0: not measured
  std::string source;    ///< what it was measured on, and the table
};

/// The errors to be expected with grains of this diameter (m) in a cavity of this narrowest width (m, 0:
/// none). With a cavity and d/b up to the coarsest that was run: what the grain size does to mass, mean solid
/// fraction and unevenness, against grains of no size: the largest over the cavities of grain_size_trends.h,
/// of the same powder where it was measured. For presets with a published bed its solid fraction as well.
/// Empty where nothing applies.
std::vector<ExpectedError> expected_errors(const PowderSpec& powder, double grain_diameter, double width);

/// The largest of them; null where there is none.
const ExpectedError* largest(const std::vector<ExpectedError>& errors);

/// "mass in the cavity 3.1 % (scatter 1.2 %)", and so on.
std::string words_of(const std::vector<ExpectedError>& errors);

}  // namespace diefill::process::plan
