#include "process/compare/compared_measures.h"

#include <limits>

namespace diefill::process {

const std::vector<MeasureOfComparison>& compared_measures() {
  static const std::vector<MeasureOfComparison> all = {
      {"expected_mass_kg", "mass of the real powder in the cavity", "g", 1e3, 0},
      {"estimated_mass_kg", "mass of the real powder in the cavity, estimated", "g", 1e3, 0},
      {"fill_ratio", "fill ratio of a die full at apparent density", "1", 1, 0},
      {"filled_mass_kg", "filled mass of model powder", "g", 1e3, 0},
      {"solid_fraction_mean", "mean solid fraction", "1", 1, 0},
      {"solid_fraction_field_std", "standard deviation of the averaged solid fraction", "1", 1, 0},
      {"solid_fraction_std", "standard deviation over single grains", "1", 1, 0},
      {"solid_fraction_top_minus_bottom", "solid fraction, top minus bottom third", "1", 1, 0},
      {"solid_fraction_harmonic_1", "first harmonic over the azimuth, amplitude", "1", 1, 0},
      {"solid_fraction_harmonic_1_azimuth_deg", "first harmonic, densest at", "deg", 1, 360},
      {"solid_fraction_harmonic_2", "second harmonic over the azimuth, amplitude", "1", 1, 0},
      {"solid_fraction_harmonic_2_azimuth_deg", "second harmonic, densest at (and 180 deg on)", "deg", 1,
       180},
      {"solid_fraction_along_travel_1", "arrival end denser than far end, half the difference", "1", 1, 0},
      {"solid_fraction_along_travel_2", "ends denser than the middle, half the difference", "1", 1, 0},
      {"mean_grain_diameter_filled_mm", "mean grain diameter in the cavity, by mass", "mm", 1, 0},
      {"mean_grain_diameter_top_minus_bottom_mm", "mean grain diameter, top minus bottom third", "mm", 1, 0},
      {"mixing_index_height", "mixing index over height", "1", 1, 0},
      {"mixing_index_azimuth", "mixing index over azimuth", "1", 1, 0},
      {"mixing_index_travel", "mixing index along the travel", "1", 1, 0},
      {"fill_height_mm", "fill height", "mm", 1, 0},
      {"cycle_time_s", "cycle time", "s", 1, 0},
  };
  return all;
}

double value_of(const MeasureOfComparison& measure, const results::FillResult& result) {
  if (measure.key == "solid_fraction_mean") return result.summary.mean;
  if (measure.key == "solid_fraction_std") return result.summary.std;
  const auto figure = result.figures.find(measure.key);
  if (figure == result.figures.end()) return std::numeric_limits<double>::quiet_NaN();
  return measure.factor * figure->second;
}

}  // namespace diefill::process
