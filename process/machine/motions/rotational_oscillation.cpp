#include "process/machine/motions/rotational_oscillation.h"

#include <numbers>

#include "process/machine/moving_tool.h"
#include "process/results/word_list.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kAmplitude = {Dimension::angle, "5 deg", "0 deg", "360 deg", true};

}  // namespace

ToolMotion RotationalOscillation::at(double time, const Envelope& envelope) const {
  return axis_.turned(oscillation_.value(time, envelope), oscillation_.rate(time, envelope));
}

std::string RotationalOscillation::description() const {
  return "rotational oscillation of " + results::and_list(tools()) + " at " +
         number_text(oscillation_.frequency) + " Hz, " +
         number_text(oscillation_.amplitude * 180 / std::numbers::pi) + " deg";
}

std::shared_ptr<Step> read_rotational_oscillation(TableReader& table, const std::vector<ToolSpec>& tools) {
  const auto moving = read_moving_tools(table, tools);
  const RotationAxis axis = read_rotation_axis(table);
  return std::make_shared<RotationalOscillation>(moving, axis, read_oscillation(table, kAmplitude));
}

}  // namespace diefill::process
