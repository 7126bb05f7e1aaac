// Repairs that need no guess: loose corners and edges that belong together, triangles that bound nothing,
// solids that touch. Each changes the mesh as little as possible and returns how much it changed.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

/// What weld_loose_corners() moved.
struct WeldedCorners {
  std::size_t count = 0;
  double farthest = 0;  ///< m
};

/// Moves corners of open edges onto another one within `tolerance` (m).
WeldedCorners weld_loose_corners(Mesh& mesh, double tolerance);

/// Splits triangles at open edges on which corners of other open edges lie within `tolerance` (m), as where
/// one face has a corner that its neighbour lacks. Returns how many edges were split.
std::size_t split_edges_at_corners(Mesh& mesh, double tolerance);

/// Removes triangles without area. Returns how many.
std::size_t drop_triangles_without_area(Mesh& mesh);

/// Removes all but the first of triangles with the same corners. Returns how many.
std::size_t drop_copies_of_triangles(Mesh& mesh);

/// Removes triangles that occur facing both ways where this opens no edge and leaves fewer edges of more than
/// two triangles: the faces that solids share. Returns the number of pairs.
std::size_t drop_opposite_pairs(Mesh& mesh);

/// The surface separated where solids touch along edges: the two triangles with solid between them stay
/// together. Empty if the sides of an edge do not alternate between solid and free.
std::vector<Mesh> shells_of_solids(const Mesh& mesh);

}  // namespace diefill::geometry
