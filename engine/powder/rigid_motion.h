// Motion of a rigid grain: velocity Verlet for its centre, the norm-keeping quaternion scheme and the
// iterated Euler equations for its orientation (Bierwisch 2009, section 2.2.2, Eqs. 2.18 to 2.26). Plain
// numbers, so that loops over many grains become vector instructions; the same for Eigen's types below.
#pragma once

#include <Eigen/Geometry>

#include "engine/numerics/vector3.h"
#include "engine/powder/grains.h"

namespace diefill::engine {

/// Quaternion in plain numbers, in the order of `Quaternion`.
struct PlainQuaternion {
  double w = 1, x = 0, y = 0, z = 0;
};

inline PlainQuaternion operator+(PlainQuaternion a, PlainQuaternion b) {
  return {a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z};
}
inline PlainQuaternion operator-(PlainQuaternion a, PlainQuaternion b) {
  return {a.w - b.w, a.x - b.x, a.y - b.y, a.z - b.z};
}
inline PlainQuaternion operator*(double s, PlainQuaternion a) {
  return {s * a.w, s * a.x, s * a.y, s * a.z};
}
inline double dot(PlainQuaternion a, PlainQuaternion b) {
  return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
}
inline PlainQuaternion plain(const Quaternion& q) {
  return {q[0], q[1], q[2], q[3]};
}
inline Quaternion eigen(PlainQuaternion q) {
  return {q.w, q.x, q.y, q.z};
}

/// Rows of a rotation matrix.
struct Rotation {
  Vector3 row_x, row_y, row_z;

  Vector3 operator*(Vector3 v) const { return {dot(row_x, v), dot(row_y, v), dot(row_z, v)}; }
  /// The inverse rotation of v.
  Vector3 back(Vector3 v) const { return v.x * row_x + v.y * row_y + v.z * row_z; }
};

/// Rotation of a unit quaternion, body to laboratory (the transpose of A, Bierwisch 2009, Eq. 2.13).
inline Rotation rotation_of(PlainQuaternion q) {
  const double x = 2 * q.x, y = 2 * q.y, z = 2 * q.z;
  const double wx = x * q.w, wy = y * q.w, wz = z * q.w;
  const double xx = x * q.x, xy = y * q.x, xz = z * q.x;
  const double yy = y * q.y, yz = z * q.y, zz = z * q.z;
  return {{1 - (yy + zz), xy - wz, xz + wy},
          {xy + wz, 1 - (xx + zz), yz - wx},
          {xz - wy, yz + wx, 1 - (xx + yy)}};
}

/// 1/2 q * (0, Omega): what the matrix Q / 2 of Eq. 2.19 does, with Omega in the body frame (rad/s).
inline PlainQuaternion quaternion_rate(PlainQuaternion q, Vector3 spin) {
  return 0.5 * PlainQuaternion{
                   -q.x * spin.x - q.y * spin.y - q.z * spin.z, q.w * spin.x + q.y * spin.z - q.z * spin.y,
                   q.w * spin.y + q.z * spin.x - q.x * spin.z, q.w * spin.z + q.x * spin.y - q.y * spin.x};
}

/// dOmega/dt from Euler's equations (Bierwisch 2009, Eq. 2.24); torque (N m) and spin (rad/s) in the body
/// frame.
inline Vector3 spin_rate(Vector3 inertia, Vector3 spin, Vector3 torque) {
  return {(torque.x + (inertia.y - inertia.z) * spin.y * spin.z) / inertia.x,
          (torque.y + (inertia.z - inertia.x) * spin.z * spin.x) / inertia.y,
          (torque.z + (inertia.x - inertia.y) * spin.x * spin.y) / inertia.z};
}

/// Orientation after `time_step` (s): second order, with the multiplier lambda that keeps |q| = 1 (Eqs. 2.20
/// to 2.23).
inline PlainQuaternion advance_orientation(PlainQuaternion q, Vector3 spin, Vector3 rate_of_spin,
                                           double time_step) {
  const PlainQuaternion first = quaternion_rate(q, spin);
  const double first_squared = dot(first, first);
  const PlainQuaternion second = quaternion_rate(q, rate_of_spin) - first_squared * q;
  const double t2 = time_step * time_step;
  const double shortening = first_squared * t2;
  const double correction = dot(first, second) * t2 * time_step +
                            0.25 * (dot(second, second) - first_squared * first_squared) * t2 * t2;
  // 1 - sqrt(1 - x) as x / (1 + sqrt(1 - x)): the plain form rounds alike in every step and lets |q| drift.
  const double under_root = 1 - shortening - correction;
  const double lambda_t2 = (shortening + correction) / (1 + std::sqrt(under_root)) - 0.5 * shortening;
  return q + time_step * first + (0.5 * t2) * second - lambda_t2 * q;
}

/// Spin after `time_step` by the trapezoidal rule of Euler's equations, three iterations (Eq. 2.25). Torques
/// at the start and the end of the step, body frame.
inline Vector3 advance_spin(Vector3 inertia, Vector3 spin, Vector3 torque_start, Vector3 torque_end,
                            double time_step) {
  const Vector3 rate_at_start = spin_rate(inertia, spin, torque_start);
  Vector3 next = spin;
  for (int iteration = 0; iteration < 3; ++iteration)
    next = spin + (0.5 * time_step) * (rate_at_start + spin_rate(inertia, next, torque_end));
  return next;
}

/// Rotation matrix, body to laboratory.
inline Eigen::Matrix3d rotation_matrix(const Quaternion& q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}
inline Quaternion quaternion_rate(const Quaternion& q, const Eigen::Vector3d& spin) {
  return eigen(quaternion_rate(plain(q), plain(spin)));
}
inline Eigen::Vector3d spin_rate(const Eigen::Vector3d& inertia, const Eigen::Vector3d& spin,
                                 const Eigen::Vector3d& torque) {
  return eigen(spin_rate(plain(inertia), plain(spin), plain(torque)));
}
inline Quaternion advance_orientation(const Quaternion& q, const Eigen::Vector3d& spin,
                                      const Eigen::Vector3d& rate_of_spin, double time_step) {
  return eigen(advance_orientation(plain(q), plain(spin), plain(rate_of_spin), time_step));
}
inline Eigen::Vector3d advance_spin(const Eigen::Vector3d& inertia, const Eigen::Vector3d& spin,
                                    const Eigen::Vector3d& torque_start, const Eigen::Vector3d& torque_end,
                                    double time_step) {
  return eigen(advance_spin(plain(inertia), plain(spin), plain(torque_start), plain(torque_end), time_step));
}

}  // namespace diefill::engine
