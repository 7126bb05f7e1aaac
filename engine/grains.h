// The state of the powder: structure-of-arrays over grains.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/vector3.h"

namespace diefill::engine {

/// Unit quaternion (w, x, y, z), body to laboratory. In the thesis' order and sign (xi, eta, zeta, chi) of
/// Eq. 2.12 it is w = chi, x = eta, y = -xi, z = zeta.
using Quaternion = Eigen::Vector4d;

/// What a restart needs of every grain; entry k of every array belongs to one grain. The order follows space
/// and changes whenever contacts are searched anew; `id` stays with the grain.
struct Grains {
  std::vector<std::uint64_t> id;
  std::vector<Eigen::Vector3d> position;  ///< m, centre of mass, laboratory frame
  std::vector<Eigen::Vector3d> velocity;  ///< m/s
  std::vector<Quaternion> orientation;
  std::vector<Eigen::Vector3d> spin;    ///< rad/s, angular velocity in the body frame
  std::vector<Eigen::Vector3d> force;   ///< N, all forces at the present time, laboratory frame
  std::vector<Eigen::Vector3d> torque;  ///< N m, all torques at the present time, body frame

  std::size_t size() const { return id.size(); }
  void resize(std::size_t count);
  /// Entry k becomes the former entry order[k]; grains not named in `order` leave.
  void reorder(const std::vector<std::uint32_t>& order);
};

/// Sum of contact forces on a grain.
struct ContactSum {
  Vector3 force;  ///< N
  /// N m, laboratory frame: about the centre of a single sphere, about the block's reference point for
  /// composed grains.
  Vector3 moment;
  double rolling_load = 0;  ///< N m, sum of mu_r |f_e + f_v| (model B)

  ContactSum& operator+=(const ContactSum& other) {
    force += other.force;
    moment += other.moment;
    rolling_load += other.rolling_load;
    return *this;
  }
};

}  // namespace diefill::engine
