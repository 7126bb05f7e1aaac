// Finds the voxels of the cavity: free space below the fill plane from which there is no way out but upwards.
#pragma once

#include <optional>

#include "geometry/voxel_grid.h"

namespace diefill::geometry {

/// The largest enclosed space of a grid whose top is the fill plane.
struct CavityRegion {
  VoxelGrid grid;
  std::vector<std::uint8_t> inside;  ///< one byte a voxel, 1 in the cavity
  Box box;                           ///< m, from wall to wall along the lines of voxel centres
  double volume = 0;                 ///< m^3, exact along z
};

/// Looks for a cavity in `grid`, whose top is the fill plane; nothing when every free space has a way out
/// through the grid's sides or bottom.
std::optional<CavityRegion> find_cavity_region(std::span<const Mesh* const> solids, const VoxelGrid& grid);

}  // namespace diefill::geometry
