// How powder moves: velocities now, displacements since an earlier instant, as averaged fields with arrows.
#pragma once

#include "process/results/arrow_field.h"

namespace diefill::process {

/// Places of grains and a vector for each, such as its displacement.
struct GrainVectors {
  std::vector<Eigen::Vector3d> place;   ///< m
  std::vector<Eigen::Vector3d> vector;  ///< in the unit of the field
};

/// Velocities (m/s) of all grains.
GrainVectors velocities(const results::PowderState& powder);

/// Displacements (mm) from `before` to `after` of the grains that are in the cavity at both, at their places
/// before.
GrainVectors displacements(const results::PowderState& before, const results::PowderState& after,
                           const results::CavityState& cavity);

/// Vectors averaged as the solid fraction is (Bierwisch 2009, Eq. 2.27 with v_k for rho_k) over azimuth (deg)
/// and height (mm) of a ring, mean over three radii; magnitude of the averaged vector, arrows some 3 sigma
/// apart. Throws std::invalid_argument for other cavities.
results::ArrowField unrolled_vectors(const GrainVectors& grains, const results::CavityState& cavity,
                                     double grain_diameter, double averaging_width);

/// The same in a plane, on the nodes of plane_section (measure.h); arrows show the in-plane components.
results::ArrowField plane_vectors(const GrainVectors& grains, const results::FillResult& result,
                                  const results::SectionPlane& plane, double averaging_width);

}  // namespace diefill::process
