// The state of the powder: structure-of-arrays over grains.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/numerics/transpose.h"
#include "engine/numerics/vector3.h"

namespace diefill::engine {

/// Unit quaternion (w, x, y, z), body to laboratory. In the thesis' order and sign (xi, eta, zeta, chi) of
/// Eq. 2.12 it is w = chi, x = eta, y = -xi, z = zeta.
using Quaternion = Eigen::Vector4d;

/// What a restart needs of every grain; entry k of every array belongs to one grain. The order follows space
/// and changes whenever contacts are searched anew; `id` stays with the grain.
struct Grains {
  std::vector<std::uint64_t> id;
  std::vector<std::uint16_t> kind;        ///< number of the particle type; empty where there is only one
  std::vector<Eigen::Vector3d> position;  ///< m, centre of mass, laboratory frame
  std::vector<Eigen::Vector3d> velocity;  ///< m/s
  std::vector<Quaternion> orientation;    ///< of clumped grains; empty for single spheres
  std::vector<Eigen::Vector3d> spin;      ///< rad/s, angular velocity in the body frame
  std::vector<Eigen::Vector3d> force;     ///< N, all forces at the present time, laboratory frame
  std::vector<Eigen::Vector3d> torque;    ///< N m, all torques at the present time, body frame

  std::size_t size() const { return id.size(); }
  /// `clumps`: several spheres per grain, which then have an orientation. `mixed`: there are several types.
  void resize(std::size_t count, bool clumps, bool mixed);
  std::uint16_t type_of(std::size_t k) const { return kind.empty() ? std::uint16_t{0} : kind[k]; }
  /// Of grain k: a single sphere's body frame is the laboratory's.
  Quaternion orientation_of(std::size_t k) const {
    return orientation.empty() ? Quaternion(1, 0, 0, 0) : orientation[k];
  }
  /// The same of all grains.
  std::vector<Quaternion> orientations() const;
  /// Entry k becomes the former entry order[k]; grains not named in `order` leave.
  void reorder(const std::vector<std::uint32_t>& order);
};

/// Sum of contact forces on a grain, laid out as a Record: forces and loads in its first half, moments in the
/// second, so that each is added to as a whole.
class ContactSum {
 public:
  /// Numbers that count where grains do not rotate, where they do, and where single spheres roll as well.
  static constexpr std::size_t kForce = 3, kMoment = 6, kRolling = 7;

  Vector3 force() const { return {value_[0], value_[1], value_[2]}; }  ///< N
  /// N m, laboratory frame: about the centre of a single sphere, about the block's reference point for
  /// clumped grains.
  Vector3 moment() const { return {value_[4], value_[5], value_[6]}; }
  /// N m, sum of mu_r |f_e + f_v| (model B).
  double rolling_load() const { return value_[3]; }
  /// Force and rolling load; moment and a number to spare.
  double* first_half() { return value_; }
  double* second_half() { return value_ + Record::kHalf; }
  const double* first_half() const { return value_; }
  const double* second_half() const { return value_ + Record::kHalf; }

  void add_force(Vector3 force) {
    value_[0] += force.x;
    value_[1] += force.y;
    value_[2] += force.z;
  }
  void add_moment(Vector3 moment) {
    value_[4] += moment.x;
    value_[5] += moment.y;
    value_[6] += moment.z;
  }
  void add_rolling_load(double load) { value_[3] += load; }
  ContactSum& operator+=(const ContactSum& other) {
    for (std::size_t k = 0; k < 8; ++k) value_[k] += other.value_[k];
    return *this;
  }

 private:
  alignas(64) double value_[2 * Record::kHalf] = {};
};

}  // namespace diefill::engine
