#include "engine/simulation/powder_energy.h"

namespace diefill::engine {

Energy energy_of(const SimulationState& state) {
  const Grains& grains = state.grains;
  Energy energy;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const GrainShape& shape = state.shape_of(k);
    energy.translation += 0.5 * shape.mass * grains.velocity[k].squaredNorm();
    if (shape.rotates) energy.rotation += 0.5 * shape.inertia.dot(grains.spin[k].cwiseAbs2());
    energy.height -= shape.mass * state.settings.gravity.dot(grains.position[k]);
  }
  LocalSpheres local;
  const ContactScene scene = contact_scene(state, local);
  for (const auto& block : state.list.blocks()) {
    local.take(block, state.spheres, state.settings.instructions);
    energy.contacts +=
        state.grain_loop->stored_energy(block, scene) + state.wall_loop->stored_energy(block, scene);
  }
  return energy;
}

}  // namespace diefill::engine
