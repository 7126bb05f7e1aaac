// The frame of the die: positions are transformed to where the scene places the die, wherever it has been
// moved.
#pragma once

#include "engine/walls/walls.h"
#include "process/results/fill_result.h"
#include "process/tooling/tooling.h"

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::process {

/// The cavity as results describe it; azimuth 0 is along x.
results::CavityState cavity_state(const geometry::Cavity& found);

/// The die's frame at one time.
class DieFrame {
 public:
  explicit DieFrame(const engine::BodyMotion& die) : die_(die) {}
  /// Whether the die is at its initial pose in the scene, to 1e-12 m and rad.
  bool at_initial_pose() const;
  /// m, offset of the die's own origin, and rad, by which it is turned.
  double shift() const { return die_.translation.norm(); }
  double turn() const { return Eigen::AngleAxisd(die_.rotation).angle(); }

  Eigen::Vector3d point(const Eigen::Vector3d& laboratory) const {
    return die_.rotation.transpose() * (laboratory - die_.translation);
  }
  Eigen::Vector3d direction(const Eigen::Vector3d& laboratory) const {
    return die_.rotation.transpose() * laboratory;
  }
  /// A tensor of second order, such as a stress.
  Eigen::Matrix3d tensor(const Eigen::Matrix3d& laboratory) const {
    return die_.rotation.transpose() * laboratory * die_.rotation;
  }
  /// A body as it stands in the die's frame; at rest.
  engine::BodyMotion pose(const engine::BodyMotion& body) const;
  /// Powder with places, orientations and velocities (those of the laboratory, turned) in the die's frame.
  results::PowderState powder(results::PowderState laboratory) const;

 private:
  engine::BodyMotion die_;
};

/// kg of powder whose grain centres lie in the cavity now.
double filled_mass(const engine::Simulation& simulation, const Tooling& tooling);

}  // namespace diefill::process
