#include "process/measure/powder_surface.h"

#include <algorithm>

#include "geometry/voronoi/neighbour_grid.h"
#include "process/measure/period.h"

namespace diefill::process {

std::vector<double> depth_below_surface(const results::PowderState& powder) {
  std::vector<double> depth(powder.position.size(), 0);
  if (powder.position.empty() || !(powder.grain_diameter > 0)) return depth;
  std::vector<Eigen::Vector3d> plan = powder.position;  // seen from above
  for (auto& place : plan) place.z() = 0;
  Period period = period_of(powder);
  period[2].reset();
  const auto all = geometry::with_periodic_images(plan, period, powder.grain_diameter);
  const geometry::NeighbourGrid grid(all.points, powder.grain_diameter);
  for (std::size_t k = 0; k < plan.size(); ++k) {
    double surface = powder.position[k].z();
    grid.for_each_within(all.points[k], powder.grain_diameter, [&](std::uint32_t image, const auto&, double) {
      surface = std::max(surface, powder.position[all.source[image]].z());
    });
    depth[k] = surface - powder.position[k].z();
  }
  return depth;
}

}  // namespace diefill::process
