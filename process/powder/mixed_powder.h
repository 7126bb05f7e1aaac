// A powder of several grain sizes in the engine's terms: a kind of grains for each class of sizes, and a law
// for each pair of kinds.
//
// What the powder's parameters mean where sizes differ. All grains are made of one material, coarsened by one
// factor, that of the grain of mean mass. Moduli, coefficients of friction, restitution and work of adhesion
// belong to the material and are the same for all pairs; the laws take R_eff, masses and moments of inertia
// of each pair themselves. gamma_n and kappa_t of Bierwisch's law grow with the radius of the sphere
// (Bierwisch 2009, Eq. 3.7); of unequal spheres the smaller one counts. Against tools it is the powder's
// sphere however large the wall is (physics reference, OP-5), and to a small grain a large one is such a
// wall, so that both limits are kept: equal spheres and walls [assumed]. Springs and dampers that [contact]
// gives in N/m and N s/m are the same for all sizes.
#pragma once

#include "engine/simulation/simulation.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// The law that the powder's own parameters make (Bierwisch 2009, section 2.2), in parts that any pair can
/// take, among grains and with tools.
engine::GeneralContact own_law(const engine::SimulationSettings& settings);

/// Laws of a mix are between kinds of grains, and between each and each material of tools (tool_surface.h).
/// The kinds of a scene with `powder.sizes`, ascending. `mean`: the grain of mean mass, whose size
/// `contact` belongs to.
engine::GrainMix grain_mix(const Scene& scene, const engine::GrainShape& mean,
                           const engine::GeneralContact& contact);

/// The shape enlarged by `factor`: mass with its cube, moments of inertia with its fifth power.
engine::GrainShape enlarged(const engine::GrainShape& shape, double factor);

}  // namespace diefill::process
