// What one grain is made of: basic spheres on a rigid frame, their mass and moments of inertia.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace diefill::engine {

/// A rigid grain in its body frame, which is the principal one and has its origin in the centre of mass. SI
/// units.
struct GrainShape {
  double sphere_radius = 0;                           ///< m, R; of unequal spheres the smallest
  std::vector<Eigen::Vector3d> sphere_offsets;        ///< m, sphere centres in the body frame
  std::vector<double> sphere_radii;                   ///< m, of each sphere; empty: all are sphere_radius
  double mass = 0;                                    ///< kg
  Eigen::Vector3d inertia = Eigen::Vector3d::Zero();  ///< kg m^2, principal moments
  double solid_volume = 0;                            ///< m^3, of the union of the spheres
  bool rotates = true;                                ///< model A ignores torques

  std::size_t spheres() const { return sphere_offsets.size(); }
  /// m, of sphere `number`.
  double radius_of(std::size_t number) const {
    return sphere_radii.empty() ? sphere_radius : sphere_radii[number];
  }
  /// m, radius of the smallest sphere about the centre of mass that holds the grain.
  double bounding_radius() const;
};

/// Model A: a sphere that does not rotate (Bierwisch 2009, section 2.2). d = 2R.
GrainShape model_a(double sphere_radius, double mass);
/// Model B: a rotating sphere. d = 2R.
GrainShape model_b(double sphere_radius, double mass);
/// Model C: six overlapping spheres at the corners +-R of an octahedron. d = 4R.
GrainShape model_c(double sphere_radius, double mass);
/// Model D: a central sphere and six that touch it at +-2R. d = 6R.
GrainShape model_d(double sphere_radius, double mass);

/// Any rigid grain of equal spheres, each of the same mass, with the spheres' self inertia 2/5 m R^2 (OP-6).
/// Offsets are moved to the centre of mass and turned into the principal frame. `solid_volume` is that of the
/// union of spheres. Throws std::invalid_argument for no spheres, or a radius, mass or volume that is not
/// positive.
GrainShape rigid_grain(double sphere_radius, std::vector<Eigen::Vector3d> offsets, double mass,
                       double solid_volume);

}  // namespace diefill::engine
