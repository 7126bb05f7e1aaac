#include "process/machine/rotation.h"

#include <limits>
#include <numbers>

#include "process/machine/moving_tool.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kSpeed = {Dimension::angular_velocity, "60 rpm", "-60000 rpm", "60000 rpm"};
constexpr QuantityRule kRamp = {Dimension::time, "0.1 s", "0 s", "100 s", true};
constexpr QuantityRule kDuration = {Dimension::time, "2 s", "0 s", "1000 s", true};
constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

Envelope Rotation::envelope(double stop) const {
  return Envelope(spec_.ramp, std::min(spec_.duration.value_or(kNever), stop + spec_.ramp));
}

ToolMotion Rotation::motion_stopped(double time, double stop) const {
  const Envelope shape = envelope(stop);
  return spec_.axis.turned(spec_.speed * shape.integral(time), spec_.speed * shape.value(time));
}

ToolMotion Rotation::motion(double time) const {
  return motion_stopped(time, kNever);
}

double Rotation::stopping_time(double stop) const {
  return envelope(stop).end() - stop;
}

std::string Rotation::in_words() const {
  return "rotation of " + names_in_words(spec_.tools) + " at " +
         number_in_words(spec_.speed * 30 / std::numbers::pi) + " rpm";
}

std::shared_ptr<Step> read_rotation(TableReader& table, const std::vector<ToolSpec>& tools) {
  RotationSpec spec;
  spec.tools = read_moving_tools(table, tools);
  spec.axis = read_rotation_axis(table);
  spec.speed = table.required_quantity("speed", kSpeed);
  if (spec.speed == 0) table.reject("speed", "a rotation must turn; give a speed such as \"60 rpm\"");
  spec.ramp = table.quantity("ramp", kRamp).value_or(spec.ramp);
  spec.duration = table.quantity("duration", kDuration);
  if (spec.duration && *spec.duration < 2 * spec.ramp)
    table.reject("duration", "starting and stopping alone take " + number_in_words(2 * spec.ramp) +
                                 " s; give a longer duration or a shorter ramp");
  return std::make_shared<Rotation>(std::move(spec));
}

}  // namespace diefill::process
