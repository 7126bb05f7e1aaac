#include "process/machine/motions/rotation.h"

#include <numbers>

#include "process/machine/motion_limits.h"
#include "process/machine/moving_tool.h"
#include "process/results/word_list.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kSpeed = {Dimension::angular_velocity, "60 rpm", motion_limits::kFastestTurnBack,
                                 motion_limits::kFastestTurn};
constexpr double kRamp = 0.1;  // s

}  // namespace

ToolMotion Rotation::at(double time, const Envelope& envelope) const {
  return axis_.turned(speed_ * envelope.integral(time), speed_ * envelope.value(time));
}

std::string Rotation::description() const {
  return "rotation of " + results::and_list(tools()) + " at " + number_text(speed_ * 30 / std::numbers::pi) +
         " rpm";
}

std::shared_ptr<Step> read_rotation(TableReader& table, const std::vector<ToolSpec>& tools) {
  const auto moving = read_moving_tools(table, tools);
  const RotationAxis axis = read_rotation_axis(table);
  const double speed = table.required_quantity("speed", kSpeed);
  if (speed == 0) table.reject("speed", "the speed must not be zero; give a speed such as \"60 rpm\"");
  return std::make_shared<Rotation>(moving, axis, speed, read_ramps(table, kRamp));
}

}  // namespace diefill::process
