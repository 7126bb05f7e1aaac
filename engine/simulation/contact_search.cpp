#include "engine/simulation/contact_search.h"

#include <algorithm>
#include <string>

#include "engine/numerics/out_of_range.h"
#include "engine/search/drift_groups.h"
#include "engine/search/list_allowances.h"
#include "engine/search/passing_speed.h"
#include "engine/search/spatial_order.h"
#include "engine/simulation/sleep_rules.h"
#include "engine/walls/wall_clearance.h"

namespace diefill::engine {

namespace {

/// m; a grain farther out than this has been thrown there by an unstable run.
constexpr double kFarthestPlace = 1e6;

/// A search sorts grains into cells: there must be a place to sort them to.
void check_places(const SimulationState& state) {
  const Grains& grains = state.grains;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (grains.position[k].norm() < kFarthestPlace && grains.orientation_of(k).allFinite()) continue;
    throw OutOfRange(
        "grain " + std::to_string(grains.id[k]) +
        " no longer has a finite position at t = " + std::to_string(state.time) +
        " s: the run is unstable; take a shorter time step, and do not add grains inside others");
  }
}

/// `order`: of the grains in space, which the policy may change.
NewOrder with_contact_history(SimulationState& state, StepPolicy& policy, std::vector<std::uint32_t> order) {
  NewOrder sorted{std::move(order), 0, {}};
  sorted.awake = policy.sort(state, sorted.order);
  const NeighbourList& list = state.list;
  std::vector<std::uint32_t> owners;
  for (const auto& image : state.spheres.images) owners.push_back(image.owner);
  const PairNaming naming{state.spheres.spheres_per_grain, state.spheres.grains, &owners, &list.body_first()};
  std::vector<std::uint32_t> new_place(state.grains.size(), kGone);
  for (std::uint32_t k = 0; k < sorted.order.size(); ++k) new_place[sorted.order[k]] = k;
  const std::size_t spheres = sorted.order.size() * state.types.spheres();
  const auto signs = state.grain_loop->history_signs();
  sorted.histories = {grain_contact_history(list.blocks(), naming, new_place, signs, spheres, state.pool),
                      wall_contact_history(list.blocks(), naming, new_place, list.settings().wall_history,
                                           spheres, state.pool)};
  return sorted;
}

/// How far grains and bodies may move before the next search, by how fast they are now.
void allow_motion(SimulationState& state) {
  ListReference& reference = state.reference;
  const Grains& grains = state.grains;
  const AdaptiveSkin& skin = state.skin;
  const double time_step = state.settings.time_step, rim = state.list.settings().farthest_sphere;
  const bool grouped = reference.groups() > 1;
  const double largest = grouped ? skin.largest_grouped_allowance() : skin.largest_allowance();
  reference.doublings.resize(grains.size());
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const double speed =
        (grains.velocity[k] - reference.drift[reference.group_of(k)]).norm() + rim * grains.spin[k].norm();
    reference.doublings[k] = skin.doublings(reference.skin, speed * time_step, largest);
  }
  const double half = 0.5 * reference.skin;
  const auto body_allowance = [&](double speed) {
    if (!grouped) return reference.allowance_of(skin.doublings(reference.skin, speed * time_step));
    return std::clamp(skin.expected_displacement(reference.skin, speed * time_step), half,
                      std::max(half, skin.largest_passing()));
  };
  reference.body_allowance.clear();
  for (std::size_t group = 0; group < reference.groups(); ++group)
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
      const BodyMotion& motion = state.body_motion[b];
      reference.body_allowance.push_back(
          body_allowance((motion.velocity - reference.drift[group]).norm() +
                         state.bodies[b].extent() * motion.angular_velocity.norm()));
    }
}

/// Groups grains where this keeps them from being fast: where the groups would drift past each other by more
/// than the skin.
void group_grains(SimulationState& state) {
  ListReference& reference = state.reference;
  const AdaptiveSkin& skin = state.skin;
  if (skin.largest_passing() <= 0 || state.settings.sleep) return;
  auto groups = drift_groups(state.grains.velocity);
  if (!groups) return;
  const double passing =
      skin.expected_displacement(reference.skin, passing_speed(groups->drift) * state.settings.time_step);
  if (passing < reference.skin) return;
  reference.drift = groups->drift;
  reference.group = std::move(groups->group);
  reference.passing = std::min(passing, skin.largest_passing());
}

/// Takes down where all is now, of which the first `awake` grains move.
void store_reference(SimulationState& state, std::size_t awake) {
  ListReference& reference = state.reference;
  const Grains& grains = state.grains;
  reference.position = grains.position;
  if (state.types.clumps()) reference.orientation = grains.orientation;
  reference.bodies = state.body_motion;
  reference.time = state.time;
  reference.step = state.step;
  reference.awake_grains = awake;
  reference.drift = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  reference.group.clear();
  reference.passing = 0;
  // Where grains sleep, motion is measured against them: they are never the faster ones, so that every pair
  // of both kinds is an awake grain's.
  if (awake < grains.size()) {
    reference.drift[0] = carrier_motion(state).velocity;
  } else if (awake > 0) {
    for (const auto& velocity : grains.velocity) reference.drift[0] += velocity;
    reference.drift[0] /= static_cast<double>(grains.size());
    group_grains(state);
  }
  allow_motion(state);
}

