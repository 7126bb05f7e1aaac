#include <cmath>
#include <limits>

#include "process/measure/fields/averaging_width.h"
#include "process/measure/fields/gaussian_field.h"
#include "process/measure/figures/counted_grains.h"
#include "process/measure/figures/figures.h"

namespace diefill::process {

void field_evenness(const results::FillResult& result, Figures& figures) {
  double& deviation = figures["solid_fraction_field_std"] = std::numeric_limits<double>::quiet_NaN();
  const auto grains = counted_grains(result.powder, result.solid_fraction, true);
  const double width = measured_averaging_width(result);
  if (grains.empty() || !(width > 0)) return;
  const GaussianField field(result.powder, result.solid_fraction, width);
  std::vector<double> values;
  double mean = 0;
  for (const std::size_t k : grains) {
    values.push_back(field.at(result.powder.position[k]));
    mean += values.back() / static_cast<double>(grains.size());
  }
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  deviation = std::sqrt(squares / static_cast<double>(grains.size()));
}

}  // namespace diefill::process
