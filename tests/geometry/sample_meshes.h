// Meshes of known shape for tests. Lengths in m; closed and outward unless the name says otherwise.
#pragma once

#include <Eigen/Geometry>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry::sample {

/// Box from `lower` to `upper`: 12 triangles.
Mesh box(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper);

/// A simple polygon in the x-y plane (counter-clockwise) raised from z = 0 to `height`. The caps are fans
/// about `hub`, a point that sees all corners.
Mesh prism(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& hub, double height);

/// Solid cylinder about z from z = 0 to `height`, inscribed: its corners lie on the circle.
Mesh cylinder(double radius, double height, int facets);

/// Tube about z from z = 0 to `height`: a cavity wall of radius `inner` in a block of radius `outer`.
Mesh tube(double inner, double outer, double height, int facets);

/// Geodesic sphere: an icosahedron split `levels` times, corners on the sphere.
Mesh sphere(double radius, int levels);

/// Two meshes as one.
Mesh joined(const Mesh& one, const Mesh& other);

/// All triangles turned over.
Mesh inside_out(const Mesh& mesh);

}  // namespace diefill::geometry::sample
