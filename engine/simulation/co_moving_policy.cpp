#include "engine/simulation/co_moving_policy.h"

#include "engine/simulation/sleep_rules.h"

namespace diefill::engine {

namespace {

/// N, on all grains of a resting block: of its own contacts, of those of other blocks, and their weight.
Eigen::Vector3d force_on_resting(const SimulationState& state, std::size_t b) {
  const NeighbourList& list = state.list;
  const Block& own = list.blocks()[b];
  Eigen::Vector3d force = state.mass_of(own.begin, own.end) * state.settings.gravity;
  for (std::size_t slot = 0; slot < own.grains(); ++slot) force += eigen(own.sums.force(slot));
  for (std::uint32_t f = list.foreign_first()[b]; f < list.foreign_first()[b + 1]; ++f) {
    const auto& place = list.foreign_sums()[f];
    force += eigen(list.blocks()[place.block].sums.force(place.slot));
  }
  return force;
}

}  // namespace

void CoMovingPolicy::move_tools(SimulationState& state) {
  const BodyMotion before = carrier_motion(state);
  SleepPolicy::move_tools(state);
  const BodyMotion now = carrier_motion(state);
  carried_ = now.translation - before.translation;
  take_to(state, now.velocity);
}

/// Sleepers go on with `velocity` (m/s), or all wake where their carrier gains it faster than powder would
/// follow without stirring: they still have the speed of the step before.
void CoMovingPolicy::take_to(SimulationState& state, const Eigen::Vector3d& velocity) {
  const SimulationSettings& settings = state.settings;
  const double largest_change = settings.sleep->acceleration * settings.gravity.norm() * settings.time_step;
  for (std::size_t k = 0; k < state.grains.size(); ++k) {
    if (!state.sleep.sleeps(k)) continue;
    Eigen::Vector3d& own = state.grains.velocity[k];
    if ((velocity - own).norm() > largest_change) return wake_all(state);
    state.ledger.sleep_work += 0.5 * state.shape_of(k).mass * (velocity.squaredNorm() - own.squaredNorm());
    own = velocity;
  }
}

double CoMovingPolicy::advance_block(SimulationState& state, std::size_t b) {
  const double way = SleepPolicy::advance_block(state, b);
  const Block& block = state.list.blocks()[b];
  for (std::size_t k = block.begin; k < block.end; ++k) {
    if (!state.sleep.sleeps(k)) continue;
    state.grains.position[k] += carried_;
    if (state.types.clumps()) state.spheres.set_motion(k, {plain(state.grains.velocity[k]), {}});
  }
  return way;
}

void CoMovingPolicy::before_search(SimulationState& state) {
  // Powder in a shoe that stands settles as any other.
  if (!carrier_motion(state).velocity.isZero(0)) fall_asleep(state);
}

void CoMovingPolicy::compute_forces(SimulationState& state) {
  acting_.assign(state.list.blocks().size(), Eigen::Vector3d::Zero());
  SleepPolicy::compute_forces(state);
}

/// What the block loses on tools over which it slides.
void CoMovingPolicy::compute_resting_block(SimulationState& state, std::size_t b) {
  BlockTally& tally = state.tallies[b];
  tally.tangential_work = 0;
  const Eigen::Vector3d velocity = carrier_motion(state).velocity;
  for (std::size_t body = 0; body < state.bodies.size(); ++body)
    tally.tangential_work -=
        tally.body_force[body].dot(velocity - state.body_motion[body].velocity) * state.settings.time_step;
}

void CoMovingPolicy::finish_resting_block(SimulationState& state, std::size_t b) {
  acting_[b] = force_on_resting(state, b);
}

void CoMovingPolicy::finish_block(SimulationState& state, std::size_t b, const ContactSums& contacts) {
  SleepPolicy::finish_block(state, b, contacts);
  const Block& block = state.list.blocks()[b];
  for (std::size_t k = block.begin; k < block.end; ++k)
    if (state.sleep.sleeps(k))
      acting_[b] += eigen(contacts.force(k - block.begin)) + state.shape_of(k).mass * state.settings.gravity;
}

void CoMovingPolicy::end_step(SimulationState& state) {
  for (const auto& force : acting_) state.ledger.sleep_work -= force.dot(carried_);
  SleepPolicy::end_step(state);
}

}  // namespace diefill::engine
