// Pouring grains of several sizes: columns as wide as the largest grain needs, in which every grain takes up
// the height of its own size, so that small ones are not spread thin.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/powder/new_grain.h"
#include "engine/powder/particle_types.h"
#include "process/powder/random.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// Where columns stand over the floor of the pour box.
struct PourColumns {
  std::size_t across[2] = {1, 1};
  double distance = 0;                              ///< m, between the middles of two
  Eigen::Vector3d first = Eigen::Vector3d::Zero();  ///< m, the middle of the first, on the floor
};

/// Height in a column over its grain's size, or the height (m) that makes the powder a tenth solid where the
/// scene leaves the lattice to the program and that is more.
double column_height(const Scene& scene, const PourColumns& columns, double diameter, double solid_volume);

/// Grains of `kinds` from the floor upwards in the order of `types` (types_to_pour), one column after the
/// other. `place` makes the grain of `kind` in a cell whose middle
/// is given; where `has_room` says no, the cell stays empty and the grain takes the next one.
std::vector<engine::NewGrain> pour_sizes(
    const Scene& scene, const std::vector<engine::ParticleType>& kinds, const PourColumns& columns,
    const std::vector<std::uint16_t>& types,
    const std::function<engine::NewGrain(const Eigen::Vector3d&, const engine::GrainShape&, Random&)>& place,
    const std::function<bool(const engine::NewGrain&, const engine::GrainShape&)>& has_room);

/// m, how high those columns reach where no tool takes up room.
double height_of_columns(const Scene& scene, const std::vector<engine::ParticleType>& kinds,
                         const PourColumns& columns, const std::vector<std::uint16_t>& types);

}  // namespace diefill::process
