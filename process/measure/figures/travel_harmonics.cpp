#include <cmath>
#include <numbers>

#include "process/measure/cavity_position.h"
#include "process/measure/figures/counted_grains.h"
#include "process/measure/figures/figures.h"
#include "process/measure/figures/weighted_fit.h"

namespace diefill::process {

void travel_harmonics(const results::FillResult& result, Figures& figures) {
  if (result.cavity.is_ring) return;
  std::vector<FitPoint<3>> points;
  for (const std::size_t k : counted_grains(result.powder, result.solid_fraction, true)) {
    const double angle = std::numbers::pi * along_travel(result.cavity, result.powder.position[k]);
    FitPoint<3> point;
    point.basis << 1, std::cos(angle), std::cos(2 * angle);
    point.value = result.solid_fraction.solid_fraction[k];
    point.weight = result.solid_fraction.cell_volume[k];
    points.push_back(point);
  }
  const auto fit = weighted_fit(points);
  figures["solid_fraction_along_travel_1"] = fit[1];
  figures["solid_fraction_along_travel_2"] = fit[2];
}

}  // namespace diefill::process
