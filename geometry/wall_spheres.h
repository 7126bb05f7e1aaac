// Turns the surface of a solid into overlapping wall spheres whose envelope lies on the CAD surface
// (Bierwisch 2009, section 2.3: walls are sets of overlapping spheres of radius R_w on a grid of about 1.6
// R_w).
#pragma once

#include <functional>

#include "geometry/mesh.h"

namespace diefill::geometry {

/// How to cover a surface with spheres.
struct WallSphereOptions {
  double radius = 1.5e-4;  ///< m, R_w
  double spacing = 1.6;    ///< distance of neighbouring centres over R_w
  /// True for surface points (m, the mesh's frame) that powder can reach; the others carry no spheres.
  std::function<bool(const Eigen::Vector3d& surface_point, const Eigen::Vector3d& outward_normal)> reachable;
};

/// The spheres of one tool and how well their envelope follows the CAD surface (over the reachable part of
/// it).
struct WallSpheres {
  std::vector<Eigen::Vector3d> centres;  ///< m, the mesh's frame, inside the solid at depth R_w
  double radius = 0;                     ///< m
  double mean_deviation = 0;             ///< m, mean distance between envelope and CAD surface
  double largest_deviation = 0;          ///< m, largest such distance
  Eigen::Vector3d largest_deviation_place = Eigen::Vector3d::Zero();  ///< m
  /// m, diameter of the largest sphere that fits through the widest hole between neighbouring wall spheres.
  double largest_gap = 0;
  Eigen::Vector3d largest_gap_place = Eigen::Vector3d::Zero();  ///< m
};

/// Covers the reachable surface of `mesh` (closed, outward). Deterministic.
/// Throws MeshError when the solid is thinner than the spheres need.
WallSpheres make_wall_spheres(const Mesh& mesh, const WallSphereOptions& options);

}  // namespace diefill::geometry
