// Rotations exactly as printed in Bierwisch 2009, section 2.2.2, in the thesis' own order of quaternion
// components: a second, independent way to write what engine/powder/rigid_motion.h does.
#pragma once

#include <Eigen/Core>

#include "engine/powder/grains.h"

namespace diefill::engine {

/// (xi, eta, zeta, chi) of Eq. 2.12.
using ThesisQuaternion = Eigen::Vector4d;

inline ThesisQuaternion to_thesis(const Quaternion& q) {
  return {-q[2], q[1], q[3], q[0]};
}
inline Quaternion from_thesis(const ThesisQuaternion& q) {
  return {q[3], q[1], -q[0], q[2]};
}

/// A, laboratory to body components (Eq. 2.13).
inline Eigen::Matrix3d thesis_matrix(const ThesisQuaternion& q) {
  const double xi = q[0], eta = q[1], zeta = q[2], chi = q[3];
  Eigen::Matrix3d a;
  a << -xi * xi + eta * eta - zeta * zeta + chi * chi, 2 * (zeta * chi - xi * eta),
      2 * (eta * zeta + xi * chi),  //
      -2 * (xi * eta + zeta * chi), xi * xi - eta * eta - zeta * zeta + chi * chi,
      2 * (eta * chi - xi * zeta),  //
      2 * (eta * zeta - xi * chi), -2 * (xi * zeta + eta * chi),
      -xi * xi - eta * eta + zeta * zeta + chi * chi;
  return a;
}

/// Q of Eq. 2.19: dq/dt = Q Omega / 2.
inline Eigen::Matrix<double, 4, 3> thesis_rate_matrix(const ThesisQuaternion& q) {
  const double xi = q[0], eta = q[1], zeta = q[2], chi = q[3];
  Eigen::Matrix<double, 4, 3> rate;
  rate << -zeta, -chi, eta,  //
      chi, -zeta, -xi,       //
      xi, eta, chi,          //
      -eta, xi, -zeta;
  return rate;
}

}  // namespace diefill::engine
