#include "engine/walls/free_body.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>

#include "engine/powder/rigid_motion.h"

namespace diefill::engine {

namespace {

bool is_unit(const Eigen::Vector3d& vector) {
  return std::abs(vector.norm() - 1) < 1e-9;
}

bool guided(const FreeBody& body) {
  return !body.spec.guide.isZero();
}

Eigen::Vector3d along_guide(const FreeBody& body, const Eigen::Vector3d& vector) {
  return guided(body) ? Eigen::Vector3d(vector.dot(body.spec.guide) * body.spec.guide) : vector;
}

/// m/s^2, of the centre.
Eigen::Vector3d acceleration(const FreeBody& body, const Eigen::Vector3d& gravity) {
  return along_guide(body, (body.force + body.spec.drive) / body.spec.mass + gravity);
}

/// The pose with a velocity (m/s) of the centre and a spin (rad/s) about the principal axes.
BodyMotion pose_with(const FreeBody& body, const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin) {
  const Eigen::Matrix3d turn = rotation_matrix(body.orientation);
  BodyMotion pose;
  pose.rotation = turn * body.principal_axes.transpose();
  const Eigen::Vector3d arm = pose.rotation * body.spec.centre;
  pose.translation = body.position - arm;
  pose.angular_velocity = turn * spin;
  pose.velocity = velocity - pose.angular_velocity.cross(arm);
  return pose;
}

void take_load(FreeBody& body, const BodyMotion& pose, const BodyLoad& load) {
  body.force = load.force;
  const Eigen::Vector3d about_centre = load.torque - (pose.rotation * body.spec.centre).cross(load.force);
  body.torque = rotation_matrix(body.orientation).transpose() * about_centre;
}

/// Puts the body back to its stops and throws back its velocity.
void apply_stops(FreeBody& body) {
  for (std::size_t k = 0; k < body.spec.stop_count; ++k) {
    const TravelStop& stop = body.spec.stops[k];
    const double beyond = stop.direction.dot(body.position - body.start) - stop.distance;
    if (beyond < 0) continue;
    body.position -= beyond * stop.direction;
    const double speed = stop.direction.dot(body.velocity);
    if (speed > 0) body.velocity -= (1 + stop.restitution) * speed * stop.direction;
  }
}

void check(const FreeBodySpec& spec) {
  if (!(spec.mass > 0)) throw std::invalid_argument("a free body needs a mass above 0");
  if (!spec.guide.isZero() && !is_unit(spec.guide))
    throw std::invalid_argument("the guide of a free body must be a unit vector");
  if (spec.stop_count > FreeBodySpec::kMaxStops)
    throw std::invalid_argument("a free body has too many stops");
  for (std::size_t k = 0; k < spec.stop_count; ++k) {
    const TravelStop& stop = spec.stops[k];
    if (!is_unit(stop.direction)) throw std::invalid_argument("a stop needs a unit direction");
    if (!spec.guide.isZero() && std::abs(std::abs(stop.direction.dot(spec.guide)) - 1) > 1e-9)
      throw std::invalid_argument("a stop of a guided body must act along its guide");
  }
}

}  // namespace

double FreeBody::kinetic_energy() const {
  return 0.5 * spec.mass * velocity.squaredNorm() + 0.5 * principal_inertia.dot(spin.cwiseAbs2());
}

FreeBody released(const FreeBodySpec& spec, const BodyMotion& pose, const BodyLoad& load) {
  check(spec);
  FreeBody body;
  body.spec = spec;
  if (spec.turns) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spec.inertia);
    body.principal_inertia = solver.eigenvalues();
    body.principal_axes = solver.eigenvectors();
    if (!(body.principal_inertia.minCoeff() > 0))
      throw std::invalid_argument("a free body that turns needs moments of inertia above 0");
    if (body.principal_axes.determinant() < 0) body.principal_axes.col(0) *= -1;
  }
  const Eigen::Quaterniond turn(Eigen::Matrix3d(pose.rotation * body.principal_axes));
  body.orientation = Quaternion(turn.w(), turn.x(), turn.y(), turn.z()).normalized();
  body.start = body.position = pose.point(spec.centre);
  body.velocity = along_guide(body, spec.velocity);
  if (spec.turns) body.spin = rotation_matrix(body.orientation).transpose() * spec.angular_velocity;
  take_load(body, pose, load);
  return body;
}

BodyMotion advance(FreeBody& body, const Eigen::Vector3d& gravity, double time_step) {
  if (body.held) return pose_of(body);
  const Eigen::Vector3d rate = acceleration(body, gravity);
  body.position += time_step * body.velocity + 0.5 * time_step * time_step * rate;
  Eigen::Vector3d predicted_spin = body.spin;
  if (body.spec.turns) {
    const Eigen::Vector3d rate_of_spin = spin_rate(body.principal_inertia, body.spin, body.torque);
    body.orientation = advance_orientation(body.orientation, body.spin, rate_of_spin, time_step);
    predicted_spin += time_step * rate_of_spin;
  }
  return pose_with(body, body.velocity + time_step * rate, predicted_spin);
}

BodyMotion finish(FreeBody& body, const BodyMotion& now, const BodyLoad& load, const Eigen::Vector3d& gravity,
                  double time_step) {
  if (body.held) return pose_of(body);
  const Eigen::Vector3d rate_before = acceleration(body, gravity), torque_before = body.torque;
  take_load(body, now, load);
  body.velocity += 0.5 * time_step * (rate_before + acceleration(body, gravity));
  if (body.spec.turns)
    body.spin = advance_spin(body.principal_inertia, body.spin, torque_before, body.torque, time_step);
  apply_stops(body);
  return pose_of(body);
}

BodyMotion pose_of(const FreeBody& body) {
  if (body.held) return pose_with(body, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  return pose_with(body, body.velocity, body.spin);
}

}  // namespace diefill::engine
