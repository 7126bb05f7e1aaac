#include "engine/fluid/fluid_policy.h"

#include <algorithm>

#include "engine/simulation/block_forces.h"

namespace diefill::engine {

FluidPolicy::FluidPolicy(const FluidSettings& settings)
    : law_(settings.law, settings.time_step),
      seed_(settings.seed),
      period_(settings.period, settings.shear_rate),
      workspaces_(settings.threads) {}

void FluidPolicy::move_tools(SimulationState& state) {
  sets_.advance(state.settings.time_step);
}

double FluidPolicy::advance_block(SimulationState& state, std::size_t b) {
  const Block& block = state.list.blocks()[b];
  Grains& grains = state.grains;
  const Eigen::Vector3d drifted = state.reference.drift[0] * state.settings.time_step;
  // Solids move their particles, wherever forces would have taken these.
  std::vector<std::pair<std::size_t, Eigen::Vector3d>> solid;
  if (sets_.any())
    for (std::size_t k = block.begin; k < block.end; ++k) {
      if (sets_.set_of(grains.id[k]) == RigidSets::kFluid) continue;
      solid.emplace_back(k, grains.position[k]);
      grains.force[k].setZero();
    }
  double farthest = state.integrator.advance(grains, block.begin, block.end, plain(drifted), state.spheres);
  for (const auto& [k, before] : solid) {
    grains.position[k] = before;
    sets_.place(k, grains, period_, state.time);
    farthest = std::max(farthest, (grains.position[k] - before - drifted).norm());
  }
  return farthest;
}

/// Adds up the densities about the block's own particles, and what these make them push with.
void FluidPolicy::gather_densities(const SimulationState& state, std::size_t b) {
  const NeighbourList& list = state.list;
  const Block& block = list.blocks()[b];
  double* density = density_.data() + block.begin;
  std::copy_n(blocks_[b].density.data(), block.grains(), density);
  for (std::uint32_t f = list.foreign_first()[b]; f < list.foreign_first()[b + 1]; ++f) {
    const auto& place = list.foreign_sums()[f];
    density[place.grain] += blocks_[place.block].density[place.slot];
  }
  for (std::size_t k = block.begin; k < block.end; ++k)
    push_[k] = sets_.set_of(state.grains.id[k]) == RigidSets::kFluid ? law_.push(density_[k]) : 0;
}

void FluidPolicy::finish_block(SimulationState& state, std::size_t b) {
  Block& block = state.list.blocks()[b];
  gather(
      state, b, block.sums, [&](std::size_t) -> const auto& { return state.grains.position; });
  state.integrator.finish(state.grains, block.begin, block.end, block.sums, 0);
}

void FluidPolicy::compute_forces(SimulationState& state) {
  auto& list = state.list.blocks();
  const std::size_t count = list.size();
  blocks_.resize(count);
  density_.resize(state.grains.size());
  push_.resize(state.grains.size());
  const FluidScene scene{
      law_, state.grains, state.spheres, sets_, period_, state.time, PairRandom(seed_, state.step)};
  state.pool.for_each_by_worker(count, [&](std::size_t b, std::size_t worker) {
    add_densities(list[b], scene, workspaces_[worker], blocks_[b]);
  });
  state.pool.for_each(count, [&](std::size_t b) { gather_densities(state, b); });
  state.pool.for_each_by_worker(count, [&](std::size_t b, std::size_t worker) {
    state.tallies[b].start(0);
    state.tallies[b].touching = blocks_[b].touching.size();
    add_fluid_forces(list[b], scene, push_, workspaces_[worker], blocks_[b]);
  });
  state.timers.lap(Phase::contacts);
  state.pool.for_each(count, [&](std::size_t b) { finish_block(state, b); });
  virial_.setZero();
  for (const FluidBlock& block : blocks_) virial_ += block.virial;
  if (!sets_.any()) return;
  sets_.finish(state.grains, state.settings.time_step);
  for (std::size_t k = 0; k < state.grains.size(); ++k)
    if (sets_.set_of(state.grains.id[k]) != RigidSets::kFluid)
      sets_.place(k, state.grains, period_, state.time);
}

}  // namespace diefill::engine
