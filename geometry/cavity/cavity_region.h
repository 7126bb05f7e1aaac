// Finds the voxels of cavities: free space below the fill plane whose only way out is upwards.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/reach/voxel_grid.h"

namespace diefill::geometry {

/// m, a gap of 0.2 mm across, seen along an axis it is inclined to by 45 degrees. Narrower ones are fits
/// between tools.
inline constexpr double kLargestFit = 2e-4 * 1.4142;

/// An enclosed space of a grid whose top is the fill plane.
struct CavityRegion {
  VoxelGrid grid;
  std::vector<std::uint8_t> inside;  ///< one byte a voxel, 1 in the cavity
  Box box;                           ///< m, from wall to wall along the lines of voxel centres
  double volume = 0;                 ///< m^3, exact along z
};

/// Finds cavities in `grid`, whose top is the fill plane, and returns them by falling number of voxels,
/// none below a hundredth of the largest; nothing when every free space has a way out through the grid's
/// sides or bottom.
std::vector<CavityRegion> find_cavity_regions(std::span<const Mesh* const> solids, const VoxelGrid& grid);

}  // namespace diefill::geometry
