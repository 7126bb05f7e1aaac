// Which voxels of a grid solids block. Solids are met exactly along the lines of voxel centres, so that walls
// thinner than a voxel still block and fits narrower than a given width can be taken as closed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/reach/line_crossings.h"
#include "geometry/reach/voxel_grid.h"

namespace diefill::geometry {

/// A stretch of a line, m along its axis.
struct Span {
  double begin = 0, end = 0;
};

/// The stretches that the lines of voxel centres along one axis spend inside one solid.
class SolidRows {
 public:
  /// `mesh` (m, in the grid's frame) is closed and outward; shells that overlap count as one solid.
  /// `crossings` is working memory.
  SolidRows(const Mesh& mesh, const VoxelGrid& grid, int axis, LineCrossings& crossings);

  struct Row {
    std::size_t row;  ///< number of the line: v * counts[u] + u, where u = axis + 1, v = axis + 2 (modulo 3)
    Span span;
  };
  /// Sorted by line, then along the line; the stretches of a line do not overlap.
  const std::vector<Row>& rows() const { return rows_; }
  int axis() const { return axis_; }

 private:
  int axis_;
  std::vector<Row> rows_;
};

/// All stretches of `solids` (of one axis), line after line, joined where they overlap or where the gap
/// between them is narrower than `closing` (m).
std::vector<SolidRows::Row> joined_rows(std::span<const SolidRows* const> solids, double closing);

/// Sets to 1 the voxels of `blocked` whose centres lie in `rows`, and for a stretch that holds no centre the
/// voxel in its middle.
void block(const VoxelGrid& grid, int axis, std::span<const SolidRows::Row> rows,
           std::vector<std::uint8_t>& blocked);

/// Voxels (one byte each, 1 for blocked) that `meshes` fill, fits narrower than `closing` (m) along an axis
/// included.
std::vector<std::uint8_t> blocked_voxels(const VoxelGrid& grid, std::span<const Mesh* const> meshes,
                                         double closing);

/// Blocks every stretch of free voxels along x, then y, then z that is shorter than `closing` (m) and has
/// blocked voxels at both ends. It closes the corners where fits meet, which no line across a fit passes
/// through.
void close_short_stretches(const VoxelGrid& grid, double closing, std::vector<std::uint8_t>& blocked);

}  // namespace diefill::geometry
