// What can change while a simulation runs, besides the motion of its bodies: gravity, contact laws, and
// velocities given to the grains.
#include <stdexcept>

#include "engine/search/spatial_order.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/simulation_parts.h"

namespace diefill::engine {

namespace {

/// Whether two laws keep the same numbers of a pair, so that a contact goes on where its law is exchanged.
bool same_history(const PairLoop& one, const PairLoop& other) {
  return one.history_signs() == other.history_signs();
}

}  // namespace

template <class Change>
void Simulation::change_energy(const Change& change) {
  const double before = energy().total(), added_before = ledger_.added_energy;
  change();
  ledger_.added_energy = added_before + (energy().total() - before);
}

void Simulation::wake_everybody() {
  if (sleeping_) sleeping_->wake_all(list_);
}

void Simulation::make_integrator() {
  integrator_ = GrainIntegrator(types_, settings_.gravity, settings_.air_viscosity,
                                grain_loop_->rolls() || wall_loop_->rolls(), settings_.time_step,
                                settings_.instructions);
}

void Simulation::set_gravity(const Eigen::Vector3d& gravity) {
  if (gravity == settings_.gravity) return;
  if (!gravity.allFinite()) throw std::invalid_argument("gravity must be finite");
  change_energy([&] {
    for (std::size_t k = 0; k < grains_.size(); ++k)
      grains_.force[k] += shape_of(k).mass * (gravity - settings_.gravity);
    settings_.gravity = gravity;
    make_integrator();
    if (sleeping_) sleeping_->set_gravity(*settings_.sleep, gravity);
    wake_everybody();
    sort_and_search();
  });
}

void Simulation::set_contact(const ContactLaws& contact) {
  if (contact.scaling.torque_factor() != settings_.contact.scaling.torque_factor())
    throw std::invalid_argument("the scaling of forces sets moments of inertia and cannot change in a run");
  auto grain_loop = make_grain_loop(types_, contact, settings_.lever_arm);
  auto wall_loop = make_wall_loop(types_, contact, settings_.lever_arm, surfaces_of(bodies_));
  skin_for(settings_, types_, grain_loop->range());  // refuses periods that the new law reaches across
  change_energy([&] {
    check_places();
    wrap_grains();
    wake_everybody();
    auto order = order_in_space();
    ContactHistories kept = remember_contacts(order);
    if (!same_history(*grain_loop, *grain_loop_)) kept.grains = {};
    if (!same_history(*wall_loop, *wall_loop_)) kept.walls = {};
    grain_loop_ = std::move(grain_loop);
    wall_loop_ = std::move(wall_loop);
    settings_.contact = contact;
    make_integrator();
    list_ = NeighbourList(neighbour_settings(types_, *grain_loop_, *wall_loop_), list_.body_first());
    search_again(order, kept);
  });
}

void Simulation::add_velocities(const std::function<Eigen::Vector3d(std::uint64_t)>& added) {
  change_energy([&] {
    for (std::size_t k = 0; k < grains_.size(); ++k) grains_.velocity[k] += added(grains_.id[k]);
    wake_everybody();
    sort_and_search();
  });
}

}  // namespace diefill::engine
