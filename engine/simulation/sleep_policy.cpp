#include "engine/simulation/sleep_policy.h"

#include <algorithm>
#include <limits>

#include "engine/powder/rigid_motion.h"
#include "engine/simulation/block_forces.h"
#include "engine/simulation/contact_search.h"
#include "engine/simulation/sleep_rules.h"

namespace diefill::engine {

/// Wakes those near tools that move; no grain has moved yet.
void SleepPolicy::move_tools(SimulationState& state) {
  StepPolicy::move_tools(state);
  wake_these(state, sleepers_within(state, moving_tools(state)));
}

double SleepPolicy::advance_block(SimulationState& state, std::size_t b) {
  const Block& block = state.list.blocks()[b];
  state.sleep.for_awake(block.begin, block.end, [&](std::size_t first, std::size_t last) {
    state.integrator.advance(state.grains, first, last, {}, state.spheres);
  });
  return std::numeric_limits<double>::infinity();
}

/// Awake grains come first: sleepers get blocks of their own.
std::size_t SleepPolicy::sort(SimulationState& state, std::vector<std::uint32_t>& order) {
  state.sleep.resize(state.grains.size(), *state.settings.sleep);
  const auto first_sleeper = std::stable_partition(order.begin(), order.end(),
                                                   [&](std::uint32_t k) { return !state.sleep.sleeps(k); });
  state.sleep.reorder(order);
  return static_cast<std::size_t>(first_sleeper - order.begin());
}

void SleepPolicy::after_search(SimulationState& state) {
  rests_ = blocks_at_rest(state);
  // Sleepers' spheres stand still from now on, or move with their carrier; single spheres move as grains do.
  const Vector3 velocity = plain(carrier_motion(state).velocity);
  for (std::size_t k = 0; state.types.clumps() && k < state.spheres.grains; ++k)
    if (state.sleep.sleeps(k)) state.spheres.set_motion(k, {velocity, {}});
  compute_blocks_at_rest(state);
}

/// The forces of a resting block do not change: its grains stand, or ride side by side, and so does whatever
/// they touch. They are computed once, when contacts have been searched: a function of places and of springs
/// as they were then, so that a restart finds the same bits.
void SleepPolicy::compute_blocks_at_rest(SimulationState& state) {
  state.pool.for_each_by_worker(rests_.size(), [&](std::size_t b, std::size_t worker) {
    if (!rests_[b]) return;
    auto& grain_pairs = state.list.blocks()[b].grain_pairs;
    auto& wall_pairs = state.list.blocks()[b].wall_pairs;
    auto grain_touching = grain_pairs.touching, wall_touching = wall_pairs.touching;
    auto grain_history = grain_pairs.history, wall_history = wall_pairs.history;
    compute_block(state, b, state.workspaces[worker]);
    grain_pairs.touching = std::move(grain_touching);
    wall_pairs.touching = std::move(wall_touching);
    grain_pairs.history = std::move(grain_history);
    wall_pairs.history = std::move(wall_history);
    BlockTally& tally = state.tallies[b];
    tally.viscous_work = tally.tangential_work = tally.drag_work = tally.rolling_work = 0;
  });
}

void SleepPolicy::compute_forces(SimulationState& state) {
  state.pool.for_each_by_worker(rests_.size(), [&](std::size_t b, std::size_t worker) {
    if (rests_[b])
      compute_resting_block(state, b);
    else
      compute_block(state, b, state.workspaces[worker]);
  });
  state.timers.lap(Phase::contacts);
  state.pool.for_each_by_worker(rests_.size(), [&](std::size_t b, std::size_t worker) {
    if (rests_[b])
      finish_resting_block(state, b);
    else
      finish_block(state, b, gathered_copy(state, b, state.workspaces[worker]));
  });
}

/// Contact forces on the grains of block b, which leave its sums as they are: those of a resting block are
/// needed as long as it rests. Good until the workspace is used again.
const ContactSums& SleepPolicy::gathered_copy(const SimulationState& state, std::size_t b,
                                              BlockWorkspace& workspace) const {
  const Block& own = state.list.blocks()[b];
  workspace.gathered.copy_first(own.sums, own.grains());
  // Sums of a resting block are those of where its grains were when contacts were searched.
  gather(
      state, b, workspace.gathered, [&](std::size_t block) -> const auto& {
        return rests_[block] ? state.reference.position : state.grains.position;
      });
  return workspace.gathered;
}

void SleepPolicy::finish_block(SimulationState& state, std::size_t b, const ContactSums& contacts) {
  const Block& block = state.list.blocks()[b];
  BlockTally& tally = state.tallies[b];
  state.sleep.for_awake(block.begin, block.end, [&](std::size_t first, std::size_t last) {
    const auto work = state.integrator.finish(state.grains, first, last, contacts, first - block.begin);
    tally.drag_work += work.drag;
    tally.rolling_work += work.rolling;
  });
}

/// Wakes disturbed grains and puts candidates to sleep.
void SleepPolicy::end_step(SimulationState& state) {
  for (std::size_t b = 0; b < rests_.size(); ++b)
    if (rests_[b]) state.sleep.sphere_steps_left_out += state.list.blocks()[b].own_spheres();
  if (state.step % kStepsPerCheck != 0) return;
  update_forces_on_sleepers(state);
  check_grains(state);
  wake_these(state, disturbed(state, rests_));
  wake_these(state, sleepers_within(state, state.settings.sleep->awake));
  put_candidates_to_sleep(state);
}

/// Forces and torques on sleepers, which no step has brought up to date.
void SleepPolicy::update_forces_on_sleepers(SimulationState& state) const {
  Grains& grains = state.grains;
  const bool clumps = state.types.clumps(), rotates = state.types.rotates();
  const auto& blocks = state.list.blocks();
  state.pool.for_each_by_worker(blocks.size(), [&](std::size_t b, std::size_t worker) {
    const ContactSums* contacts = nullptr;
    for (std::size_t k = blocks[b].begin; k < blocks[b].end; ++k) {
      if (!state.sleep.sleeps(k)) continue;
      if (!contacts) contacts = &gathered_copy(state, b, state.workspaces[worker]);
      const std::size_t sum = k - blocks[b].begin;
      grains.force[k] = eigen(contacts->force(sum)) + state.shape_of(k).mass * state.settings.gravity;
      if (!rotates) continue;
      grains.torque[k] = eigen(contacts->moment(sum));
      if (clumps) grains.torque[k] = rotation_matrix(grains.orientation[k]).transpose() * grains.torque[k];
    }
  });
}

void SleepPolicy::put_candidates_to_sleep(SimulationState& state) {
  if (fall_asleep(state)) sort_and_search(state, *this);
}

bool SleepPolicy::fall_asleep(SimulationState& state) {
  const Eigen::Vector3d velocity = carrier_motion(state).velocity;
  auto near_moving_tools = moving_tools(state);
  const auto& awake = state.settings.sleep->awake;
  near_moving_tools.insert(near_moving_tools.end(), awake.begin(), awake.end());
  const auto fallen = sleep_candidates(state, near_moving_tools);
  for (const std::uint32_t k : fallen) {
    const double kinetic = kinetic_energy(state, k, Eigen::Vector3d::Zero());
    state.ledger.sleep_work += 0.5 * state.shape_of(k).mass * velocity.squaredNorm() - kinetic;
    state.grains.velocity[k] = velocity;
    state.grains.spin[k].setZero();
  }
  state.sleep.put_to_sleep(fallen);
  return !fallen.empty();
}

void SleepPolicy::wake_these(SimulationState& state, const std::vector<std::uint32_t>& sleepers) {
  if (sleepers.empty()) return;
  wake(state, sleepers);
  rests_ = blocks_at_rest(state);
}

void SleepPolicy::wake_all(SimulationState& state) {
  state.sleep.wake_all();
  rests_ = blocks_at_rest(state);
}

}  // namespace diefill::engine
