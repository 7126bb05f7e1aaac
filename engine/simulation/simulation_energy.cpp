// The energy that a simulation's powder holds, held against its ledger.
#include <algorithm>
#include <cmath>

#include "engine/simulation/simulation.h"

namespace diefill::engine {

Energy Simulation::energy() const {
  Energy energy;
  for (std::size_t k = 0; k < grains_.size(); ++k) {
    const GrainShape& shape = shape_of(k);
    energy.translation += 0.5 * shape.mass * grains_.velocity[k].squaredNorm();
    if (shape.rotates) energy.rotation += 0.5 * shape.inertia.dot(grains_.spin[k].cwiseAbs2());
    energy.height -= shape.mass * settings_.gravity.dot(grains_.position[k]);
  }
  LocalSpheres local;
  const ContactScene scene = contact_scene(local);
  for (const auto& block : list_.blocks()) {
    local.take(block, spheres_, settings_.instructions);
    energy.contacts += grain_loop_->stored_energy(block, scene) + wall_loop_->stored_energy(block, scene);
  }
  return energy;
}

double Simulation::mass_of(std::size_t begin, std::size_t end) const {
  if (types_.monodisperse()) return static_cast<double>(end - begin) * types_.shape(0).mass;
  double mass = 0;
  for (std::size_t k = begin; k < end; ++k) mass += shape_of(k).mass;
  return mass;
}

double Simulation::energy_balance_error() const {
  const Energy now = energy();
  const double turned_over = std::abs(ledger_.viscous_work) + std::abs(ledger_.tangential_work) +
                             std::abs(ledger_.drag_work) + std::abs(ledger_.rolling_work) +
                             std::abs(ledger_.wall_work) + now.kinetic() + std::abs(now.contacts);
  return turned_over > 0 ? (now.total() - ledger_.expected()) / turned_over : 0;
}

}  // namespace diefill::engine
