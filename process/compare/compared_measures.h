// The measures by which variants are compared.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process {

/// A number of a result: a figure that results/figure_table marks as compared, or one of an item of the
/// scene, such as a zone.
struct MeasureOfComparison {
  std::string key;   ///< name of the figure
  std::string name;  ///< for people
  std::string unit;
  double factor = 1;  ///< from the figure to `unit`
  double period = 0;  ///< in `unit`, for angles that come round again; 0: none
};

/// Those that any result can have.
const std::vector<MeasureOfComparison>& compared_measures();

/// Figures among `keys` that belong to an item of the scene, such as "solid_fraction_in_flange".
std::vector<MeasureOfComparison> measures_of_named(const std::set<std::string>& keys);

/// The value in its unit; NaN where the result has none.
double value_of(const MeasureOfComparison& measure, const results::FillResult& result);

}  // namespace diefill::process
