#include "process/machine/rotation_axis.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kThrough = {Dimension::length, "0 mm", "-10 m", "10 m"};

}  // namespace

ToolMotion RotationAxis::turned(double angle, double rate) const {
  ToolMotion motion;
  motion.pivot = through;
  motion.rotation = Eigen::AngleAxisd(angle, direction).toRotationMatrix();
  motion.angular_velocity = rate * direction;
  return motion;
}

RotationAxis read_rotation_axis(TableReader& table) {
  RotationAxis axis;
  axis.direction = table.direction("axis").value_or(axis.direction);
  axis.through = table.point("through", kThrough).value_or(axis.through);
  return axis;
}

}  // namespace diefill::process
