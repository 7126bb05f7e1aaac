// The forces of single contacts, for those who ask.
#include "engine/simulation/simulation.h"

namespace diefill::engine {

namespace {

/// The velocities in `spheres`, which are those predicted when contacts were last computed, become what they
/// are now; single spheres have them from their grains.
void bring_up_to_date(SphereField& spheres, const Simulation& simulation) {
  if (spheres.spheres_per_grain == 1) return;
  for (std::size_t k = 0; k < spheres.grains; ++k)
    spheres.set_motion(k, {plain(simulation.grains().velocity[k]), plain(simulation.angular_velocity(k))});
}

}  // namespace

void Simulation::visit_contact_forces(const std::function<void(const ContactForce&)>& visit) const {
  LocalSpheres local;
  SphereField spheres = spheres_;
  bring_up_to_date(spheres, *this);
  for (const Block& block : list_.blocks()) {
    local.take(block, spheres, settings_.instructions);
    const ContactScene scene = contact_scene(local);
    // Where the grain of a local sphere stands as the pair sees it: shifted where the pair meets an image.
    const auto centre_of = [&](LocalSphere sphere) -> Eigen::Vector3d {
      const std::uint32_t number = block.sphere(sphere);
      const std::size_t owner = spheres_.owner(number);
      return grains_.position[owner] + eigen(spheres_.shift(number / spheres_.spheres_per_grain));
    };
    grain_loop_->visit_forces(block, scene, [&](const PairForce& pair) {
      const Eigen::Vector3d contact = eigen(pair.contact);
      visit({spheres_.owner(block.sphere(pair.own)), spheres_.owner(block.sphere(pair.other)),
             eigen(pair.force), contact - centre_of(pair.own), contact - centre_of(pair.other)});
    });
    wall_loop_->visit_forces(block, scene, [&](const PairForce& pair) {
      visit({spheres_.owner(block.sphere(pair.own)), kNoGrain, eigen(pair.force),
             eigen(pair.contact) - centre_of(pair.own), Eigen::Vector3d::Zero()});
    });
  }
}

}  // namespace diefill::engine
