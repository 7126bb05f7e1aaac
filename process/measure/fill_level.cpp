#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "process/measure/cavity_position.h"
#include "process/measure/measure.h"

namespace diefill::process {

results::Profile fill_level(const results::PowderState& powder, const results::CavityState& cavity,
                            int bins) {
  if (!cavity.is_ring) throw std::invalid_argument("a fill level over azimuth needs a ring");
  if (bins < 1) throw std::invalid_argument("a fill level needs at least one bin");
  results::Profile level{"fill level", "mm", "azimuth", "deg", {}, {}};
  for (int bin = 0; bin < bins; ++bin) level.x.push_back((bin + 0.5) * 360 / bins);
  level.y.assign(level.x.size(), std::numeric_limits<double>::quiet_NaN());
  const auto centres = powder.sphere_centres();
  const auto radii = powder.radii_of_spheres();
  for (std::size_t n = 0; n < centres.size(); ++n) {
    const auto& centre = centres[n];
    const RingPosition place = ring_position(cavity, centre);
    if (place.radius < cavity.inner_radius || place.radius > cavity.outer_radius || place.height < 0)
      continue;
    const int bin = std::min(static_cast<int>(place.azimuth / 360 * bins), bins - 1);
    const double top = (place.height + radii[n]) * 1e3;
    if (!(level.y[bin] >= top)) level.y[bin] = top;  // also where there was none (NaN)
  }
  return level;
}

}  // namespace diefill::process
