// Synthetic powders and cavities whose measures are known.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process {

inline constexpr double kDiameter = 5e-4;  // m, grains are single spheres of this diameter

/// Spheres (model A) at these places.
inline results::PowderState powder_of(const std::vector<Eigen::Vector3d>& places,
                                      double diameter = kDiameter) {
  results::PowderState powder;
  powder.grain_diameter = diameter;
  powder.sphere_radius = diameter / 2;
  powder.grain_mass = 7.63e-8;
  powder.grain_solid_volume = std::numbers::pi / 6 * diameter * diameter * diameter;
  powder.sphere_offsets = {Eigen::Vector3d::Zero()};
  powder.position = places;
  for (std::size_t k = 0; k < places.size(); ++k) {
    powder.id.push_back(k);
    powder.orientation.emplace_back(1, 0, 0, 0);
    powder.velocity.push_back(Eigen::Vector3d::Zero());
    powder.angular_velocity.push_back(Eigen::Vector3d::Zero());
  }
  return powder;
}

/// n x n x n places on a cubic lattice of this constant (m), about the origin.
inline std::vector<Eigen::Vector3d> block(int n, double constant) {
  std::vector<Eigen::Vector3d> places;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        places.push_back(constant * (Eigen::Vector3d(i, j, k) - Eigen::Vector3d::Constant(0.5 * (n - 1))));
  return places;
}

/// Closed cells in the cavity with the solid fraction that `value` gives at the grain's place.
inline results::GrainSolidFraction fraction_of(const results::PowderState& powder,
                                               const std::function<double(const Eigen::Vector3d&)>& value) {
  results::GrainSolidFraction fraction;
  for (const auto& place : powder.position) {
    fraction.solid_fraction.push_back(value(place));
    fraction.cell_volume.push_back(powder.grain_solid_volume / value(place));
    fraction.open.push_back(0);
    fraction.in_cavity.push_back(1);
  }
  return fraction;
}

/// A ring of 8 and 11 mm radius and 6 mm depth, off the origin, its azimuth 0 towards -x.
inline results::CavityState sample_ring() {
  results::CavityState ring;
  ring.is_ring = true;
  ring.axis_origin = {2e-3, -1e-3, 3e-3};
  ring.inner_radius = 8e-3;
  ring.outer_radius = 11e-3;
  ring.upper_corner = ring.axis_origin + Eigen::Vector3d(11e-3, 11e-3, 0);
  ring.lower_corner = ring.axis_origin - Eigen::Vector3d(11e-3, 11e-3, 6e-3);
  ring.azimuth_zero = {-1, 0, 0};
  return ring;
}

/// Azimuth in degrees worked out by turning the point instead of taking an arc tangent of axes.
inline double azimuth_of(const results::CavityState& ring, const Eigen::Vector3d& place) {
  const Eigen::Vector3d from_axis = place - ring.axis_origin;
  // Azimuth 0 towards -x: turn by half a circle, so that -x becomes +x.
  const double degrees =
      std::arg(-std::complex<double>(from_axis.x(), from_axis.y())) * 180 / std::numbers::pi;
  return degrees < 0 ? degrees + 360 : degrees;
}

/// A simple cubic lattice through the ring, up to `level` (m above the floor) as a function of azimuth (deg).
inline std::vector<Eigen::Vector3d> lattice_in_ring(const results::CavityState& ring, double constant,
                                                    const std::function<double(double)>& level) {
  std::vector<Eigen::Vector3d> places;
  const int half = static_cast<int>(ring.outer_radius / constant) + 1;
  for (int k = 0; (k + 0.5) * constant < 1.5 * (ring.upper_corner - ring.lower_corner).z(); ++k)
    for (int j = -half; j <= half; ++j)
      for (int i = -half; i <= half; ++i) {
        const Eigen::Vector3d place(ring.axis_origin.x() + i * constant, ring.axis_origin.y() + j * constant,
                                    ring.lower_corner.z() + (k + 0.5) * constant);
        const double radius = constant * std::hypot(i, j);
        if (radius < ring.inner_radius || radius > ring.outer_radius) continue;
        if ((k + 1) * constant <= level(azimuth_of(ring, place)) + 1e-12) places.push_back(place);
      }
  return places;
}

}  // namespace diefill::process
