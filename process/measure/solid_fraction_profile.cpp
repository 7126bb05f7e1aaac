#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "process/measure/measure.h"

namespace diefill::process {
namespace {

/// Eq. 2.27 with the distance taken along z alone, which is its mean over x and y for a bed that fills its
/// box.
double value_at(double z, const std::vector<std::pair<double, double>>& grains, double width, double hole) {
  const double reach = std::max(4 * width, hole);
  const auto below = [](const std::pair<double, double>& grain, double height) {
    return grain.first < height;
  };
  double nearest = std::numeric_limits<double>::max(), weights = 0, sum = 0;
  for (auto grain = std::lower_bound(grains.begin(), grains.end(), z - reach, below);
       grain != grains.end() && grain->first <= z + reach; ++grain) {
    const double distance = grain->first - z;
    const double weight = std::exp(-0.5 * distance * distance / (width * width));
    nearest = std::min(nearest, std::abs(distance));
    weights += weight;
    sum += weight * grain->second;
  }
  return nearest <= hole && weights > 0 ? sum / weights : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

results::Profile solid_fraction_profile(const results::PowderState& powder,
                                        const results::GrainSolidFraction& fraction, double floor,
                                        double averaging_width) {
  if (!(averaging_width > 0))
    throw std::invalid_argument("the averaging width of a profile must be positive");
  results::Profile profile{"solid fraction", "1", "height", "mm", {}, {}};
  std::vector<std::pair<double, double>> grains;  // height, solid fraction
  for (std::size_t k = 0; k < powder.position.size(); ++k)
    if (fraction.open[k] == 0) grains.emplace_back(powder.position[k].z(), fraction.solid_fraction[k]);
  std::sort(grains.begin(), grains.end());
  if (grains.empty()) return profile;
  const double hole = std::max(powder.grain_diameter, 1.5 * averaging_width);
  const double top = grains.back().first + 0.5 * powder.grain_diameter;
  for (int n = 0; floor + n * 0.5 * averaging_width <= top; ++n) {
    const double height = n * 0.5 * averaging_width;
    profile.x.push_back(height * 1e3);
    profile.y.push_back(value_at(floor + height, grains, averaging_width, hole));
  }
  return profile;
}

}  // namespace diefill::process
