// A frame that moves with a body, as the die's: positions and orientations as seen from it.
#pragma once

#include "process/results/fill_result.h"

namespace diefill::results {

/// The frame at one time. It coincides with the laboratory frame before the body moves.
class MovedFrame {
 public:
  /// The body's motion since then: it is turned about the laboratory's origin, then shifted by `translation`
  /// (m).
  MovedFrame(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation)
      : rotation_(rotation), translation_(translation) {}

  /// Whether the body is where it was, to 1e-12 m and rad.
  bool at_initial_pose() const;
  /// m, by which the laboratory's origin would have moved with the body, and rad, by which it is turned.
  double shift() const { return translation_.norm(); }
  double turn() const;
  const Eigen::Matrix3d& rotation() const { return rotation_; }

  Eigen::Vector3d point(const Eigen::Vector3d& laboratory) const {
    return rotation_.transpose() * (laboratory - translation_);
  }
  Eigen::Vector3d direction(const Eigen::Vector3d& laboratory) const {
    return rotation_.transpose() * laboratory;
  }
  /// A tensor of second order, such as a stress.
  Eigen::Matrix3d tensor(const Eigen::Matrix3d& laboratory) const {
    return rotation_.transpose() * laboratory * rotation_;
  }
  /// Powder with places, orientations and velocities (those of the laboratory, turned) in this frame. Powder
  /// of a frame at its initial pose stays the same to the last digit.
  PowderState powder(PowderState laboratory) const;
  /// The same for the powder of an instant; its tools stay.
  Instant powder(Instant laboratory) const;

 private:
  Eigen::Matrix3d rotation_;
  Eigen::Vector3d translation_;
};

}  // namespace diefill::results
