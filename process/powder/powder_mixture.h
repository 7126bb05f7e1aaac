// Several powders of a scene together: how many grains of which type stand for their shares of the mass, and
// in which order they are poured.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/powder/particle_types.h"
#include "engine/powder/size_classes.h"
#include "process/machine/actions/powder_inflow.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// The scene as if it had powder `number` alone, with that powder's walls and contact.
Scene scene_of_powder(const Scene& scene, std::size_t number);

/// Particle types of powder `number`: [first, last) of particle_types().
struct TypeRange {
  std::size_t first = 0, last = 0;
};
TypeRange types_of_powder(const Scene& scene, std::size_t number);

/// Shares by number of all types of the mixture, or of powder `number` alone (the others get 0): from shares
/// of the mass and the grains' masses.
std::vector<engine::CutClass> number_shares(const Scene& scene);
std::vector<engine::CutClass> number_shares(const Scene& scene, std::size_t number);

/// Of a grain of the mixture, or of powder `number`, on average over their numbers.
struct MeanGrain {
  double mass = 0;          ///< kg
  double solid_volume = 0;  ///< m^3
  double spheres = 0;
};
MeanGrain mean_of_mixture(const Scene& scene);
MeanGrain mean_of_powder(const Scene& scene, std::size_t number);
/// Of the grains that the step lets in.
MeanGrain mean_of_inflow(const Scene& scene, const PowderInflow& inflow);
std::vector<engine::CutClass> number_shares(const Scene& scene, const PowderInflow& inflow);

/// Of the grains that are poured, layers or mixture.
MeanGrain mean_of_poured(const Scene& scene);

/// How many grains the fill height needs at the expected solid fraction of each layer or of the mixture.
std::size_t grains_to_pour(const Scene& scene);

/// The type of each of `count` grains from the floor up: layer by layer, each in an order drawn from the
/// scene's seed. `count`: grains_to_pour().
std::vector<std::uint16_t> types_to_pour(const Scene& scene, std::size_t count);

}  // namespace diefill::process
