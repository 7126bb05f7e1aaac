#include "process/measure/powder_surface.h"

#include <algorithm>

#include "geometry/voronoi/neighbour_grid.h"

namespace diefill::process {

std::vector<double> depth_below_surface(const results::PowderState& powder) {
  std::vector<double> depth(powder.position.size(), 0);
  if (powder.position.empty() || !(powder.grain_diameter > 0)) return depth;
  std::vector<Eigen::Vector3d> plan = powder.position;  // seen from above
  for (auto& place : plan) place.z() = 0;
  const geometry::NeighbourGrid grid(plan, powder.grain_diameter);
  for (std::size_t k = 0; k < plan.size(); ++k) {
    double surface = powder.position[k].z();
    grid.for_each_within(plan[k], powder.grain_diameter, [&](std::uint32_t other, const auto&, double) {
      surface = std::max(surface, powder.position[other].z());
    });
    depth[k] = surface - powder.position[k].z();
  }
  return depth;
}

}  // namespace diefill::process
