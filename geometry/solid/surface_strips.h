// Strips: runs of plane facets bent about parallel lines, which unroll without distortion (cylinders,
// fillets, planes).
#pragma once

#include <vector>

#include "geometry/mesh/surface_facets.h"

namespace diefill::geometry {

/// A stretch of the line that a strip's surface at depth R follows across the strip.
struct StripPiece {
  Eigen::Vector3d start =
      Eigen::Vector3d::Zero();  ///< m, centre place at the start of the piece, at v = 0 of the strip
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();   ///< m, arcs only: the edge the arc is about, at v = 0
  Eigen::Vector3d along = Eigen::Vector3d::Zero();   ///< unit vector along the piece at its start
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit outward normal at the start of the piece
  double begin = 0;                                  ///< m, u at the start
  double length = 0;                                 ///< m
  bool is_arc = false;                               ///< about an edge that is not convex, radius R
};

/// A place on the surface at depth R and the point of the CAD surface above it.
struct StripPoint {
  Eigen::Vector3d centre, foot, normal;
};

/// The surface at depth R below a run of facets, unrolled: u across the bends, v along them (both in m).
struct Strip {
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();  ///< unit vector, direction of v
  std::vector<StripPiece> pieces;
  double length = 0;         ///< extent of u
  double low = 0, high = 0;  ///< range of v, shortened to depth R below faces at its ends
  bool closed = false;       ///< u goes round
  double area = 0;           ///< m^2, of the facets
  StripPoint at(double u, double v, double depth) const;
};

/// The strips of a surface that a regular grid of spacing `spacing` (m) at depth `depth` (m) fits on, largest
/// first: bent strips of narrow facets, and single facets. Facets of doubly curved surfaces that are too
/// small for a grid of their own are in no strip.
struct Strips {
  std::vector<Strip> bent;
  std::vector<Strip> plane;
};
Strips find_strips(const Facets& facets, double depth, double spacing);

}  // namespace diefill::geometry
