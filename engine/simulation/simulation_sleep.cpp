// How a simulation leaves sleeping grains alone, carries them along, and when it looks at them.
#include "engine/powder/rigid_motion.h"
#include "engine/simulation/simulation.h"

namespace diefill::engine {

/// The body that sleepers ride on, at the present time; one at rest where they stand still.
BodyMotion Simulation::carrier() const {
  return carries() ? body_motion_[*settings_.sleep->carrier] : BodyMotion{};
}

/// Boxes (m) about the tools that move, or have since contacts were searched, a grain wider than they are.
/// What moves as sleepers do leaves them alone.
std::vector<Eigen::AlignedBox3d> Simulation::moving_tools() const {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const BodyMotion &now = body_motion_[b], &then = reference_.bodies[b];
    if (now.velocity.isZero(0) && now.angular_velocity.isZero(0) && now.rotation == then.rotation &&
        now.translation == then.translation)
      continue;
    if (carries() && b == *settings_.sleep->carrier) continue;
    const Eigen::Vector3d lower = bodies_[b].lower(), upper = bodies_[b].upper();
    const Eigen::Vector3d middle = now.point(0.5 * (lower + upper));
    const Eigen::Vector3d half =
        now.rotation.cwiseAbs() * (0.5 * (upper - lower)) +
        Eigen::Vector3d::Constant(bodies_[b].sphere_radius() + 2 * types_.largest_grain());
    boxes.emplace_back(middle - half, middle + half);
  }
  return boxes;
}

/// Wakes those near tools that move, and all when their carrier gains speed faster than powder would follow
/// without stirring. They still have the speed of the step before.
void Simulation::mind_tools(const BodyMotion& carrier_before) {
  sleeping_->wake(sleeping_->within(moving_tools(), grains_), list_, spheres_);
  if (!carries()) return;
  const BodyMotion now = carrier();
  carried_ = now.translation - carrier_before.translation;
  take_to(now.velocity);
}

/// Sleepers go on with `velocity` (m/s), or wake where that is too sudden.
void Simulation::take_to(const Eigen::Vector3d& velocity) {
  const double swiftest_change =
      settings_.sleep->acceleration * settings_.gravity.norm() * settings_.time_step;
  for (std::size_t k = 0; k < grains_.size(); ++k) {
    if (!sleeping_->asleep(k)) continue;
    if ((velocity - grains_.velocity[k]).norm() > swiftest_change) return sleeping_->wake_all(list_);
    ledger_.sleep_work +=
        0.5 * shape_of(k).mass * (velocity.squaredNorm() - grains_.velocity[k].squaredNorm());
    grains_.velocity[k] = velocity;
  }
}

void Simulation::advance_awake(std::size_t b) {
  const Block& block = list_.blocks()[b];
  sleeping_->for_awake(block.begin, block.end, [&](std::size_t first, std::size_t last) {
    integrator_.advance(grains_, first, last, {}, spheres_);
  });
  if (carries()) carry(block);
}

/// Takes the block's sleepers along.
void Simulation::carry(const Block& block) {
  for (std::size_t k = block.begin; k < block.end; ++k) {
    if (!sleeping_->asleep(k)) continue;
    grains_.position[k] += carried_;
    if (types_.clumps()) spheres_.set_motion(k, {plain(grains_.velocity[k]), {}});
  }
}

/// The forces of a resting block do not change: its grains stand, or ride side by side, and so does whatever
/// they touch. They are computed once, when contacts have been searched: a function of places and of springs
/// as they were then, so that a restart finds the same bits.
void Simulation::compute_resting() {
  pool_.for_each(list_.blocks().size(), [&](std::size_t b) {
    if (!rests(b)) return;
    auto& grain_pairs = list_.blocks()[b].grain_pairs;
    auto& wall_pairs = list_.blocks()[b].wall_pairs;
    auto grain_touching = grain_pairs.touching, wall_touching = wall_pairs.touching;
    auto grain_history = grain_pairs.history, wall_history = wall_pairs.history;
    compute_block(b);
    grain_pairs.touching = std::move(grain_touching);
    wall_pairs.touching = std::move(wall_touching);
    grain_pairs.history = std::move(grain_history);
    wall_pairs.history = std::move(wall_history);
    BlockTally& tally = tallies_[b];
    tally.viscous_work = tally.tangential_work = tally.drag_work = tally.rolling_work = 0;
  });
}

/// What a resting block that is carried loses on tools over which it slides.
void Simulation::slide(std::size_t b) {
  BlockTally& tally = tallies_[b];
  tally.tangential_work = 0;
  const Eigen::Vector3d velocity = carrier().velocity;
  for (std::size_t body = 0; body < bodies_.size(); ++body)
    tally.tangential_work -=
        tally.body_force[body].dot(velocity - body_motion_[body].velocity) * settings_.time_step;
}

