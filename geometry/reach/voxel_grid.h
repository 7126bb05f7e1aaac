// A grid of cubic voxels, and which of them solids block. Solids are met exactly along the lines of voxel
// centres, so that walls thinner than a voxel still block and fits narrower than a given width can be taken
// as closed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

/// Voxels (i, j, k) along x, y, z; the lower corner of (0, 0, 0) is `origin`.
struct VoxelGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< m
  double edge = 0;                                   ///< m
  Eigen::Vector3i counts = Eigen::Vector3i::Zero();

  /// The smallest grid of this edge over `box`, flush with the box's lower corner. Throws MeshError for too
  /// many voxels.
  static VoxelGrid over(const Box& box, double edge);

  std::size_t size() const;
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(counts.y()) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(counts.x()) +
           static_cast<std::size_t>(i);
  }
  bool has(const Eigen::Vector3i& voxel) const {
    return (voxel.array() >= 0).all() && (voxel.array() < counts.array()).all();
  }
  /// The voxel a point (m) lies in; it may lie outside the grid.
  Eigen::Vector3i voxel_at(const Eigen::Vector3d& point) const;
  /// m.
  Eigen::Vector3d centre(const Eigen::Vector3i& voxel) const {
    return origin + (voxel.cast<double>().array() + 0.5).matrix() * edge;
  }
};

/// A stretch of a line, m along its axis.
struct Span {
  double begin = 0, end = 0;
};

/// The stretches that the lines of voxel centres along one axis spend inside one solid.
class SolidRows {
 public:
  /// `mesh` (m, in the grid's frame) is closed and outward; shells that overlap count as one solid.
  SolidRows(const Mesh& mesh, const VoxelGrid& grid, int axis);

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
