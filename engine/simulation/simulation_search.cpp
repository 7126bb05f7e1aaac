// How a simulation renews its list of near pairs, and how it stops and goes on.
#include <algorithm>
#include <numeric>
#include <string>

#include "engine/numerics/out_of_range.h"
#include "engine/powder/rigid_motion.h"
#include "engine/search/spatial_order.h"
#include "engine/simulation/simulation.h"

namespace diefill::engine {

namespace {

/// m; a grain farther out than this has been thrown there by an unstable run.
constexpr double kFarthestPlace = 1e6;

/// How far (m) body and powder are apart at least, beyond `reach`; 0 when near. Coarse: the powder's box as a
/// ball.
double clearance_of(const WallBody& body, const BodyMotion& pose, const Eigen::Vector3d& lower,
                    const Eigen::Vector3d& upper, double reach) {
  const Eigen::Vector3d middle = pose.rotation.transpose() * (0.5 * (lower + upper) - pose.translation);
  const Eigen::Vector3d beyond = (body.lower() - middle).cwiseMax(middle - body.upper()).cwiseMax(0.0);
  return std::max(0.0, beyond.norm() - 0.5 * (upper - lower).norm() - reach);
}

}  // namespace

bool Simulation::list_is_old() const {
  for (const auto& tally : tallies_)
    if (tally.list_is_old) return true;
  if (skin_.is_too_wide(reference_.skin, step_ - reference_.step)) return true;
  const Eigen::Vector3d drifted = reference_.drift * (time_ - reference_.time);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const BodyMotion &now = body_motion_[b], &then = reference_.bodies[b];
    const double body_moved = (now.translation - then.translation - drifted).norm() +
                              bodies_[b].extent() * (now.rotation - then.rotation).norm();
    if (body_moved > reference_.body_allowance[b] + clearance_[b]) return true;
  }
  return false;
}

/// Puts grains that have left the periodic box back into it. Searches find images of grains in the box only.
void Simulation::wrap_grains() {
  if (!box_.any()) return;
  for (std::size_t k = 0; k < grains_.size(); ++k) {
    const Eigen::Vector3d before = grains_.position[k];
    grains_.position[k] = box_.wrapped(before);
    ledger_.added_energy -= shape_of(k).mass * settings_.gravity.dot(grains_.position[k] - before);
  }
}

/// A search sorts grains into cells: there must be a place to sort them to.
void Simulation::check_places() const {
  for (std::size_t k = 0; k < grains_.size(); ++k) {
    if (grains_.position[k].norm() < kFarthestPlace && grains_.orientation_of(k).allFinite()) continue;
    throw OutOfRange("grain " + std::to_string(grains_.id[k]) +
                     " has no finite position any more at t = " + std::to_string(time_) +
                     " s: the run is unstable; take a shorter time step, and add no grain where another is");
  }
}

std::vector<std::uint32_t> Simulation::order_in_space() {
  // Where sizes differ, no two grains have room in one cell: the order does not depend on the one before.
  const double cell = types_.monodisperse() ? 2 * types_.largest_grain() : types_.smallest_sphere();
  return spatial_order(grains_.position, cell, pool_);
}

void Simulation::sort_and_search() {
  check_places();
  wrap_grains();
  search_in_order(order_in_space());
}

void Simulation::search_in_order(std::vector<std::uint32_t> order) {
  const auto histories = remember_contacts(order);
  search_again(order, histories);
}

/// `order`: of the grains in space, which is changed so that awake grains come first.
Simulation::ContactHistories Simulation::remember_contacts(std::vector<std::uint32_t>& order) {
  awake_in_order_ = sleeping_ ? sleeping_->reorder(order, grains_.size()) : order.size();
  std::vector<std::uint32_t> owners;
  for (const auto& image : spheres_.images) owners.push_back(image.owner);
  const PairNaming naming{spheres_.spheres_per_grain, spheres_.grains, &owners, &list_.body_first()};
  std::vector<std::uint32_t> new_place(grains_.size(), kGone);
  for (std::uint32_t k = 0; k < order.size(); ++k) new_place[order[k]] = k;
  const std::size_t spheres = order.size() * types_.spheres();
  const auto signs = grain_loop_->history_signs();
  return {remember_grain_contacts(list_.blocks(), naming, new_place, signs, spheres, pool_),
          remember_wall_contacts(list_.blocks(), naming, new_place, list_.settings().wall_history, spheres,
                                 pool_)};
}

void Simulation::search_again(const std::vector<std::uint32_t>& order, const ContactHistories& histories) {
  grains_.reorder(order);
  spheres_.reorder_motion(order);
  remember_reference(awake_in_order_);
  search(histories.grains, histories.walls);
  spheres_.stand_at(grains_.position, grains_.orientation);
  if (sleeping_) compute_resting();
}

void Simulation::remember_reference(std::size_t awake) {
  reference_.position = grains_.position;
  if (types_.clumps()) reference_.orientation = grains_.orientation;
  reference_.bodies = body_motion_;
  reference_.time = time_;
  reference_.step = step_;
  reference_.awake_grains = awake;
  reference_.drift.setZero();
  // Where grains sleep, motion is measured against them: they are never the swifter ones, so that every pair
  // of both kinds is an awake grain's.
  if (awake < grains_.size()) {
    reference_.drift = carrier().velocity;
  } else if (awake > 0) {
    for (const auto& velocity : grains_.velocity) reference_.drift += velocity;
    reference_.drift /= static_cast<double>(grains_.size());
  }
  allow_motion();
}

