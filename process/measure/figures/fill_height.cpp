#include <cmath>

#include "process/measure/fields/box_map.h"
#include "process/measure/figures/figures.h"

namespace diefill::process {
namespace {

double mean_or_empty(const std::vector<double>& heights) {
  double sum = 0;
  for (const double height : heights) sum += std::isfinite(height) ? height : 0;
  return sum / static_cast<double>(heights.size());
}

}  // namespace

void fill_height(const results::FillResult& result, Figures& figures) {
  for (const auto& profile : result.profiles)
    if (profile.quantity == "fill level" && !profile.y.empty()) {
      figures["fill_height_mm"] = mean_or_empty(profile.y);
      return;
    }
  if (!result.cavity.is_ring) figures["fill_height_mm"] = mean_or_empty(fill_level_along_travel(result).y);
}

}  // namespace diefill::process
