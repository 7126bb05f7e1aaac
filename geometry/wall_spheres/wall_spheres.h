// Turns the surface of a solid into overlapping wall spheres whose envelope lies on the CAD surface
// (Bierwisch 2009, section 2.3: walls are sets of overlapping spheres of radius R_w on a grid of about 1.6
// R_w).
#pragma once

#include <functional>
#include <string>

#include "geometry/mesh/mesh.h"
#include "geometry/solid/solid_query.h"

namespace diefill::geometry {

/// How to cover a surface with spheres.
struct WallSphereOptions {
  double radius = 1.5e-4;  ///< m, R_w
  double spacing =
      1.6;  ///< distance of neighbouring centres over R_w, 0.2 to 10; above sqrt(2) small spheres leak
  /// True for surface points (m, the mesh's frame) that powder can reach; the others carry no spheres, but
  /// for about one spacing beyond the edge of the reachable surface. Empty: all of the surface.
  std::function<bool(const Eigen::Vector3d& surface_point, const Eigen::Vector3d& outward_normal)> reachable;
  /// Called with the finished share, 0 to 1, by one thread at a time. Empty: not reported.
  std::function<void(double share)> on_progress;
};

/// The solid is thinner than a wall sphere at a place that powder can reach.
struct ThinSolid : MeshError {
  ThinSolid(const std::string& message, double thick) : MeshError(message), thickness(thick) {}
  double thickness;  ///< m
};

/// The spheres of one tool and how well their envelope follows the CAD surface, measured on points of the
/// reachable surface 0.4 R_w apart.
///
/// Deviation of a surface point: its distance to the nearest sphere's surface. No sphere sticks out of the
/// solid, so the envelope is never in front of the CAD surface. On a flat square grid it runs from 0 to
/// sqrt(1 + spacing^2 / 2) R_w - R_w in the middle of four spheres; at convex edges and corners of the solid
/// the spheres leave a rounding that no arrangement can avoid, and it is included.
///
/// Gap: each surface point is moved to depth R_w, where the centres lie; at distance D from the nearest
/// centre there, a sphere of diameter 2 (D - R_w) passes. The largest D is sought between the samples too, at
/// the point equally far from the three nearest centres. On a flat square grid: 2 (spacing / sqrt(2) - 1)
/// R_w.
struct WallSpheres {
  std::vector<Eigen::Vector3d> centres;  ///< m, the mesh's frame, inside the solid at depth R_w
  double radius = 0;                     ///< m
  double mean_deviation = 0;             ///< m, mean over the area
  double largest_deviation = 0;          ///< m
  Eigen::Vector3d largest_deviation_place = Eigen::Vector3d::Zero();  ///< m, on the CAD surface
  double largest_gap =
      0;  ///< m, diameter of the largest sphere that passes between the wall spheres; 0 if closed
  Eigen::Vector3d largest_gap_place = Eigen::Vector3d::Zero();  ///< m, on the CAD surface
};

/// Covers the reachable surface of `mesh` (closed, outward). Deterministic.
/// No centre is closer than R_w (1 - 1e-9) to the surface. Planes carry square grids aligned with their
/// longest edge and cylinders and other bent strips grids of rings, stretched so that the outermost rows lie
/// at the edges with no spacing above the wanted one; edges carry rows, inner edges all round them; what
/// is left open, and doubly curved surfaces, are covered by lattices that grow over them. Reachable patches
/// narrower than R_w may be missed. Throws ThinSolid when the solid is thinner than 2 R_w where it is
/// reachable, MeshError for options out of range.
WallSpheres make_wall_spheres(const Mesh& mesh, const WallSphereOptions& options);

/// The same where there is a query of that mesh already.
WallSpheres make_wall_spheres(const Mesh& mesh, const SolidQuery& solid, const WallSphereOptions& options);

}  // namespace diefill::geometry
