#include "process/results/moved_frame.h"

#include <Eigen/Geometry>
#include <utility>

namespace diefill::results {
namespace {

constexpr double kPoseTolerance = 1e-12;  // m and rad, rounding of a motion that comes back

/// Turns quaternions (w, x, y, z) from body to laboratory into those from body to the frame.
void turn_back(std::vector<Eigen::Vector4d>& orientations, const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond back(Eigen::Matrix3d(rotation.transpose()));
  for (auto& orientation : orientations) {
    const Eigen::Quaterniond turned =
        back * Eigen::Quaterniond(orientation[0], orientation[1], orientation[2], orientation[3]);
    orientation = {turned.w(), turned.x(), turned.y(), turned.z()};
  }
}

}  // namespace

bool MovedFrame::at_initial_pose() const {
  return translation_.norm() < kPoseTolerance &&
         (rotation_ - Eigen::Matrix3d::Identity()).norm() < kPoseTolerance;
}

double MovedFrame::turn() const {
  return Eigen::AngleAxisd(rotation_).angle();
}

PowderState MovedFrame::powder(PowderState laboratory) const {
  if (at_initial_pose()) return laboratory;
  for (auto& position : laboratory.position) position = point(position);
  for (auto& velocity : laboratory.velocity) velocity = direction(velocity);
  for (auto& spin : laboratory.angular_velocity) spin = direction(spin);
  turn_back(laboratory.orientation, rotation_);
  return laboratory;
}

Instant MovedFrame::powder(Instant laboratory) const {
  if (at_initial_pose()) return laboratory;
  for (auto& position : laboratory.position) position = point(position);
  for (auto& velocity : laboratory.velocity) velocity = direction(velocity);
  turn_back(laboratory.orientation, rotation_);
  return laboratory;
}

}  // namespace diefill::results
