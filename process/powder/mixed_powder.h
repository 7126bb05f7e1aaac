// A scene's powder in the engine's terms: a particle type for each class of grain sizes, and a law for each
// pair of types and of types with tools.
//
// What the powder's parameters mean where sizes differ. All grains are made of one material, coarsened by one
// factor, that of the grain of mean mass. Moduli, coefficients of friction, restitution and work of adhesion
// belong to the material and are the same for all pairs; the laws take R_eff, masses and moments of inertia
// of each pair themselves. gamma_n and kappa_t of Bierwisch's law grow with the radius of the sphere
// (Bierwisch 2009, Eq. 3.7), and so does mu_r; of unequal spheres the smaller one counts. Against tools it is
// the powder's sphere however large the wall is (physics reference, OP-5), and to a small grain a large one
// is such a wall, so that both limits are kept: equal spheres and walls [assumed]. Springs and dampers that
// [contact] gives in N/m and N s/m are the same for all sizes.
#pragma once

#include "engine/simulation/simulation.h"
#include "process/powder/scene_laws.h"

namespace diefill::process {

/// The shape of the grain of mean mass at the wanted size, which no grain need have where sizes differ.
engine::GrainShape mean_grain(const Scene& scene);

/// Types of the scene's grains, by ascending size, and the laws between them and with the tools' materials.
std::vector<engine::ParticleType> particle_types(const Scene& scene);
engine::ContactLaws contact_laws(const Scene& scene, const SceneLaws& of_mean_grain);

/// The shape enlarged by `factor`: mass with its cube, moments of inertia with its fifth power.
engine::GrainShape enlarged(const engine::GrainShape& shape, double factor);

}  // namespace diefill::process
