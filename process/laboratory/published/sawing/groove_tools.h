// Wire, ingot and lid of a groove as particles, and the space between them. Reduced units, places as in
// groove.h.
#pragma once

#include <vector>

#include "process/laboratory/published/sawing/groove.h"

namespace diefill::process::laboratory::sawing {

/// Density of the wire over that of the fluid: 7.8 over 1.2 g/cm^3.
inline constexpr double kSteel = 6.5;

/// A particle of the ingot: where along the surface it is, the direction into the ingot, and the area of the
/// surface that it stands for, 0 of those of deeper layers.
struct SurfacePlace {
  double along;
  Eigen::Vector3d into;
  double area;
};

/// The wire as a tool, which moves up and down where there is a pressure on it.
engine::RigidSetSpec wire_of(const GrooveCase& one);
/// The ingot, and its particles' places on the surface.
engine::RigidSetSpec ingot_of(const GrooveCase& one, std::vector<SurfacePlace>& surface);
engine::RigidSetSpec lid_of(const GrooveCase& one);

/// What the slurry fills.
SlurrySpace space_of(const GrooveCase& one);

}  // namespace diefill::process::laboratory::sawing
