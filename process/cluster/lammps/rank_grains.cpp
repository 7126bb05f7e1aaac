#include "process/cluster/lammps/rank_grains.h"

#include "engine/simulation/simulation_parts.h"

namespace diefill::process::cluster {

RankGrains::RankGrains(const PowderModel& powder_model)
    : model(powder_model), body_motion(powder_model.bodies.size()) {
  motion.spheres_per_grain = model.spheres();
  engine::number_spheres_of_types(model.types, motion);
}

void RankGrains::place_spheres() {
  const std::size_t per_grain = model.spheres();
  sphere.resize(all * per_grain);
  if (!model.types.clumps()) {
    for (std::size_t grain = 0; grain < all; ++grain) sphere[grain] = centre(grain);
    return;
  }
  for (std::size_t grain = 0; grain < all; ++grain) {
    const engine::Rotation rotation = engine::rotation_of(orientation[grain]);
    const auto& offsets = motion.offsets[type_of(grain)];
    const engine::Vector3 middle = centre(grain);
    for (std::size_t s = 0; s < per_grain; ++s)
      sphere[grain * per_grain + s] = middle + rotation * offsets[s];
  }
}

}  // namespace diefill::process::cluster
