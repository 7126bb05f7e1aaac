#include "process/estimate/inflow.h"

#include <algorithm>
#include <cmath>

namespace diefill::process::estimate {

namespace {

/// kg/m^2 of the place that run down through it in one exposure.
double inflow_per_area(const OpeningPatch& place, const Exposure& exposure, const InflowPowder& powder,
                       double faster) {
  const double width = effective_width(place.width, powder);
  if (!(width > 0)) return 0;
  const double along = std::max(width, effective_width(place.chord, powder));
  const double fresh = std::max(1.0, exposure.travel / along);
  const double time = exposure.seconds / faster / fresh;
  const double x = time * std::sqrt(powder.gravity / width) - continuum::kBurst;
  return width / place.width * powder.density * fresh * width * discharged_share(powder.law, x);
}

}  // namespace

double effective_width(double width, const InflowPowder& powder) {
  return continuum::effective_width(width, std::max(0.0, powder.grain_diameter - powder.law.grain_diameter));
}

std::vector<std::vector<double>> inflow(const OpeningLayout& layout, const ShoePath& path,
                                        const InflowPowder& powder, double faster) {
  std::vector<std::vector<double>> mass(layout.openings.size(), std::vector<double>(path.crossings, 0.0));
  for (std::size_t k = 0; k < layout.places.size(); ++k) {
    const OpeningPatch& place = layout.places[k];
    for (std::size_t n = 0; n < path.exposures[k].size(); ++n)
      mass[place.opening][n] += place.area * inflow_per_area(place, path.exposures[k][n], powder, faster);
  }
  return mass;
}

}  // namespace diefill::process::estimate
