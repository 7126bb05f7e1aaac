#include "engine/simulation/all_grains_policy.h"

#include <chrono>

#include "engine/simulation/block_forces.h"

namespace diefill::engine {

namespace {

/// From so many blocks on, what a block is finished from has left the caches by the time that the pairs of
/// all have been computed. With fewer, threads would wait for each other in the end for nothing.
constexpr std::size_t kManyBlocks = 64;

/// Adds the forces of drawn air to those of the contacts of block b.
void draw_air(SimulationState& state, std::size_t b, ContactSums& contacts) {
  const AirFlow& air = *state.settings.air_flow;
  const double speed = state.body_motion[air.body].velocity.z();
  const Block& block = state.list.blocks()[b];
  const double power = air.add_forces(state.spheres, block.begin, block.end, speed, contacts);
  state.tallies[b].drag_work += power * state.settings.time_step;
}

/// Velocities at the end of the step of the grains of block b.
void finish_block(SimulationState& state, std::size_t b) {
  Block& block = state.list.blocks()[b];
  // The sums of the block's own pairs are not needed any more, so they are not copied.
  gather(
      state, b, block.sums, [&](std::size_t) -> const auto& { return state.grains.position; });
  if (state.settings.air_flow) draw_air(state, b, block.sums);
  const auto work = state.integrator.finish(state.grains, block.begin, block.end, block.sums, 0);
  state.tallies[b].drag_work += work.drag;
  state.tallies[b].rolling_work += work.rolling;
}

}  // namespace

double AllGrainsPolicy::advance_block(SimulationState& state, std::size_t b) {
  const Block& block = state.list.blocks()[b];
  const ListReference& reference = state.reference;
  const double time_step = state.settings.time_step;
  const std::size_t group = block.grains() > 0 ? reference.group_of(block.begin) : 0;
  const Vector3 drifted = plain(Eigen::Vector3d(reference.drift[group] * time_step));
  const double moved = state.integrator.advance(state.grains, block.begin, block.end, drifted, state.spheres);
  // Grains of the other group have another drift.
  return state.mixed_block[b] == 0 ? moved : moved + reference.passing_speed() * time_step;
}

void AllGrainsPolicy::compute_forces(SimulationState& state) {
  const std::size_t count = state.list.blocks().size();
  if (count >= kManyBlocks) return compute_interleaved(state);
  state.pool.for_each_by_worker(
      count, [&](std::size_t b, std::size_t worker) { compute_block(state, b, state.workspaces[worker]); });
  state.timers.lap(Phase::contacts);
  state.pool.for_each(count, [&](std::size_t b) { finish_block(state, b); });
}

/// The same, block by block.
void AllGrainsPolicy::compute_interleaved(SimulationState& state) {
  const std::size_t count = state.list.blocks().size();
  if (awaited_.size() != count) awaited_ = std::vector<std::atomic<std::uint32_t>>(count);
  for (std::size_t b = 0; b < count; ++b)
    awaited_[b].store(state.list.awaited_by(b), std::memory_order_relaxed);
  using Clock = std::chrono::steady_clock;
  state.pool.for_each_by_worker(count, [&](std::size_t b, std::size_t worker) {
    const auto began = Clock::now();
    compute_block(state, b, state.workspaces[worker], OtherBlocks::finish);
    const auto computed = Clock::now();
    for (const std::uint32_t other : state.list.waiting_for(b))
      if (awaited_[other].fetch_sub(1, std::memory_order_acq_rel) == 1) finish_block(state, other);
    state.tallies[b].computing_time = std::chrono::duration<double>(computed - began).count();
    state.tallies[b].finishing_time = std::chrono::duration<double>(Clock::now() - computed).count();
  });
  double computing = 0, finishing = 0;
  for (const auto& tally : state.tallies) {
    computing += tally.computing_time;
    finishing += tally.finishing_time;
  }
  state.timers.lap(Phase::contacts, Phase::gather, finishing / (computing + finishing));
}

}  // namespace diefill::engine
