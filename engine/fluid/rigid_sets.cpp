#include "engine/fluid/rigid_sets.h"

#include <stdexcept>

#include "engine/powder/rigid_motion.h"

namespace diefill::engine {

void RigidSets::add(const RigidSetSpec& spec) {
  if (!(spec.shape.mass > 0) || spec.shape.sphere_offsets.empty())
    throw std::invalid_argument("a solid in a fluid needs particles and a mass above 0");
  if (spec.turns && !(spec.shape.inertia.minCoeff() > 0))
    throw std::invalid_argument("a solid that turns needs moments of inertia above 0");
  first_.push_back(set_of_.size());
  set_of_.insert(set_of_.end(), spec.shape.spheres(), static_cast<std::uint32_t>(specs_.size()));
  specs_.push_back(spec);
  motion_.push_back({spec.centre, spec.velocity, spec.orientation.normalized(), spec.angular_velocity,
                     spec.drive, Eigen::Vector3d::Zero()});
  turn_frames();
}

void RigidSets::restore(const std::vector<RigidSetMotion>& motion) {
  motion_ = motion;
  turn_frames();
}

void RigidSets::turn_frames() {
  frame_.resize(motion_.size());
  for (std::size_t s = 0; s < motion_.size(); ++s) frame_[s] = rotation_matrix(motion_[s].orientation);
  turn_spins();
}

void RigidSets::turn_spins() {
  spin_.resize(motion_.size());
  for (std::size_t s = 0; s < motion_.size(); ++s) spin_[s] = frame_[s] * motion_[s].spin;
}

Eigen::Vector3d RigidSets::arm(std::uint64_t particle) const {
  const std::uint32_t s = set_of_[particle];
  return frame_[s] * specs_[s].shape.sphere_offsets[particle - first_[s]];
}

void RigidSets::set_velocity(std::size_t s, const Eigen::Vector3d& velocity) {
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (!specs_[s].free[static_cast<std::size_t>(axis)]) motion_[s].velocity[axis] = velocity[axis];
}

void RigidSets::advance(double time_step) {
  for (std::size_t s = 0; s < specs_.size(); ++s) {
    const RigidSetSpec& spec = specs_[s];
    RigidSetMotion& now = motion_[s];
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double gained =
          spec.free[static_cast<std::size_t>(axis)] ? time_step / spec.shape.mass * now.force[axis] : 0;
      now.centre[axis] += time_step * (now.velocity[axis] + 0.5 * gained);
      now.velocity[axis] += gained;
    }
    if (!spec.turns) continue;
    const Eigen::Vector3d rate = spin_rate(spec.shape.inertia, now.spin, now.torque);
    now.orientation = advance_orientation(now.orientation, now.spin, rate, time_step);
    frame_[s] = rotation_matrix(now.orientation);
    spin_[s] = frame_[s] * (now.spin + time_step * rate);
  }
}

void RigidSets::place(std::size_t k, Grains& grains, const ShearedPeriod& period, double time) const {
  const std::uint32_t s = set_of_[grains.id[k]];
  const Eigen::Vector3d from_centre = arm(grains.id[k]);
  Eigen::Vector3d velocity = motion_[s].velocity + spin_[s].cross(from_centre);
  grains.position[k] = period.nearest(motion_[s].centre + from_centre, grains.position[k], time, velocity);
  grains.velocity[k] = velocity;
}

void RigidSets::finish(const Grains& grains, double time_step) {
  std::vector<Eigen::Vector3d> force, torque(specs_.size(), Eigen::Vector3d::Zero());
  for (const RigidSetSpec& spec : specs_) force.push_back(spec.drive);
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const std::uint32_t s = set_of_[grains.id[k]];
    if (s == kFluid) continue;
    force[s] += grains.force[k];
    if (specs_[s].turns) torque[s] += arm(grains.id[k]).cross(grains.force[k]);
  }
  for (std::size_t s = 0; s < specs_.size(); ++s) {
    const RigidSetSpec& spec = specs_[s];
    RigidSetMotion& now = motion_[s];
    // Velocities are those that the force at the start of the step predicts.
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      if (spec.free[static_cast<std::size_t>(axis)])
        now.velocity[axis] += 0.5 * time_step / spec.shape.mass * (force[s][axis] - now.force[axis]);
    now.force = force[s];
    if (!spec.turns) continue;
    const Eigen::Vector3d in_body = frame_[s].transpose() * torque[s];
    now.spin = advance_spin(spec.shape.inertia, now.spin, now.torque, in_body, time_step);
    now.torque = in_body;
  }
  turn_spins();
}

}  // namespace diefill::engine
