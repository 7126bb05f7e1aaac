#include "process/estimate/discharge/inflow.h"

#include <algorithm>
#include <cmath>

namespace diefill::process::estimate {

namespace {

/// kg/m^2 of the place that run down through it in one exposure.
double inflow_per_area(const Portions& portions, const InflowPowder& powder) {
  if (!(portions.width > 0)) return 0;
  const auto fallen = [&](double seconds) {
    return discharged_share(powder.law,
                            seconds * std::sqrt(powder.gravity / portions.width) - continuum::kBurst);
  };
  return portions.share * powder.density * portions.width *
         ((portions.count - 1) * fallen(portions.seconds) + fallen(portions.longest()));
}

}  // namespace

double effective_width(double width, const InflowPowder& powder) {
  return continuum::effective_width(width, std::max(0.0, powder.grain_diameter - powder.law.grain_diameter));
}

Portions portions_of(const OpeningPatch& place, const Exposure& exposure, const ShoePath& path,
                     const InflowPowder& powder, double faster) {
  const double covered = path.extent > 0 ? std::min(place.width, path.extent) : place.width;
  Portions portions;
  portions.width = effective_width(covered, powder);
  if (!(portions.width > 0)) return portions;
  portions.share = portions.width / covered;
  const double along = std::max(portions.width, effective_width(place.chord, powder));
  portions.count = std::max(1.0, exposure.travel / along);
  portions.seconds = exposure.moving / faster / portions.count;
  portions.standing = exposure.standing();
  return portions;
}

std::vector<std::vector<double>> inflow(const OpeningLayout& layout, const ShoePath& path,
                                        const InflowPowder& powder) {
  std::vector<std::vector<double>> mass;
  for (std::size_t k = 0; k < layout.openings.size(); ++k)
    mass.push_back(inflow_at(layout, path, powder, k, path.crossings, 1));
  return mass;
}

std::vector<double> inflow_at(const OpeningLayout& layout, const ShoePath& path, const InflowPowder& powder,
                              std::size_t opening, std::size_t crossings, double faster) {
  std::vector<double> mass(crossings, 0.0);
  for (std::size_t k = 0; k < layout.places.size(); ++k) {
    const OpeningPatch& place = layout.places[k];
    if (place.opening != opening) continue;
    for (std::size_t n = 0; n < std::min(crossings, path.exposures[k].size()); ++n)
      mass[n] += place.area *
                 inflow_per_area(portions_of(place, path.exposures[k][n], path, powder, faster), powder);
  }
  return mass;
}

}  // namespace diefill::process::estimate
