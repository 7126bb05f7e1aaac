#include "process/cluster/lammps/rank_steps.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace diefill::process::cluster {

RankSteps::RankSteps(PowderModel powder_model)
    : model_(std::move(powder_model)),
      grains_(model_),
      grain_pass_(make_grain_pass(model_)),
      wall_pass_(make_wall_pass(model_)),
      integrator_(model_.types, model_.settings.gravity, model_.settings.air_viscosity,
                  grain_pass_->rolls() || wall_pass_->rolls(), model_.settings.time_step,
                  model_.settings.instructions) {}

void RankSteps::plan(std::vector<engine::BodyMotion> motions) {
  planned_ = std::move(motions);
  step_ = 0;
  records_.clear();
}

bool RankSteps::advance() {
  // Displacements are summed over many steps and positions are rounded: the factor exceeds both errors
  // together.
  constexpr double kRounding = 1 + 1e-6;
  const std::size_t bodies = model_.bodies.size();
  std::copy_n(planned_.begin() + static_cast<std::ptrdiff_t>(step_ * bodies), bodies,
              grains_.body_motion.begin());
  ++step_;
  since_search_ += model_.settings.time_step;
  const auto drifted = engine::plain(Eigen::Vector3d(drift_ * model_.settings.time_step));
  grains_.motion.set_poses(grains_.grains.position, grains_.grains.orientation);
  grains_.motion.set_motions(grains_.grains.velocity, grains_.grains.spin);
  remaining_ -= kRounding * integrator_.advance(grains_.grains, 0, grains_.own, drifted, grains_.motion);
  if (remaining_ <= 0) remaining_ = 0.5 * model_.skin - largest_displacement();
  return remaining_ < 0 || tools_moved_far();
}

/// m, of any own sphere against the powder's drift since the last search.
double RankSteps::largest_displacement() const {
  const Eigen::Vector3d drifted = since_search_ * drift_;
  const bool clumps = model_.types.clumps();
  double farthest = 0;
  for (std::size_t k = 0; k < grains_.own; ++k) {
    double way = (grains_.grains.position[k] - place_then_[k] - drifted).norm();
    if (clumps)
      way += model_.types.displacement_per_turn() *
             (grains_.grains.orientation[k] - orientation_then_[k]).norm();
    farthest = std::max(farthest, way);
  }
  return farthest;
}

bool RankSteps::tools_moved_far() const {
  const Eigen::Vector3d drifted = since_search_ * drift_;
  for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
    const engine::BodyMotion &now = grains_.body_motion[b], &then = tools_then_[b];
    const double moved = (now.translation - then.translation - drifted).norm() +
                         model_.bodies[b].extent() * (now.rotation - then.rotation).norm();
    if (moved > 0.5 * model_.skin + clearance_[b]) return true;
  }
  return false;
}

void RankSteps::store_history() {
  if (!listed_) return;
  for (std::size_t k = 0; k < grains_.own; ++k) grains_.memory[k].clear();
  grain_pass_->store_history(grains_);
  wall_pass_->store_history(grains_);
  listed_ = false;
}

void RankSteps::search(const NearGrains& near, const Eigen::Vector3d& drift) {
  grain_pass_->search(grains_, near);
  wall_pass_->search(grains_, near);
  for (std::size_t k = 0; k < grains_.own; ++k) grains_.memory[k].clear();
  const auto own = static_cast<std::ptrdiff_t>(grains_.own);
  place_then_.assign(grains_.grains.position.begin(), grains_.grains.position.begin() + own);
  if (model_.types.clumps())
    orientation_then_.assign(grains_.grains.orientation.begin(), grains_.grains.orientation.begin() + own);
  tools_then_ = grains_.body_motion;
  clearance_.resize(model_.bodies.size());
  for (std::size_t b = 0; b < clearance_.size(); ++b) clearance_[b] = clearance_of(b);
  drift_ = drift;
  since_search_ = 0;
  remaining_ = 0.5 * model_.skin;
  listed_ = true;
}

/// m, by how much body and own grains stand farther apart than near pairs reach; coarse: the grains' box as a
/// ball.
double RankSteps::clearance_of(std::size_t body) const {
  if (grains_.own == 0) return 1e300;
  Eigen::AlignedBox3d powder;
  for (std::size_t k = 0; k < grains_.own; ++k) powder.extend(grains_.grains.position[k]);
  const engine::WallBody& wall = model_.bodies[body];
  const engine::BodyMotion& pose = grains_.body_motion[body];
  const Eigen::Vector3d middle = pose.rotation.transpose() * (powder.center() - pose.translation);
  const Eigen::Vector3d beyond = (wall.lower() - middle).cwiseMax(middle - wall.upper()).cwiseMax(0.0);
  const double reach = model_.types.largest_grain() + wall.sphere_radius() + model_.skin;
  return std::max(0.0, beyond.norm() - 0.5 * powder.diagonal().norm() - reach);
}

void RankSteps::add_forces() {
  figures_.start(model_.bodies.size());
  grains_.sums.resize(grains_.own);
  grain_pass_->add_forces(grains_, figures_);
  wall_pass_->add_forces(grains_, figures_);
}

void RankSteps::finish() {
  const std::size_t numbers = !model_.types.rotates()                       ? engine::ContactSum::kForce
                              : grain_pass_->rolls() || wall_pass_->rolls() ? engine::ContactSum::kRolling
                                                                            : engine::ContactSum::kMoment;
  const double time_step = model_.settings.time_step;
  sums_.start(grains_.own, numbers);
  sums_.keep(grains_.sums);
  double drawn = 0;
  if (const auto& air = model_.settings.air_flow) {
    grains_.motion.grains = grains_.own;
    const double speed = grains_.body_motion[air->body].velocity.z();
    drawn = time_step * air->add_forces(grains_.motion, 0, grains_.own, speed, sums_);
  }
  const auto work = integrator_.finish(grains_.grains, 0, grains_.own, sums_, 0);
  records_.add(figures_, work.drag + drawn, work.rolling, time_step);
}

engine::NamedContacts RankSteps::named(const ContactPass& pass) const {
  engine::NamedContacts contacts;
  if (listed_) pass.name_contacts(grains_, contacts);
  return contacts;
}

}  // namespace diefill::process::cluster
