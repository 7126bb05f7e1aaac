// Checkpoint and restart of a simulation.
#include "engine/simulation/contact_search.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/step_phases.h"

namespace diefill::engine {

namespace {

/// Touching pairs of one kind over all blocks, by their number, with their history.
template <class Table>
Snapshot::History history_of(const std::vector<Block>& blocks, Table Block::*table) {
  Snapshot::History history;
  std::uint64_t before = 0;
  for (const auto& block : blocks) {
    const auto& pairs = block.*table;
    pairs.visit_touching([&](std::size_t p, const double* numbers) {
      history.pair.push_back(before + p);
      history.value.insert(history.value.end(), numbers, numbers + pairs.width);
    });
    before += pairs.size();
  }
  return history;
}

/// Puts what history_of() took back into the tables.
template <class Table>
void restore_history(std::vector<Block>& blocks, Table Block::*table, const Snapshot::History& history) {
  std::uint64_t before = 0;
  std::size_t next = 0;
  for (auto& block : blocks) {
    auto& pairs = block.*table;
    for (; next < history.pair.size() && history.pair[next] < before + pairs.size(); ++next)
      pairs.restore(history.pair[next] - before, history.value.data() + next * pairs.width);
    before += pairs.size();
  }
}

}  // namespace

Snapshot Simulation::snapshot() const {
  const auto& blocks = state_.list.blocks();
  Snapshot copy;
  copy.step = state_.step;
  copy.time = state_.time;
  copy.grains = state_.grains;
  copy.reference = state_.reference;
  copy.grain_history = history_of(blocks, &Block::grain_pairs);
  copy.wall_history = history_of(blocks, &Block::wall_pairs);
  copy.ledger = state_.ledger;
  copy.next_id = state_.next_id;
  copy.overlap = state_.overlap_of_run;
  copy.sleep = state_.sleep;
  return copy;
}

void Simulation::restore(const Snapshot& snapshot) {
  SimulationState& now = state_;
  now.step = snapshot.step;
  now.time = snapshot.time;
  now.ledger = snapshot.ledger;
  now.next_id = snapshot.next_id;
  now.overlap_of_run = snapshot.overlap;
  now.grains = snapshot.grains;
  // Older checkpoints have more than is needed.
  if (!now.types.clumps()) now.grains.orientation.clear();
  if (now.types.monodisperse()) now.grains.kind.clear();
  now.reference = snapshot.reference;
  if (now.settings.sleep) {
    now.sleep = snapshot.sleep;
    // A run without sleeping is resumed with all grains awake.
    now.sleep.resize(now.grains.size(), *now.settings.sleep);
  }
  // Tools keep their poses of the last search until resting blocks have been computed.
  now.body_motion = now.reference.bodies;
  search_at_reference(now, {});
  restore_history(now.list.blocks(), &Block::grain_pairs, snapshot.grain_history);
  restore_history(now.list.blocks(), &Block::wall_pairs, snapshot.wall_history);
  policy_->after_search(now);
  now.spheres.set_poses(now.grains.position, now.grains.orientation);
  move_bodies(now);
}

}  // namespace diefill::engine
