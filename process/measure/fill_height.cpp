#include <algorithm>
#include <cmath>

#include "process/measure/cavity_position.h"
#include "process/measure/figures.h"

namespace diefill::process {
namespace {

constexpr double kSliceWidth = 2;  // d: wide enough to meet a grain of the topmost layer

double mean_or_empty(const std::vector<double>& heights) {
  double sum = 0;
  for (const double height : heights) sum += std::isfinite(height) ? height : 0;
  return sum / static_cast<double>(heights.size());
}

/// mm above the floor, slice by slice from the end where the shoe arrives.
std::vector<double> levels_along_travel(const results::FillResult& result) {
  const auto& powder = result.powder;
  const double length = travel_length(result.cavity);
  const int slices = std::max(1, static_cast<int>(length / (kSliceWidth * powder.grain_diameter)));
  std::vector<double> level(static_cast<std::size_t>(slices), 0.0);
  const auto centres = powder.sphere_centres();
  const std::size_t spheres = powder.sphere_offsets.size();
  for (std::size_t n = 0; n < centres.size(); ++n) {
    const auto& centre = centres[n];
    const double height = centre.z() - result.cavity.lower_corner.z();
    const bool within = (centre.head<2>().array() >= result.cavity.lower_corner.head<2>().array()).all() &&
                        (centre.head<2>().array() <= result.cavity.upper_corner.head<2>().array()).all();
    if (!within || height < 0) continue;
    const int slice =
        std::clamp(static_cast<int>(along_travel(result.cavity, centre) * slices), 0, slices - 1);
    double& top = level[static_cast<std::size_t>(slice)];
    top = std::max(top, 1e3 * (height + powder.sphere_radius_of(n / spheres)));
  }
  return level;
}

}  // namespace

void fill_height(const results::FillResult& result, Figures& figures) {
  for (const auto& profile : result.profiles)
    if (profile.quantity == "fill level" && !profile.y.empty()) {
      figures["fill_height_mm"] = mean_or_empty(profile.y);
      return;
    }
  if (!result.cavity.is_ring) figures["fill_height_mm"] = mean_or_empty(levels_along_travel(result));
}

}  // namespace diefill::process
