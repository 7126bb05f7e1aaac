#include "process/laboratory/published/bed_window.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/simulation/standard_gravity.h"
#include "geometry/voronoi/neighbour_grid.h"
#include "process/measure/period.h"
#include "process/results/none.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kGravity = engine::kStandardGravity;  // m/s^2

/// Volume (m^3) of a sphere below a height over its centre: a cap, pi h^2 (R - h / 3).
double cap_below(double radius, double height) {
  const double h = std::clamp(height + radius, 0.0, 2 * radius);
  return std::numbers::pi * h * h * (radius - h / 3);
}

}  // namespace

double volume_between(const results::PowderState& powder, double from, double to) {
  double volume = 0;
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    const double radius = powder.sphere_radius_of(k), height = powder.position[k][2];
    volume += cap_below(radius, to - height) - cap_below(radius, from - height);
  }
  return volume;
}

double fraction_between(const results::PowderState& powder, double from, double to) {
  return volume_between(powder, from, to) / (powder.period[0] * powder.period[1] * (to - from));
}

double contacts_between(const results::PowderState& powder, double from, double to) {
  const double largest = powder.largest_sphere_radius();
  const auto all = geometry::with_periodic_images(powder.position, period_of(powder), 2 * largest);
  const geometry::NeighbourGrid grid(all.points, 2 * largest);
  double spheres = 0, contacts = 0;
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    if (powder.position[k][2] < from || powder.position[k][2] > to) continue;
    ++spheres;
    const double radius = powder.sphere_radius_of(k);
    grid.for_each_within(all.points[k], radius + largest,
                         [&](std::uint32_t other, const auto&, double squared) {
                           const double apart = radius + powder.sphere_radius_of(all.source[other]);
                           if (other != k && squared < apart * apart) ++contacts;
                         });
  }
  return spheres > 0 ? contacts / spheres : kNone;
}

std::vector<double> small_share_by_slice(const results::PowderState& powder, double from, double to,
                                         int slices) {
  std::vector<double> small(static_cast<std::size_t>(slices), 0.0), all = small;
  if (powder.monodisperse()) return std::vector<double>(small.size(), 1.0);
  const auto smallest =
      static_cast<std::size_t>(std::min_element(powder.kinds.diameter.begin(), powder.kinds.diameter.end()) -
                               powder.kinds.diameter.begin());
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    const double place = (powder.position[k][2] - from) / (to - from) * slices;
    if (place < 0 || place >= slices) continue;
    const auto slice = static_cast<std::size_t>(place);
    all[slice] += powder.mass_of(k);
    if (powder.kind[k] == smallest) small[slice] += powder.mass_of(k);
  }
  for (std::size_t slice = 0; slice < all.size(); ++slice)
    small[slice] = all[slice] > 0 ? small[slice] / all[slice] : kNone;
  return small;
}

double top_of(const results::PowderState& powder) {
  double top = 0;
  for (std::size_t k = 0; k < powder.position.size(); ++k)
    top = std::max(top, powder.position[k][2] + powder.sphere_radius_of(k));
  return top;
}

double kinetic_energy_over_weight(const results::PowderState& powder) {
  double energy = 0, mass = 0, volume = 0;
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    energy += 0.5 * powder.mass_of(k) * powder.velocity[k].squaredNorm();
    mass += powder.mass_of(k);
    volume += std::pow(powder.diameter_of(k), 3);
  }
  const double diameter = std::cbrt(volume / static_cast<double>(powder.position.size()));
  return energy / (mass * kGravity * diameter);
}

}  // namespace diefill::process::laboratory
