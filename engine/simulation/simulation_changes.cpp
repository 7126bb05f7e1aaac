// What can change while a simulation runs: grains that come and go, the motion of bodies, gravity, contact
// laws, and velocities given to the grains.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "engine/powder/rigid_motion.h"
#include "engine/simulation/contact_search.h"
#include "engine/simulation/powder_energy.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/simulation_parts.h"

namespace diefill::engine {

namespace {

/// Whether histories have the same length in both loops, so that contacts can go on where laws are exchanged.
bool same_width(const PairLoop& one, const PairLoop& other) {
  return one.history_signs() == other.history_signs();
}

/// Sets to 0 the numbers of histories of `loop` that mean something else by the laws of `next`.
void clear_changed_history(std::vector<Block>& blocks, const PairLoop& loop, const PairLoop& next) {
  const auto layouts = next.history_layouts();
  if (!same_width(loop, next) || loop.history_layouts() == layouts) return;
  for (Block& block : blocks) loop.clear_changed_history(block, layouts);
}

void renew_integrator(SimulationState& state) {
  state.integrator = integrator_for(state.settings, state.types, *state.grain_loop, *state.wall_loop);
}

/// Writes `grain` to place g of the grains, which has been made.
void put_grain(SimulationState& state, std::size_t g, const NewGrain& grain) {
  Grains& grains = state.grains;
  const ParticleTypes& types = state.types;
  grains.id[g] = state.next_id++;
  if (!types.monodisperse()) grains.kind[g] = grain.kind;
  grains.position[g] = state.box.wrapped(grain.position);
  grains.velocity[g] = grain.velocity;
  if (types.clumps()) grains.orientation[g] = grain.orientation.normalized();
  grains.spin[g].setZero();
  if (types.turns(grain.kind) || !types.rotates())
    grains.spin[g] = rotation_matrix(grains.orientation_of(g)).transpose() * grain.angular_velocity;
  grains.force[g] = state.shape_of(g).mass * state.settings.gravity;
  grains.torque[g].setZero();
}

}  // namespace

/// What `change` adds to the energy of the powder is booked as added.
template <class Change>
void Simulation::change_energy(const Change& change) {
  // Contacts are between spheres where they are now, so that their energy must be known before grains are
  // put back into the periodic box, whose own booking is in the difference.
  Ledger& ledger = state_.ledger;
  const double before = energy_of(state_).total(), added_before = ledger.added_energy;
  change();
  ledger.added_energy = added_before + (energy_of(state_).total() - before);
}

void Simulation::add_grains(const std::vector<NewGrain>& added) {
  SimulationState& now = state_;
  for (const auto& grain : added)
    if (grain.kind >= now.types.size())
      throw std::invalid_argument("a grain of particle type " + std::to_string(grain.kind) +
                                  ", but there are " + std::to_string(now.types.size()) +
                                  " types, counted from 0");
  check_sphere_count((now.grains.size() + added.size()) * now.types.spheres());
  change_energy([&] {
    wrap_grains(now);
    const std::size_t old_count = now.grains.size();
    now.grains.resize(old_count + added.size(), now.types.clumps(), !now.types.monodisperse());
    for (std::size_t k = 0; k < added.size(); ++k) put_grain(now, old_count + k, added[k]);
    sort_and_search(now, *policy_);
  });
}

std::size_t Simulation::remove_grains(const std::function<bool(const Eigen::Vector3d&)>& leaves) {
  std::vector<std::uint32_t> staying;
  for (std::uint32_t k = 0; k < state_.grains.size(); ++k)
    if (!leaves(state_.box.wrapped(state_.grains.position[k]))) staying.push_back(k);
  return keep_grains(staying);
}

std::size_t Simulation::remove_grains(const std::vector<std::uint64_t>& ids) {
  std::vector<std::uint32_t> staying;
  for (std::uint32_t k = 0; k < state_.grains.size(); ++k)
    if (std::find(ids.begin(), ids.end(), state_.grains.id[k]) == ids.end()) staying.push_back(k);
  return keep_grains(staying);
}

/// Takes out all other grains; returns how many.
std::size_t Simulation::keep_grains(const std::vector<std::uint32_t>& staying) {
  const std::size_t gone = state_.grains.size() - staying.size();
  if (gone == 0) return 0;
  change_energy([&] {
    wrap_grains(state_);
    search_in_order(state_, *policy_, staying);
  });
  return gone;
}

void Simulation::set_motion(std::size_t body, std::function<BodyMotion(double)> motion) {
  state_.bodies.at(body).set_motion(std::move(motion));
  state_.body_motion[body] = state_.bodies[body].motion_at(state_.time);
}

void Simulation::set_gravity(const Eigen::Vector3d& gravity) {
  SimulationState& now = state_;
  if (gravity == now.settings.gravity) return;
  if (!gravity.allFinite()) throw std::invalid_argument("gravity must be finite");
  change_energy([&] {
    for (std::size_t k = 0; k < now.grains.size(); ++k)
      now.grains.force[k] += now.shape_of(k).mass * (gravity - now.settings.gravity);
    now.settings.gravity = gravity;
    renew_integrator(now);
    now.sleep.wake_all();
    sort_and_search(now, *policy_);
  });
}

void Simulation::set_contact(const ContactLaws& contact) {
  SimulationState& now = state_;
  if (contact.scaling.torque_factor() != now.settings.contact.scaling.torque_factor())
    throw std::invalid_argument("the scaling of forces sets moments of inertia and cannot change in a run");
  auto grain_loop = make_grain_loop(now.types, contact, now.settings.lever_arm);
  auto wall_loop = make_wall_loop(now.types, contact, now.settings.lever_arm, surfaces_of(now.bodies));
  skin_for(now.settings, now.types, grain_loop->range());  // refuses periods that the new law reaches across
  change_energy([&] {
    now.sleep.wake_all();
    clear_changed_history(now.list.blocks(), *now.grain_loop, *grain_loop);
    clear_changed_history(now.list.blocks(), *now.wall_loop, *wall_loop);
    NewOrder sorted = sort_in_space(now, *policy_);
    if (!same_width(*grain_loop, *now.grain_loop)) sorted.histories.grains = {};
    if (!same_width(*wall_loop, *now.wall_loop)) sorted.histories.walls = {};
    now.grain_loop = std::move(grain_loop);
    now.wall_loop = std::move(wall_loop);
    now.settings.contact = contact;
    renew_integrator(now);
    now.list =
        NeighbourList(neighbour_settings(now.types, *now.grain_loop, *now.wall_loop), now.list.body_first());
    search_again(now, *policy_, sorted);
  });
}

void Simulation::stop_grains() {
  // Forces stay those of the last step, with their drag: it acts for half a step more.
  change_energy([&] {
    for (auto& velocity : state_.grains.velocity) velocity.setZero();
    for (auto& spin : state_.grains.spin) spin.setZero();
    state_.sleep.wake_all();
    sort_and_search(state_, *policy_);
  });
}

void Simulation::add_velocities(const std::function<Eigen::Vector3d(std::uint64_t)>& added) {
  change_energy([&] {
    for (std::size_t k = 0; k < state_.grains.size(); ++k)
      state_.grains.velocity[k] += added(state_.grains.id[k]);
    state_.sleep.wake_all();
    sort_and_search(state_, *policy_);
  });
}

}  // namespace diefill::engine
