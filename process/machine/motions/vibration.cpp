#include "process/machine/motions/vibration.h"

#include "process/machine/moving_tool.h"
#include "process/results/word_list.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kAmplitude = {Dimension::length, "1 mm", "0 mm", "0.1 m", true};

}  // namespace

ToolMotion Vibration::at(double time, const Envelope& envelope) const {
  ToolMotion motion;
  motion.translation = oscillation_.value(time, envelope) * axis_;
  motion.velocity = oscillation_.rate(time, envelope) * axis_;
  return motion;
}

std::string Vibration::description() const {
  return "vibration of " + results::and_list(tools()) + " at " + number_text(oscillation_.frequency) +
         " Hz, " + number_text(1e3 * oscillation_.amplitude) + " mm";
}

std::shared_ptr<Step> read_vibration(TableReader& table, const std::vector<ToolSpec>& tools) {
  const auto moving = read_moving_tools(table, tools);
  table.require("axis", "\"x\"");
  const Eigen::Vector3d axis = *table.direction("axis");
  return std::make_shared<Vibration>(moving, axis, read_oscillation(table, kAmplitude));
}

}  // namespace diefill::process
