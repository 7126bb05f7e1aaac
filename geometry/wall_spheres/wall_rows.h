// Rows of wall spheres along the sharp edges of a solid.
#pragma once

#include "geometry/mesh/surface_facets.h"
#include "geometry/wall_spheres/wall_layout.h"

namespace diefill::geometry {

/// Adds evenly spaced rows along all edges sharper than about 30 degrees: below convex edges on the line at
/// depth R under both faces, below other edges on the arc of radius R about the edge, one row under each face
/// and as many in between as the spacing asks for. Rows run along straight and curved edges from corner to
/// corner.
void add_edge_rows(const Facets& facets, WallLayout& layout);

}  // namespace diefill::geometry