void find_images(SimulationState& state, const ImageFinder& other) {
  auto& images = state.spheres.images;
  images.clear();
  if (!state.box.any()) return;
  // A grain on the border meets others whose centre is up to two grain radii and what both may move beyond
  // it.
  const double margin = 2 * state.types.largest_grain() + state.grain_loop->range() +
                        2 * farthest_allowance(state.reference) + state.reference.passing;
  if (other) {
    other(state, margin);
  } else {
    for (std::uint32_t k = 0; k < state.reference.position.size(); ++k)
      state.box.add_images(k, state.reference.position[k], margin, images);
  }
  images.shrink_to_fit();
}

/// Notes which blocks have grains of both groups.
void note_mixed_blocks(SimulationState& state) {
  const ListReference& reference = state.reference;
  const auto& blocks = state.list.blocks();
  state.mixed_block.assign(blocks.size(), 0);
  if (reference.groups() == 1) return;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (std::size_t k = blocks[b].begin; k < blocks[b].end; ++k)
      if (reference.group_of(k) != reference.group_of(blocks[b].begin)) state.mixed_block[b] = 1;
}

/// Notes how far every body stands from the powder, beyond what the list allows it to move.
void measure_clearances(SimulationState& state) {
  const SphereField& spheres = state.spheres;
  Eigen::AlignedBox3d powder;
  for (std::size_t k = 0; k < spheres.size(); ++k) powder.extend(eigen(spheres.position(k)));
  const double sphere_reach = state.types.largest_sphere() + farthest_allowance(state.reference);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const WallBody& body = state.bodies[b];
    const double allowance = farthest_allowance_of_body(state.reference, b);
    state.clearance[b] = spheres.grains == 0 || !state.settings.skip_far_walls
                             ? 0
                             : clearance_of(body, state.reference.bodies[b], powder,
                                            sphere_reach + body.sphere_radius() + allowance);
  }
}

}  // namespace

void wrap_grains(SimulationState& state) {
  if (!state.box.any()) return;
  for (std::size_t k = 0; k < state.grains.size(); ++k) {
    Eigen::Vector3d& position = state.grains.position[k];
    const Eigen::Vector3d before = position;
    position = state.box.wrapped(before);
    state.ledger.added_energy -= state.shape_of(k).mass * state.settings.gravity.dot(position - before);
    if (state.border_watch && position != before) state.border_watch(k, before, position);
  }
}

NewOrder sort_in_space(SimulationState& state, StepPolicy& policy) {
  check_places(state);
  wrap_grains(state);
  // Where sizes differ, no two grains have room in one cell: the order does not depend on the one before.
  const double cell =
      state.types.monodisperse() ? 2 * state.types.largest_grain() : state.types.smallest_sphere();
  return with_contact_history(state, policy, spatial_order(state.grains.position, cell, state.pool));
}

void sort_and_search(SimulationState& state, StepPolicy& policy) {
  search_again(state, policy, sort_in_space(state, policy));
}

void search_in_order(SimulationState& state, StepPolicy& policy, std::vector<std::uint32_t> order) {
  search_again(state, policy, with_contact_history(state, policy, std::move(order)));
}

void search_again(SimulationState& state, StepPolicy& policy, const NewOrder& sorted,
                  const ImageFinder& images) {
  state.grains.reorder(sorted.order);
  state.spheres.reorder_motion(sorted.order);
  store_reference(state, sorted.awake);
  search_at_reference(state, sorted.histories, images);
  state.spheres.set_poses(state.grains.position, state.grains.orientation);
  policy.after_search(state);
}

void search_at_reference(SimulationState& state, const ContactHistories& histories,
                         const ImageFinder& images) {
  ++state.searches;
  SphereField& spheres = state.spheres;
  const ListReference& reference = state.reference;
  spheres.grains = reference.position.size();
  find_images(state, images);
  check_sphere_count(spheres.size());
  if (!state.types.monodisperse()) spheres.kind = state.grains.kind;
  if (state.types.clumps()) {
    spheres.velocity.resize(spheres.grains);
    spheres.spin.resize(spheres.grains);
  }
  spheres.set_motions(state.grains.velocity, state.grains.spin);
  spheres.set_poses(reference.position, reference.orientation);
  spheres.cache_positions(state.pool);
  state.list.build(spheres, state.bodies, reference, histories.grains, histories.walls, state.pool);
  state.tallies.resize(state.list.blocks().size());
  state.remaining_skin.assign(state.list.blocks().size(), 0);
  note_mixed_blocks(state);
  measure_clearances(state);
  spheres.clear_cached_positions();
}

}  // namespace diefill::engine
