// Adjacency of the triangles of a mesh: merged corners, neighbours across edges, and where the surface is
// clean.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/mesh/triangle.h"

namespace diefill::geometry {

/// Adjacency of the triangles of a mesh; corners at exactly the same place count as one whatever their
/// indices.
struct Topology {
  static constexpr std::int64_t kNone = -1;

  std::vector<std::int64_t> vertex;  ///< of a mesh vertex: the first vertex at the same place
  std::vector<std::array<std::int64_t, 3>>
      neighbour;                       ///< triangle across edge k, kNone where not exactly one
  std::vector<std::uint8_t> left_out;  ///< 1 for degenerate and duplicate triangles

  std::int64_t corner(const Mesh& mesh, std::size_t triangle, int k) const {
    return vertex[static_cast<std::size_t>(mesh.triangles[triangle][k])];
  }
};

/// Finds the adjacency of `mesh`. Degenerate triangles and second copies are left out and border nothing;
/// triangles next to them, at open or non-manifold edges or with opposite orientation have no neighbour
/// there.
Topology find_topology(const Mesh& mesh);

/// Corners of one triangle of a mesh, m.
Corners corners_of(const Mesh& mesh, std::size_t triangle);

}  // namespace diefill::geometry
