#include "process/machine/vibration.h"

#include <cmath>
#include <numbers>

#include "process/machine/moving_tool.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kAmplitude = {Dimension::length, "1 mm", "0 mm", "0.1 m", true};
constexpr QuantityRule kFrequency = {Dimension::frequency, "32 Hz", "0 Hz", "10000 Hz", true};
constexpr QuantityRule kPhase = {Dimension::angle, "90 deg", "-360 deg", "360 deg"};
constexpr QuantityRule kRamp = {Dimension::time, "30 ms", "0 s", "100 s", true};
constexpr QuantityRule kDuration = {Dimension::time, "1 s", "0 s", "1000 s", true};

constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

Envelope Oscillation::envelope(double stop) const {
  return Envelope(ramp, std::min(duration.value_or(kNever), stop + ramp));
}

double Oscillation::value(double time, const Envelope& envelope) const {
  return amplitude * envelope.value(time) * std::sin(2 * std::numbers::pi * frequency * time + phase);
}

double Oscillation::rate(double time, const Envelope& envelope) const {
  const double omega = 2 * std::numbers::pi * frequency, angle = omega * time + phase;
  return amplitude *
         (envelope.slope(time) * std::sin(angle) + envelope.value(time) * omega * std::cos(angle));
}

void read_oscillation(TableReader& table, Oscillation& oscillation) {
  oscillation.frequency = table.required_quantity("frequency", kFrequency);
  oscillation.phase = table.quantity("phase", kPhase).value_or(0);
  oscillation.ramp = table.quantity("ramp", kRamp).value_or(1 / oscillation.frequency);
  oscillation.duration = table.quantity("duration", kDuration);
  if (oscillation.duration && *oscillation.duration < 2 * oscillation.ramp)
    table.reject("duration", "swelling and dying away alone take " + number_in_words(2 * oscillation.ramp) +
                                 " s; give a longer duration or a shorter ramp");
}

ToolMotion Vibration::at(double time, const Envelope& envelope) const {
  ToolMotion motion;
  motion.translation = oscillation_.value(time, envelope) * axis_;
  motion.velocity = oscillation_.rate(time, envelope) * axis_;
  return motion;
}

ToolMotion Vibration::motion(double time) const {
  return at(time, oscillation_.envelope(kNever));
}

double Vibration::stopping_time(double stop) const {
  return oscillation_.envelope(stop).end() - stop;
}

ToolMotion Vibration::motion_stopped(double time, double stop) const {
  return at(time, oscillation_.envelope(stop));
}

std::string Vibration::in_words() const {
  return "vibration of " + names_in_words(tools_) + " at " + number_in_words(oscillation_.frequency) +
         " Hz, " + number_in_words(1e3 * oscillation_.amplitude) + " mm";
}

std::shared_ptr<Step> read_vibration(TableReader& table, const std::vector<ToolSpec>& tools) {
  const auto moving = read_moving_tools(table, tools);
  table.require("axis", "\"x\"");
  const Eigen::Vector3d axis = *table.direction("axis");
  Oscillation oscillation;
  oscillation.amplitude = table.required_quantity("amplitude", kAmplitude);
  read_oscillation(table, oscillation);
  return std::make_shared<Vibration>(moving, axis, oscillation);
}

}  // namespace diefill::process
