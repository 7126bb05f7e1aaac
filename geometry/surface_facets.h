// Plane facets of a triangulated surface: what a CAD program exported as several triangles is one face again.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/topology.h"

namespace diefill::geometry {

/// A piece of a facet's border between two mesh corners. The facet lies to the left seen from outside.
struct BorderEdge {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< m
  Eigen::Vector3d to = Eigen::Vector3d::Zero();    ///< m
  std::int64_t from_vertex, to_vertex;
  std::int64_t other;  ///< facet beyond, Topology::kNone where unknown
  double angle = 0;    ///< rad, between the two facets' normals, 0 where unknown
  bool convex = true;  ///< the solid's angle at the edge is below 180 degrees
};

/// Triangles in one plane, joined across edges.
struct Facet {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit length, out of the solid
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< m, in the plane
  double area = 0;                                   ///< m^2
  std::vector<std::size_t> triangles;
  std::vector<BorderEdge> border;
};

/// The facets of a mesh, and the facet of each triangle (Topology::kNone for triangles left out).
struct Facets {
  std::vector<Facet> list;  ///< largest seed triangle first
  std::vector<std::int64_t> of_triangle;
};

/// Groups the triangles of `mesh`. Corners may be off the plane by the rounding of single-precision CAD
/// files.
Facets find_facets(const Mesh& mesh, const Topology& topology);

/// How far below a convex edge's face the line at depth R under both faces starts: R tan(angle / 2), m; 0 for
/// an edge that is not convex, below which the spheres of both faces touch the edge itself.
double inset(const BorderEdge& edge, double depth);

}  // namespace diefill::geometry
