// Says in an engineer's words whether a mesh encloses a solid: closed, oriented, free of self-intersections,
// degenerate and duplicate triangles (CGAL).
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace diefill::geometry {

/// Findings about one mesh. Counts are of triangles unless said otherwise.
struct MeshFindings {
  std::size_t open_edges = 0;             ///< edges with a triangle on one side only
  std::size_t non_manifold_edges = 0;     ///< edges shared by more than two triangles
  std::size_t degenerate_triangles = 0;   ///< no area
  std::size_t duplicate_triangles = 0;    ///< the same three corners again
  std::size_t self_intersections = 0;     ///< pairs of triangles that cross
  bool consistently_oriented = false;     ///< neighbours agree about outside
  bool outward = false;                   ///< normals point out of the solid (positive volume)
  std::size_t shells = 0;                 ///< connected pieces of surface

  /// True when the mesh encloses a solid that wall spheres can be made from.
  bool usable() const;
  /// One finding a line in words, such as "12 open edges: the surface has a hole near (1.0, 2.0, 0.0) mm".
  std::vector<std::string> in_words() const;
  std::vector<Eigen::Vector3d> places;    ///< m, first place of each kind of finding, in the order of in_words()
};

/// Examines `mesh`. Never throws for a bad mesh: badness is what it reports.
MeshFindings check_mesh(const Mesh& mesh);

}  // namespace diefill::geometry
