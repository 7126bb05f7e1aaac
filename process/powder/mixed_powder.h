// A scene's powders in the engine's terms: a particle type for each class of grain sizes of each powder, and
// a law for each pair of types and of types with tools.
//
// What the powder's parameters mean where sizes differ. All grains are made of one material, coarsened by one
// factor, that of the grain of mean mass. Moduli, coefficients of friction, restitution and work of adhesion
// belong to the material and are the same for all pairs; the laws take R_eff, masses and moments of inertia
// of each pair themselves. gamma_n and kappa_t of Bierwisch's law grow with the radius of the sphere
// (Bierwisch 2009, Eq. 3.7), and so does mu_r; of unequal spheres the smaller one counts. Against tools it is
// the powder's sphere however large the wall is (engine/OPEN_POINTS.md, OP-5), and to a small grain a large
// one is such a wall, so that both limits are kept: equal spheres and walls. Springs and dampers that
// [contact] gives in N/m and N s/m are the same for all sizes.
#pragma once

#include <vector>

#include "engine/powder/particle_types.h"
#include "process/powder/scene_laws.h"

namespace diefill::process {

/// The shape of the grain of mean mass at the wanted size, which no grain need have where sizes differ; of
/// [powder] where the scene has several.
engine::GrainShape mean_grain(const PowderSpec& powder, CoarseGraining rule);
inline engine::GrainShape mean_grain(const Scene& scene) {
  return mean_grain(scene.powder, scene.coarse_graining);
}

/// Types of the scene's grains, powder after powder and by ascending size.
std::vector<engine::ParticleType> particle_types(const Scene& scene);
/// The laws between them and with the tools' materials, for steps of `time_step` (s).
engine::ContactLaws contact_laws(const Scene& scene, double time_step);

/// The shape enlarged by `factor`: mass with its cube, moments of inertia with its fifth power.
engine::GrainShape enlarged(const engine::GrainShape& shape, double factor);

}  // namespace diefill::process
