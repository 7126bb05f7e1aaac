// A straight line that tools turn about.
#pragma once

#include "process/input/table_reader.h"
#include "process/machine/step.h"

namespace diefill::process {

/// `through` in m, laboratory frame.
struct RotationAxis {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(), through = Eigen::Vector3d::Zero();

  /// The motion turned by `angle` (rad, right-handed) and turning at `rate` (rad/s).
  ToolMotion turned(double angle, double rate) const;
};

/// Reads `axis` (z unless given) and `through` (the origin unless given).
RotationAxis read_rotation_axis(TableReader& table);

}  // namespace diefill::process
