#include "process/measure/coordination.h"

#include <algorithm>

#include "geometry/voronoi/neighbour_grid.h"
#include "process/measure/period.h"

namespace diefill::process {

std::vector<int> coordination_numbers(const results::PowderState& powder, double tolerance) {
  const auto radii = powder.radii_of_spheres();
  const auto grain_of = powder.grains_of_spheres();
  const double reach = 2 * powder.largest_sphere_radius() * (1 + tolerance);
  const auto all = geometry::with_periodic_images(powder.sphere_centres(), period_of(powder), reach);
  const geometry::NeighbourGrid grid(all.points, reach);
  std::vector<int> numbers;
  std::vector<std::size_t> touched;
  const bool equal = powder.equal_spheres();
  const auto touches = [&](std::size_t sphere, std::size_t other, double squared) {
    const double apart = (radii[sphere] + radii[other]) * (1 + tolerance);
    return equal || squared <= apart * apart;
  };
  std::size_t s = 0;
  for (std::size_t grain = 0; grain < powder.position.size(); ++grain) {
    touched.clear();
    for (const std::size_t end = s + powder.spheres_of(grain); s < end; ++s)
      grid.for_each_within(all.points[s], reach, [&](std::uint32_t image, const auto&, double squared) {
        const std::uint32_t other = all.source[image];
        if (grain_of[other] != grain && touches(s, other, squared)) touched.push_back(grain_of[other]);
      });
    std::sort(touched.begin(), touched.end());
    const auto last = std::unique(touched.begin(), touched.end());
    numbers.push_back(static_cast<int>(last - touched.begin()));
  }
  return numbers;
}

}  // namespace diefill::process