/// How far grains and bodies may move before the next search, by how fast they are now.
void Simulation::allow_motion() {
  const auto doublings = [&](double speed) {
    return skin_.doublings(reference_.skin, speed * settings_.time_step);
  };
  const double rim = list_.settings().farthest_sphere;
  reference_.doublings.resize(grains_.size());
  for (std::size_t k = 0; k < grains_.size(); ++k)
    reference_.doublings[k] =
        doublings((grains_.velocity[k] - reference_.drift).norm() + rim * grains_.spin[k].norm());
  reference_.body_allowance.resize(bodies_.size());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const double speed = (body_motion_[b].velocity - reference_.drift).norm() +
                         bodies_[b].extent() * body_motion_[b].angular_velocity.norm();
    reference_.body_allowance[b] = reference_.allowance_of(doublings(speed));
  }
}

void Simulation::search(const ContactHistory& history, const ContactHistory& wall_history) {
  ++searches_;
  spheres_.grains = reference_.position.size();
  find_images();
  if (!types_.monodisperse()) spheres_.kind = grains_.kind;
  if (types_.clumps()) {
    spheres_.velocity.resize(spheres_.grains);
    spheres_.spin.resize(spheres_.grains);
  }
  spheres_.move_at(grains_.velocity, grains_.spin);
  spheres_.stand_at(reference_.position, reference_.orientation);
  spheres_.hold_places(pool_);
  list_.build(spheres_, bodies_, reference_, history, wall_history, pool_);
  tallies_.resize(list_.blocks().size());
  remaining_skin_.assign(list_.blocks().size(), 0);
  if (sleeping_) {
    sleeping_->sort_blocks(list_);
    settle_motion_of_sleepers();
  }

  Eigen::Vector3d lower = Eigen::Vector3d::Constant(1e300), upper = -lower;
  for (std::size_t k = 0; k < spheres_.size(); ++k) {
    const Eigen::Vector3d centre = eigen(spheres_.position(k));
    lower = lower.cwiseMin(centre);
    upper = upper.cwiseMax(centre);
  }
  spheres_.drop_places();
  const double sphere_reach = types_.largest_sphere() + farthest_allowance();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const double reach = sphere_reach + bodies_[b].sphere_radius();
    clearance_[b] = spheres_.grains == 0 || !settings_.skip_far_walls
                        ? 0
                        : clearance_of(bodies_[b], reference_.bodies[b], lower, upper, reach);
  }
}

/// m, of any grain of the present list.
double Simulation::farthest_allowance() const {
  double farthest = 0;
  for (std::size_t k = 0; k < reference_.doublings.size(); ++k)
    farthest = std::max(farthest, reference_.allowance(k));
  return farthest;
}

void Simulation::find_images() {
  spheres_.images.clear();
  if (!box_.any()) return;
  // A grain on the border meets others whose centre is up to two grain radii and what both may move beyond
  // it.
  const double margin = 2 * types_.largest_grain() + grain_loop_->range() + 2 * farthest_allowance();
  for (std::uint32_t k = 0; k < reference_.position.size(); ++k)
    box_.add_images(k, reference_.position[k], margin, spheres_.images);
  spheres_.images.shrink_to_fit();
}

namespace {

/// Touching pairs of one kind over all blocks, by their number, with what they remember.
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
void recall(std::vector<Block>& blocks, Table Block::*table, const Snapshot::History& history) {
  std::uint64_t before = 0;
  std::size_t next = 0;
  for (auto& block : blocks) {
    auto& pairs = block.*table;
    for (; next < history.pair.size() && history.pair[next] < before + pairs.size(); ++next)
      pairs.recall(history.pair[next] - before, history.value.data() + next * pairs.width);
    before += pairs.size();
  }
}

}  // namespace

Snapshot Simulation::snapshot() const {
  Snapshot copy;
  copy.step = step_;
  copy.time = time_;
  copy.grains = grains_;
  copy.reference = reference_;
  copy.grain_history = history_of(list_.blocks(), &Block::grain_pairs);
  copy.wall_history = history_of(list_.blocks(), &Block::wall_pairs);
  copy.ledger = ledger_;
  copy.next_id = next_id_;
  copy.overlap = overlap_ever_;
  if (sleeping_) copy.sleep = sleeping_->state();
  return copy;
}

void Simulation::restore(const Snapshot& snapshot) {
  step_ = snapshot.step;
  time_ = snapshot.time;
  ledger_ = snapshot.ledger;
  next_id_ = snapshot.next_id;
  overlap_ever_ = snapshot.overlap;
  grains_ = snapshot.grains;
  // Older checkpoints have more than is needed.
  if (!types_.clumps()) grains_.orientation.clear();
  if (types_.monodisperse()) grains_.kind.clear();
  reference_ = snapshot.reference;
  if (sleeping_) {
    // A run in which nobody could sleep is gone on with by one in which all are awake.
    SleepState sleep = snapshot.sleep;
    sleep.asleep.resize(grains_.size(), 0);
    sleep.looks.resize(grains_.size(), 0);
    sleep.force.resize(grains_.size(), Eigen::Vector3d::Zero());
    if (settings_.sleep->stray > 0) sleep.place.resize(grains_.size(), Eigen::Vector3d::Zero());
    sleeping_->restore(sleep);
  }
  // Tools stand as they did then, until what rests has been computed.
  body_motion_ = reference_.bodies;
  search({}, {});
  recall(list_.blocks(), &Block::grain_pairs, snapshot.grain_history);
  recall(list_.blocks(), &Block::wall_pairs, snapshot.wall_history);
  if (sleeping_) compute_resting();
  spheres_.stand_at(grains_.position, grains_.orientation);
  move_bodies();
}

}  // namespace diefill::engine
