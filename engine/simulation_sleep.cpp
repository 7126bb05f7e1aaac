// How a simulation leaves sleeping grains alone, and when it looks at them.
#include "engine/rigid_motion.h"
#include "engine/simulation.h"

namespace diefill::engine {

/// Boxes (m) about the tools that move, or have since contacts were searched, a grain wider than they are.
std::vector<Eigen::AlignedBox3d> Simulation::moving_tools() const {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const BodyMotion &now = body_motion_[b], &then = reference_.bodies[b];
    if (now.velocity.isZero(0) && now.angular_velocity.isZero(0) && now.rotation == then.rotation &&
        now.translation == then.translation)
      continue;
    const Eigen::Vector3d lower = bodies_[b].lower(), upper = bodies_[b].upper();
    const Eigen::Vector3d middle = now.point(0.5 * (lower + upper));
    const Eigen::Vector3d half =
        now.rotation.cwiseAbs() * (0.5 * (upper - lower)) +
        Eigen::Vector3d::Constant(bodies_[b].sphere_radius() + 2 * kinds_.largest_grain());
    boxes.emplace_back(middle - half, middle + half);
  }
  return boxes;
}

void Simulation::wake_near_tools() {
  sleeping_->wake(sleeping_->within(moving_tools(), grains_), list_, spheres_);
}

void Simulation::advance_awake(std::size_t b) {
  const Block& block = list_.blocks()[b];
  sleeping_->for_awake(block.begin, block.end, [&](std::size_t first, std::size_t last) {
    integrator_.advance(grains_, first, last, spheres_);
  });
}

/// The forces of a resting block do not change: its grains stand, and so does whatever they touch. They are a
/// function of places and of springs as they were when it came to rest, so that computing them again, after a
/// restart, gives the same bits.
void Simulation::compute_resting(std::size_t b) {
  if (!sleeping_->computed(b)) {
    auto& grain_pairs = list_.blocks()[b].grain_pairs;
    auto& wall_pairs = list_.blocks()[b].wall_pairs;
    auto grain_touching = grain_pairs.touching, wall_touching = wall_pairs.touching;
    auto grain_memory = grain_pairs.memory, wall_memory = wall_pairs.memory;
    compute_block(b);
    grain_pairs.touching = std::move(grain_touching);
    wall_pairs.touching = std::move(wall_touching);
    grain_pairs.memory = std::move(grain_memory);
    wall_pairs.memory = std::move(wall_memory);
    sleeping_->set_computed(b);
  }
  BlockTally& tally = tallies_[b];
  tally.viscous_work = tally.tangential_work = tally.drag_work = tally.rolling_work = 0;
}

void Simulation::finish_awake(std::size_t b, const std::vector<ContactSum>& contacts) {
  const Block& block = list_.blocks()[b];
  sleeping_->for_awake(block.begin, block.end, [&](std::size_t first, std::size_t last) {
    const auto own = std::span(contacts).subspan(first - block.begin, last - first);
    const auto work = integrator_.finish(grains_, first, last, own);
    tallies_[b].drag_work += work.drag;
    tallies_[b].rolling_work += work.rolling;
  });
}

/// Forces and torques on sleepers, which no step has brought up to date.
void Simulation::weigh_sleepers() {
  const bool composed = kinds_.composed();
  const auto& blocks = list_.blocks();
  workers_.for_each(blocks.size(), [&](std::size_t b) {
    thread_local std::vector<ContactSum> contacts;
    bool gathered = false;
    for (std::size_t k = blocks[b].begin; k < blocks[b].end; ++k) {
      if (!sleeping_->asleep(k)) continue;
      if (!gathered) gather(b, contacts);
      gathered = true;
      const ContactSum& sum = contacts[k - blocks[b].begin];
      grains_.force[k] = eigen(sum.force()) + shape_of(k).mass * settings_.gravity;
      if (!kinds_.rotates()) continue;
      grains_.torque[k] = eigen(sum.moment());
      if (composed)
        grains_.torque[k] = rotation_matrix(grains_.orientation[k]).transpose() * grains_.torque[k];
    }
  });
}

/// Wakes whoever is disturbed and puts to sleep whoever is tired.
void Simulation::look_after_sleepers() {
  sleeping_->count_step(list_);
  if (step_ % Sleeping::kStepsPerLook != 0) return;
  weigh_sleepers();
  sleeping_->look(grains_);
  sleeping_->wake(sleeping_->disturbed(grains_, list_, spheres_), list_, spheres_);
  const auto tired = sleeping_->tired(grains_, moving_tools(), list_, spheres_);
  if (tired.empty()) return;
  for (const std::uint32_t k : tired) {
    ledger_.sleep_work -= sleeping_->kinetic_energy(grains_, k);
    grains_.velocity[k].setZero();
    grains_.spin[k].setZero();
  }
  sleeping_->put_to_sleep(tired);
  sort_and_search();
}

/// Sleepers' spheres stand still from now on.
void Simulation::still_sleepers() {
  for (std::size_t k = 0; k < spheres_.grains; ++k)
    if (sleeping_->asleep(k))
      for (std::size_t s = 0; s < spheres_.spheres_per_grain; ++s)
        spheres_.motion[k * spheres_.spheres_per_grain + s] = {};
}

}  // namespace diefill::engine
