// The sticky spheres of Hu 2024, chapters 5 and 6: 1000 kg/m^3, E = 10 MPa, nu = 0.3, restitution 0.1,
// friction 0.3.
#pragma once

#include <string>

#include "engine/laws/law_parameters.h"
#include "engine/simulation/simulation.h"

namespace diefill::process::laboratory {

inline constexpr double kStickyDensity = 1000;  ///< kg/m^3, of the spheres

/// Pa, E* and G* between the spheres.
double sticky_modulus();
double sticky_shear_modulus();

/// Simplified JKR with `surface_energy` (J/m^2), damping by restitution, Mindlin friction, and `rolling`; of
/// spheres and of spheres with the floor.
engine::laws::LawParameters sticky_law(double surface_energy, engine::laws::JkrLoad load,
                                       const engine::laws::AnyRolling::Parameters& rolling);

/// A sphere of `radius` (m) that rotates.
engine::GrainShape sticky_sphere(double radius);

/// The plane z = 0, solid below.
engine::WallBodySpec plane_floor();

}  // namespace diefill::process::laboratory
