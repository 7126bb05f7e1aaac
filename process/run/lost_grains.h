// Grains inside tools: those that passed through a wall, which ends a run, and those that fell where no
// powder was expected and no wall stands, which count as spilled.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/simulation/simulation.h"
#include "geometry/grids/point_grid.h"
#include "geometry/reach/voxel_grid.h"
#include "geometry/solid/solid_query.h"
#include "process/run/stray_watch.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

/// Finds grains whose centre is more than half a grain deep in a tool.
class LostGrains {
 public:
  /// `grain_diameters`: m, of each particle type, ascending. Prepares fast checks;
  /// `tooling` must outlive it.
  LostGrains(const Tooling& tooling, std::vector<double> grain_diameters);

  /// Grains that came into a tool where it carries no wall spheres, each once, by id; `interval`: s since the
  /// last check. Throws engine::OutOfRange for one that came in through a wall.
  std::vector<StrayGrain> strayed(const engine::Simulation& simulation, double interval) const;

 private:
  struct Inside {
    geometry::SolidQuery solid;
    geometry::VoxelGrid grid;           ///< body frame
    std::vector<std::uint8_t> blocked;  ///< 1 where a voxel's centre is inside: tested before the solid is;
                                        ///< empty for very many voxels
    geometry::PointGrid wall_spheres;   ///< m, centres
    double cover_reach;                 ///< m, covered surface has a centre so near
  };
  Eigen::Vector3d entry(const Inside& tool, const Eigen::Vector3d& place, const Eigen::Vector3d& velocity,
                        double grain_diameter, double interval) const;

  const Tooling& tooling_;
  std::vector<double> grain_diameters_;
  std::vector<Inside> tools_;
};

}  // namespace diefill::process
