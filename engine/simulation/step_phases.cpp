#include "engine/simulation/step_phases.h"

#include <algorithm>
#include <array>
#include <limits>

#include "engine/numerics/prefetch.h"
#include "engine/powder/rigid_motion.h"
#include "engine/search/distance_rounding.h"

namespace diefill::engine {

namespace {

/// m, how much farther against the powder as a whole every sphere of the block may surely move before the
/// list is too old: below 0 when one has moved too far already.
double remaining_skin(const SimulationState& state, const Block& block) {
  const Grains& grains = state.grains;
  const ListReference& reference = state.reference;
  const double elapsed = state.time - reference.time;
  const std::array drifted = {plain(Eigen::Vector3d(reference.drift[0] * elapsed)),
                              plain(Eigen::Vector3d(reference.drift[1] * elapsed))};
  const auto way = [&](std::size_t k) {
    prefetch<1>(k, reference.position);
    return plain(grains.position[k]) - plain(reference.position[k]) - drifted[reference.group_of(k)];
  };
  double least = std::numeric_limits<double>::infinity();
  if (!state.types.clumps()) {
    std::array<double, AdaptiveSkin::kMaxDoublings + 1> farthest{};  // m^2, of those that may go as far
    for (std::size_t k = block.begin; k < block.end; ++k) {
      const Vector3 moved = way(k);
      double& squared = farthest[reference.doublings[k]];
      squared = std::max(squared, dot(moved, moved));
    }
    for (std::size_t doublings = 0; doublings < farthest.size(); ++doublings)
      least = std::min(least, reference.allowance_of(doublings) - std::sqrt(farthest[doublings]));
    return least;
  }
  const double displacement_per_turn = state.types.displacement_per_turn();
  for (std::size_t k = block.begin; k < block.end; ++k) {
    const PlainQuaternion turn = plain(grains.orientation[k]) - plain(reference.orientation[k]);
    least = std::min(
        least, reference.allowance(k) - length(way(k)) - displacement_per_turn * std::sqrt(dot(turn, turn)));
  }
  return least;
}

}  // namespace

void move_bodies(SimulationState& state) {
  for (std::size_t b = 0; b < state.bodies.size(); ++b)
    if (state.bodies[b].moves()) state.body_motion[b] = state.bodies[b].motion_at(state.time);
}

void advance_grains(SimulationState& state, StepPolicy& policy) {
  const auto& blocks = state.list.blocks();
  state.pool.for_each(blocks.size(), [&](std::size_t b) {
    double& remaining = state.remaining_skin[b];
    remaining -= kDistanceRounding * policy.advance_block(state, b);
    if (remaining <= 0) remaining = remaining_skin(state, blocks[b]);
    state.tallies[b].list_is_old = remaining < 0;
  });
}

bool list_is_old(const SimulationState& state) {
  for (const auto& tally : state.tallies)
    if (tally.list_is_old) return true;
  const ListReference& reference = state.reference;
  if (state.skin.is_too_wide(reference.skin, state.step - reference.step)) return true;
  const double elapsed = state.time - reference.time;
  if (reference.passing_speed() * elapsed > reference.passing) return true;
  for (std::size_t group = 0; group < reference.groups(); ++group) {
    const Eigen::Vector3d drifted = reference.drift[group] * elapsed;
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
      const BodyMotion &now = state.body_motion[b], &then = reference.bodies[b];
      const double moved = (now.translation - then.translation - drifted).norm() +
                           state.bodies[b].extent() * (now.rotation - then.rotation).norm();
      if (moved > reference.allowance_of_body(b, group) + state.clearance[b]) return true;
    }
  }
  return false;
}

void add_up_blocks(SimulationState& state) {
  Ledger& ledger = state.ledger;
  state.touching = 0;
  state.overlap = {};
  for (auto& load : state.wall_loads) load = {};
  for (const auto& tally : state.tallies) {
    ledger.viscous_work += tally.viscous_work;
    ledger.tangential_work += tally.tangential_work;
    ledger.drag_work += tally.drag_work;
    ledger.rolling_work += tally.rolling_work;
    state.touching += tally.touching;
    state.overlap.include(tally.overlap);
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
      state.wall_loads[b].force += tally.body_force[b];
      state.wall_loads[b].torque += tally.body_torque[b];
    }
  }
  state.overlap_of_run.include(state.overlap);
  add_wall_work(state);
}

void add_wall_work(SimulationState& state) {
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const WallLoad& load = state.wall_loads[b];
    const BodyMotion& motion = state.body_motion[b];
    state.ledger.wall_work -= (load.force.dot(motion.velocity) + load.torque.dot(motion.angular_velocity)) *
                              state.settings.time_step;
  }
}

}  // namespace diefill::engine
