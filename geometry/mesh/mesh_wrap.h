// Wraps a new closed surface around an arbitrary one (CGAL's alpha wrap).
#pragma once

#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

/// A closed surface around `mesh` that follows features down to the size `detail` (m); narrower openings are
/// closed over. It stands off by a thirtieth of `detail`. Deterministic.
Mesh wrapped(const Mesh& mesh, double detail);

/// m: largest distance from a corner or middle of a triangle of either surface to the other surface.
double largest_distance(const Mesh& one, const Mesh& other);

}  // namespace diefill::geometry
