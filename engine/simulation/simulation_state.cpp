#include "engine/simulation/simulation_state.h"

#include "engine/simulation/simulation_parts.h"

namespace diefill::engine {

SimulationState::SimulationState(const SimulationSettings& wanted, std::vector<WallBodySpec> walls)
    : types(moving_types(wanted.types, wanted.contact.scaling)),
      settings(checked(wanted, types)),
      box(settings.period),
      grain_loop(grain_loop_for(settings, types)),
      wall_loop(wall_loop_for(settings, types, walls)),
      skin(skin_for(settings, types, grain_loop->range())),
      integrator(integrator_for(settings, types, *grain_loop, *wall_loop)),
      list(neighbour_settings(types, *grain_loop, *wall_loop), first_sphere_of_bodies(walls)),
      pool(settings.threads),
      workspaces(settings.threads) {
  for (auto& wall : walls) {
    const double reach = types.largest_sphere() + wall.sphere_radius + 2 * skin.largest_allowance() +
                         (wall.mirror ? grain_loop->range() : 0);
    bodies.emplace_back(std::move(wall), reach);
    body_motion.push_back(bodies.back().motion_at(0));
  }
  wall_loads.resize(bodies.size());
  clearance.resize(bodies.size());
  spheres.spheres_per_grain = types.spheres();
  spheres.box = box;
  number_spheres_of_types(types, spheres);
  reference.skin = skin.first();
}

double SimulationState::mass_of(std::size_t begin, std::size_t end) const {
  if (types.monodisperse()) return static_cast<double>(end - begin) * types.shape(0).mass;
  double mass = 0;
  for (std::size_t k = begin; k < end; ++k) mass += shape_of(k).mass;
  return mass;
}

ContactScene contact_scene(const SimulationState& state, const LocalSpheres& local) {
  return {local,
          state.bodies,
          state.body_motion,
          state.types.smallest_sphere(),
          state.settings.time_step,
          state.settings.instructions};
}

}  // namespace diefill::engine
