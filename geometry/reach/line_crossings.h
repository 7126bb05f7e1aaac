// Where the lines of voxel centres along one axis cross the surface of a solid.
#pragma once

#include <span>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/reach/voxel_grid.h"

namespace diefill::geometry {

/// A crossing of a line with a triangle.
struct Crossing {
  std::size_t row;  ///< number of the line: v * counts[u] + u, where u = axis + 1, v = axis + 2 (modulo 3)
  double along;     ///< m, coordinate along the axis
  int winding;      ///< +1 where the line enters the solid, -1 where it leaves
};

/// Finds crossings and keeps its arrays: moving tools are queried in every pose, and allocating the
/// arrays costs more than filling them.
class LineCrossings {
 public:
  /// All crossings with `mesh` (m, in the grid's frame), by line, then along the line; valid until the next
  /// call.
  std::span<const Crossing> find(const Mesh& mesh, const VoxelGrid& grid, int axis);

 private:
  void sort(std::size_t lines);

  std::vector<Crossing> crossings_, sorted_;
  std::vector<std::size_t> ends_;
};

}  // namespace diefill::geometry
