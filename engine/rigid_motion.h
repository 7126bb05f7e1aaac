// Motion of a rigid grain: velocity Verlet for its centre, the norm-keeping quaternion scheme and the
// iterated Euler equations for its orientation (Bierwisch 2009, section 2.2.2, Eqs. 2.18 to 2.26).
#pragma once

#include <Eigen/Geometry>

#include "engine/grains.h"

namespace diefill::engine {

/// Rotation matrix, body to laboratory (the transpose of A, Bierwisch 2009, Eq. 2.13).
inline Eigen::Matrix3d rotation_matrix(const Quaternion& q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

/// 1/2 q * (0, Omega): what the matrix Q / 2 of Eq. 2.19 does, with Omega in the body frame (rad/s).
inline Quaternion quaternion_rate(const Quaternion& q, const Eigen::Vector3d& spin) {
  return 0.5 * Quaternion(-q[1] * spin[0] - q[2] * spin[1] - q[3] * spin[2],
                          q[0] * spin[0] + q[2] * spin[2] - q[3] * spin[1],
                          q[0] * spin[1] + q[3] * spin[0] - q[1] * spin[2],
                          q[0] * spin[2] + q[1] * spin[1] - q[2] * spin[0]);
}

/// dOmega/dt from Euler's equations (Bierwisch 2009, Eq. 2.24); torque (N m) and spin (rad/s) in the body
/// frame.
inline Eigen::Vector3d spin_rate(const Eigen::Vector3d& inertia, const Eigen::Vector3d& spin,
                                 const Eigen::Vector3d& torque) {
  return {(torque[0] + (inertia[1] - inertia[2]) * spin[1] * spin[2]) / inertia[0],
          (torque[1] + (inertia[2] - inertia[0]) * spin[2] * spin[0]) / inertia[1],
          (torque[2] + (inertia[0] - inertia[1]) * spin[0] * spin[1]) / inertia[2]};
}

/// Orientation after `time_step` (s): second order, with the multiplier lambda that keeps |q| = 1 (Eqs. 2.20
/// to 2.23).
inline Quaternion advance_orientation(const Quaternion& q, const Eigen::Vector3d& spin,
                                      const Eigen::Vector3d& rate_of_spin, double time_step) {
  const Quaternion first = quaternion_rate(q, spin);
  const double first_squared = first.squaredNorm();
  const Quaternion second = quaternion_rate(q, rate_of_spin) - q * first_squared;
  const double t2 = time_step * time_step;
  const double shortening = first_squared * t2;
  const double correction = first.dot(second) * t2 * time_step +
                            0.25 * (second.squaredNorm() - first_squared * first_squared) * t2 * t2;
  // 1 - sqrt(1 - x) as x / (1 + sqrt(1 - x)): the plain form rounds alike in every step and lets |q| drift.
  const double under_root = 1 - shortening - correction;
  const double lambda_t2 = (shortening + correction) / (1 + std::sqrt(under_root)) - 0.5 * shortening;
  return q + first * time_step + 0.5 * t2 * second - lambda_t2 * q;
}

/// Spin after `time_step` by the trapezoidal rule of Euler's equations, three iterations (Eq. 2.25). Torques
/// at the start and the end of the step, body frame.
inline Eigen::Vector3d advance_spin(const Eigen::Vector3d& inertia, const Eigen::Vector3d& spin,
                                    const Eigen::Vector3d& torque_start, const Eigen::Vector3d& torque_end,
                                    double time_step) {
  Eigen::Vector3d next = spin;
  for (int iteration = 0; iteration < 3; ++iteration)
    next = spin +
           0.5 * time_step * (spin_rate(inertia, spin, torque_start) + spin_rate(inertia, next, torque_end));
  return next;
}

}  // namespace diefill::engine
