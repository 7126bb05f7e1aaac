#include "engine/fluid/fluid_simulation.h"

#include <algorithm>
#include <stdexcept>

#include "engine/simulation/step_phases.h"

namespace diefill::engine {

namespace {

/// m, that a neighbour list allows images of a sheared box to move, beside what skins allow particles.
double shear_margin(const FluidSettings& settings, const ShearedPeriod& period) {
  constexpr double kOfReach = 0.1, kSteps = 6;
  return period.shears() ? std::max(kOfReach * settings.law.reach, kSteps * period.drift(settings.time_step))
                         : 0;
}

/// As powder of one type of single spheres: two touch within the fluid's reach, a sheared box's images a
/// little before.
SimulationSettings as_powder(const FluidSettings& settings) {
  const ShearedPeriod period(settings.period, settings.shear_rate);
  const double reach = settings.law.reach + period.search_error() + shear_margin(settings, period);
  settings.law.check();
  if (!(settings.particle_mass > 0)) throw std::invalid_argument("particles of a fluid need a mass above 0");
  SimulationSettings powder;
  powder.types = {{.shape = model_a(0.5 * reach, settings.particle_mass)}};
  powder.gravity.setZero();
  powder.time_step = settings.time_step;
  powder.period = settings.period;
  // The skin that follows the motion of powder is made for slow grains that seldom change their neighbours.
  constexpr double kOfReach = 0.4;
  powder.skin = settings.skin > 0 ? settings.skin : kOfReach * settings.law.reach;
  powder.threads = settings.threads;
  return powder;
}

}  // namespace

FluidSimulation::FluidSimulation(const FluidSettings& settings)
    : settings_(settings),
      shear_margin_(shear_margin(settings, ShearedPeriod(settings.period, settings.shear_rate))),
      state_(as_powder(settings), {}),
      policy_(settings) {
  state_.spheres.box = policy_.period().searched();
  search();
}

ImageFinder FluidSimulation::images() {
  if (!policy_.period().shears()) return {};
  return [this](SimulationState& state, double margin) {
    policy_.period().find_images(state.reference.position, margin, state.reference.time,
                                 state.spheres.images);
  };
}

void FluidSimulation::search() {
  if (policy_.period().shears()) policy_.period().wrap(state_.grains, state_.time);
  search_again(state_, policy_, sort_in_space(state_, policy_), images());
}

void FluidSimulation::append(const std::vector<Eigen::Vector3d>& places,
                             const std::vector<Eigen::Vector3d>& velocities) {
  if (places.size() != velocities.size())
    throw std::invalid_argument("particles need as many velocities as positions");
  Grains& grains = state_.grains;
  const std::size_t before = grains.size();
  grains.resize(before + places.size(), false, false);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::size_t g = before + k;
    grains.id[g] = state_.next_id++;
    grains.position[g] = places[k];
    grains.velocity[g] = velocities[k];
    for (auto* vectors : {&grains.spin, &grains.force, &grains.torque}) (*vectors)[g].setZero();
  }
}

void FluidSimulation::add_fluid(const std::vector<Eigen::Vector3d>& places,
                                const std::vector<Eigen::Vector3d>& velocities) {
  append(places, velocities);
  policy_.sets().add_fluid(places.size());
  search();
}

std::size_t FluidSimulation::add_solids(const std::vector<RigidSetSpec>& solids) {
  RigidSets& sets = policy_.sets();
  const std::size_t first = sets.size();
  for (const RigidSetSpec& solid : solids) {
    sets.add(solid);
    const std::size_t count = solid.shape.spheres(), before = state_.next_id;
    std::vector<Eigen::Vector3d> places;
    for (std::size_t k = 0; k < count; ++k) places.push_back(solid.centre + sets.arm(before + k));
    append(places, std::vector<Eigen::Vector3d>(count, solid.velocity));
  }
  search();
  return first;
}

/// Whether images have moved as far as the neighbour list allows.
bool FluidSimulation::shear_has_aged_list() const {
  return policy_.period().drift(state_.time - state_.reference.time) > shear_margin_;
}

void FluidSimulation::step() {
  SimulationState& now = state_;
  now.timers.begin();
  now.time = static_cast<double>(++now.step) * now.settings.time_step;
  policy_.move_tools(now);
  advance_grains(now, policy_);
  now.timers.lap(Phase::advance);
  if (list_is_old(now) || shear_has_aged_list()) {
    now.reference.skin = now.skin.next(now.reference.skin, now.step - now.reference.step);
    search();
    now.timers.lap(Phase::search);
  }
  policy_.compute_forces(now);
  add_up_blocks(now);
  now.timers.lap(Phase::gather);
}

FluidSnapshot FluidSimulation::snapshot() const {
  FluidSnapshot copy;
  copy.particles.step = state_.step;
  copy.particles.time = state_.time;
  copy.particles.grains = state_.grains;
  copy.particles.reference = state_.reference;
  copy.particles.next_id = state_.next_id;
  copy.solids = solids().motion();
  return copy;
}

void FluidSimulation::restore(const FluidSnapshot& snapshot) {
  SimulationState& now = state_;
  if (snapshot.particles.grains.size() != now.grains.size() || snapshot.solids.size() != solids().size())
    throw std::invalid_argument(
        "a snapshot of " + std::to_string(snapshot.particles.grains.size()) + " particles and " +
        std::to_string(snapshot.solids.size()) + " solids cannot be resumed by a simulation of " +
        std::to_string(now.grains.size()) + " and " + std::to_string(solids().size()));
  now.step = snapshot.particles.step;
  now.time = snapshot.particles.time;
  now.grains = snapshot.particles.grains;
  now.reference = snapshot.particles.reference;
  now.next_id = snapshot.particles.next_id;
  policy_.sets().restore(snapshot.solids);
  search_at_reference(now, {}, images());
  now.spheres.set_poses(now.grains.position, now.grains.orientation);
}

}  // namespace diefill::engine
