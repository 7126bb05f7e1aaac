// Whether a mesh encloses a solid, as findings an engineer understands: closed, oriented, free of
// self-intersections, degenerate and duplicate triangles (CGAL).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/mesh/topology.h"

namespace diefill::geometry {

/// One place where a mesh is wrong.
struct MeshMark {
  std::string kind;       ///< such as "open edge"
  Eigen::Vector3d place;  ///< m
};

/// Findings about one mesh. Counts are of triangles unless said otherwise.
struct MeshFindings {
  std::size_t triangles = 0;   ///< all of them
  std::size_t not_finite = 0;  ///< with a corner that is no number or that does not exist; then nothing else
                               ///< is examined
  std::size_t open_edges = 0;  ///< edges with a triangle on one side only
  std::size_t non_manifold_edges = 0;    ///< edges shared by more than two triangles
  std::size_t degenerate_triangles = 0;  ///< no area
  std::size_t duplicate_triangles = 0;   ///< the same three corners again; the copies count nowhere else
  std::size_t self_intersections = 0;    ///< pairs of triangles that cross
  std::size_t badly_oriented_edges = 0;  ///< edges whose two triangles disagree about outside
  bool consistently_oriented = false;    ///< neighbours agree about outside
  bool outward = false;           ///< normals point out of the solid, for every shell; only known when closed
  std::size_t inward_shells = 0;  ///< shells whose normals point into the solid
  std::size_t shells = 0;         ///< connected pieces of surface
  double volume = 0;              ///< m^3, enclosed; negative when inside out

  /// True when the mesh encloses a solid that wall spheres can be made from: closed, consistently oriented,
  /// outward and free of crossings. Duplicate and degenerate triangles alone do no harm: they are left out
  /// where surfaces are measured, and reported.
  bool usable() const;
  /// One finding per line, such as "12 open edges: the surface has a hole near (1.0, 2.0, 0.0) mm".
  std::vector<std::string> description() const;
  std::vector<Eigen::Vector3d>
      places;                   ///< m, first place of each kind of finding, in the order of description()
  std::vector<MeshMark> marks;  ///< up to 100 places of each kind, for pictures
};

/// Examines `mesh`. Never throws for a bad mesh: the findings say what is wrong.
MeshFindings check_mesh(const Mesh& mesh);

/// The findings, and the adjacency found for them, for a SolidQuery about the same mesh; empty where a corner
/// is not finite. Never throws for a bad mesh, like check_mesh().
struct ExaminedMesh {
  MeshFindings findings;
  std::optional<Topology> topology;
};
ExaminedMesh examine_mesh(const Mesh& mesh);

}  // namespace diefill::geometry
