// Where a point lies in a cavity: inside or not, and its azimuth, radius and height in a ring.
#pragma once

#include "process/results/fill_result.h"

namespace diefill::process {

/// True where `point` (m, laboratory frame) lies in the cavity's box, in rings also between its radii. An
/// empty box holds nothing.
bool lies_in_cavity(const results::CavityState& cavity, const Eigen::Vector3d& point);

/// True where it lies in one of them.
bool lies_in_any_cavity(const std::vector<results::CavityState>& cavities, const Eigen::Vector3d& point);

/// For every grain 1 if its centre lies in the cavity, otherwise 0: GrainSolidFraction::in_cavity.
std::vector<std::uint8_t> grains_in_cavity(const results::CavityState& cavity,
                                           const results::PowderState& powder);

/// Cylindrical coordinates in a ring.
struct RingPosition {
  double azimuth = 0;  ///< deg in [0, 360), counter-clockwise seen from above, from CavityState::azimuth_zero
  double radius = 0;   ///< m from the axis
  double height = 0;   ///< m above the cavity floor
};
RingPosition ring_position(const results::CavityState& cavity, const Eigen::Vector3d& point);

/// The point (m, laboratory frame) at these coordinates.
Eigen::Vector3d ring_point(const results::CavityState& cavity, const RingPosition& position);

/// m, extent of the cavity's box along the shoe's travel: of its corners along CavityState::azimuth_zero.
double travel_length(const results::CavityState& cavity);
/// Place along the travel: 0 at the end of the cavity's box where the shoe first arrives, 1 at the other.
double along_travel(const results::CavityState& cavity, const Eigen::Vector3d& point);

}  // namespace diefill::process