/// Contact forces on the grains of block b, which leave its sums as they are: those of a resting block are
/// needed as long as it rests. Good until the thread's next call.
const ContactSums& Simulation::gathered_copy(std::size_t b) const {
  thread_local ContactSums contacts;
  const Block& own = list_.blocks()[b];
  contacts.copy_first(own.sums, own.grains());
  gather(b, contacts);
  return contacts;
}

void Simulation::finish_awake(std::size_t b, const ContactSums& contacts) {
  const Block& block = list_.blocks()[b];
  BlockTally& tally = tallies_[b];
  sleeping_->for_awake(block.begin, block.end, [&](std::size_t first, std::size_t last) {
    const auto work = integrator_.finish(grains_, first, last, contacts, first - block.begin);
    tally.drag_work += work.drag;
    tally.rolling_work += work.rolling;
  });
  tally.held_force.setZero();
  if (!carries()) return;
  for (std::size_t k = block.begin; k < block.end; ++k)
    if (sleeping_->asleep(k))
      tally.held_force += eigen(contacts.force(k - block.begin)) + shape_of(k).mass * settings_.gravity;
}

/// N, on all grains of a resting block: of its own contacts, of those of other blocks, and their weight.
Eigen::Vector3d Simulation::force_on_resting(std::size_t b) const {
  const Block& own = list_.blocks()[b];
  Eigen::Vector3d force = mass_of(own.begin, own.end) * settings_.gravity;
  for (std::size_t slot = 0; slot < own.grains(); ++slot) force += eigen(own.sums.force(slot));
  for (std::uint32_t f = list_.foreign_first()[b]; f < list_.foreign_first()[b + 1]; ++f) {
    const auto& place = list_.foreign_sums()[f];
    force += eigen(list_.blocks()[place.block].sums.force(place.slot));
  }
  return force;
}

/// Forces and torques on sleepers, which no step has brought up to date.
void Simulation::weigh_sleepers() {
  const bool clumps = types_.clumps();
  const auto& blocks = list_.blocks();
  pool_.for_each(blocks.size(), [&](std::size_t b) {
    const ContactSums* contacts = nullptr;
    for (std::size_t k = blocks[b].begin; k < blocks[b].end; ++k) {
      if (!sleeping_->asleep(k)) continue;
      if (!contacts) contacts = &gathered_copy(b);
      const std::size_t sum = k - blocks[b].begin;
      grains_.force[k] = eigen(contacts->force(sum)) + shape_of(k).mass * settings_.gravity;
      if (!types_.rotates()) continue;
      grains_.torque[k] = eigen(contacts->moment(sum));
      if (clumps) grains_.torque[k] = rotation_matrix(grains_.orientation[k]).transpose() * grains_.torque[k];
    }
  });
}

/// Wakes whoever is disturbed and puts to sleep whoever is tired.
void Simulation::look_after_sleepers() {
  sleeping_->count_step(list_);
  if (step_ % Sleeping::kStepsPerLook != 0) return;
  const BodyMotion riding = carrier();
  weigh_sleepers();
  sleeping_->look(grains_, riding);
  sleeping_->wake(sleeping_->disturbed(grains_, riding.velocity, list_, spheres_), list_, spheres_);
  sleeping_->wake(sleeping_->within(settings_.sleep->awake, grains_), list_, spheres_);
  // Powder that is carried falls asleep when contacts are searched anyway, which is often.
  if (!carries() && fall_asleep()) sort_and_search();
}

/// Whether anybody does: contacts must then be searched.
bool Simulation::fall_asleep() {
  const Eigen::Vector3d velocity = carrier().velocity;
  if (carries() && velocity.isZero(0)) return false;  // powder in a shoe that stands settles as any other
  auto restless = moving_tools();
  restless.insert(restless.end(), settings_.sleep->awake.begin(), settings_.sleep->awake.end());
  const auto tired = sleeping_->tired(grains_, restless, list_, spheres_);
  for (const std::uint32_t k : tired) {
    const double kinetic = sleeping_->kinetic_energy(grains_, k, Eigen::Vector3d::Zero());
    ledger_.sleep_work += 0.5 * shape_of(k).mass * velocity.squaredNorm() - kinetic;
    grains_.velocity[k] = velocity;
    grains_.spin[k].setZero();
  }
  sleeping_->put_to_sleep(tired);
  return !tired.empty();
}

/// Sleepers' spheres stand still from now on, or move with their carrier; single spheres move as grains do.
void Simulation::settle_motion_of_sleepers() {
  if (!types_.clumps()) return;
  const Vector3 velocity = plain(carrier().velocity);
  for (std::size_t k = 0; k < spheres_.grains; ++k)
    if (sleeping_->asleep(k)) spheres_.set_motion(k, {velocity, {}});
}

}  // namespace diefill::engine
