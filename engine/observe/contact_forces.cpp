#include "engine/observe/contact_forces.h"

#include "engine/simulation/simulation.h"

namespace diefill::engine {

namespace {

/// Spheres with the velocities that grains have now; those of the simulation are the ones predicted when
/// contacts were last computed. Single spheres have them from their grains.
SphereField up_to_date(const Simulation& simulation) {
  SphereField spheres = simulation.spheres();
  if (spheres.spheres_per_grain == 1) return spheres;
  for (std::size_t k = 0; k < spheres.grains; ++k)
    spheres.set_motion(k, {plain(simulation.grains().velocity[k]), plain(simulation.angular_velocity(k))});
  return spheres;
}

}  // namespace

void visit_contact_forces(const Simulation& simulation,
                          const std::function<void(const ContactForce&)>& visit) {
  const SimulationState& state = simulation.state();
  const SphereField spheres = up_to_date(simulation);
  LocalSpheres local;
  const ContactScene scene = contact_scene(state, local);
  for (const Block& block : state.list.blocks()) {
    local.take(block, spheres, state.settings.instructions);
    // Where the grain of a local sphere stands as the pair sees it: shifted where the pair meets an image.
    const auto centre_of = [&](LocalSphere sphere) -> Eigen::Vector3d {
      const std::uint32_t number = block.sphere(sphere);
      return state.grains.position[spheres.owner(number)] +
             eigen(spheres.shift(number / spheres.spheres_per_grain));
    };
    state.grain_loop->visit_forces(block, scene, [&](const PairForce& pair) {
      const Eigen::Vector3d contact = eigen(pair.contact);
      visit({spheres.owner(block.sphere(pair.own)), spheres.owner(block.sphere(pair.other)),
             eigen(pair.force), contact - centre_of(pair.own), contact - centre_of(pair.other)});
    });
    state.wall_loop->visit_forces(block, scene, [&](const PairForce& pair) {
      visit({spheres.owner(block.sphere(pair.own)), kNoGrain, eigen(pair.force),
             eigen(pair.contact) - centre_of(pair.own), Eigen::Vector3d::Zero()});
    });
  }
}

}  // namespace diefill::engine
