#include "process/measure/fields/averaging_width.h"

#include <algorithm>

namespace diefill::process {

double default_averaging_width(double grain_diameter) {
  constexpr double kMin = 5e-4;  // m
  return std::max(kMin, 0.5 * grain_diameter);
}

double least_averaging_width(double grain_diameter) {
  return 0.1 * grain_diameter;
}

double largest_averaging_width(double grain_diameter, double largest_edge) {
  return std::max(default_averaging_width(grain_diameter), largest_edge);
}

double measured_averaging_width(const results::FillResult& result) {
  if (!result.sections.empty()) return result.sections.front().field.averaging_width;
  return result.maps.empty() ? 0 : result.maps.front().averaging_width;
}

double usual_averaging_width(const results::FillResult& result) {
  const double measured = measured_averaging_width(result), grain = result.powder.grain_diameter;
  return measured > 0 ? std::max(measured, least_averaging_width(grain)) : default_averaging_width(grain);
}

}  // namespace diefill::process
