// Plane facets of a triangulated surface: coplanar triangles of a CAD export joined into one face.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/mesh/topology.h"

namespace diefill::geometry {

inline constexpr std::int32_t kNoFacet = -1;

/// A piece of a facet's border between two mesh corners. The facet lies to the left seen from outside. There
/// may be tens of millions, so corners are pointers. Where corners of the mesh coincide the first is meant,
/// so that edges with a common corner meet.
struct BorderEdge {
  const Eigen::Vector3d* from_corner = nullptr;  ///< of the mesh, m
  const Eigen::Vector3d* to_corner = nullptr;
  double angle = 0;               ///< rad, between the two facets' normals, 0 where unknown
  std::int32_t other = kNoFacet;  ///< facet beyond, kNoFacet where unknown
  bool convex = true;             ///< the solid's angle at the edge is below 180 degrees
  const Eigen::Vector3d& from() const { return *from_corner; }
  const Eigen::Vector3d& to() const { return *to_corner; }
};

/// Triangles in one plane, joined across edges.
struct Facet {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit length, out of the solid
  double offset = 0;                                 ///< m, of the plane from 0 along the normal
  double area = 0;                                   ///< m^2
  std::vector<std::uint32_t> triangles;
  std::vector<BorderEdge> border;
};

/// The facets of a mesh, which has to outlive them, largest seed triangle first. Triangles left out are in
/// none.
using Facets = std::vector<Facet>;

/// Groups the triangles of `mesh`, at most 2^31 of them. Corners may be off the plane by the rounding of
/// single-precision CAD files.
Facets find_facets(const Mesh& mesh, const Topology& topology);

/// How far below a convex edge's face the line at depth R under both faces starts: R tan(angle / 2), m; 0 for
/// an edge that is not convex, below which the spheres of both faces touch the edge itself.
double inset(const BorderEdge& edge, double depth);

}  // namespace diefill::geometry
