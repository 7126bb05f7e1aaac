#include "process/machine/rotational_oscillation.h"

#include <limits>
#include <numbers>

#include "process/machine/moving_tool.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kAmplitude = {Dimension::angle, "5 deg", "0 deg", "360 deg", true};
constexpr QuantityRule kThrough = {Dimension::length, "0 mm", "-10 m", "10 m"};
constexpr double kNever = std::numeric_limits<double>::infinity();

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

ToolMotion RotationalOscillation::at(double time, const Envelope& envelope) const {
  return axis_.turned(oscillation_.value(time, envelope), oscillation_.rate(time, envelope));
}

ToolMotion RotationalOscillation::motion(double time) const {
  return at(time, oscillation_.envelope(kNever));
}

double RotationalOscillation::stopping_time(double stop) const {
  return oscillation_.envelope(stop).end() - stop;
}

ToolMotion RotationalOscillation::motion_stopped(double time, double stop) const {
  return at(time, oscillation_.envelope(stop));
}

std::string RotationalOscillation::in_words() const {
  return "rotational oscillation of " + names_in_words(tools_) + " at " +
         number_in_words(oscillation_.frequency) + " Hz, " +
         number_in_words(oscillation_.amplitude * 180 / std::numbers::pi) + " deg";
}

std::shared_ptr<Step> read_rotational_oscillation(TableReader& table, const std::vector<ToolSpec>& tools) {
  const auto moving = read_moving_tools(table, tools);
  const RotationAxis axis = read_rotation_axis(table);
  Oscillation oscillation;
  oscillation.amplitude = table.required_quantity("amplitude", kAmplitude);
  read_oscillation(table, oscillation);
  return std::make_shared<RotationalOscillation>(moving, axis, oscillation);
}

}  // namespace diefill::process
