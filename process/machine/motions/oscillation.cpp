#include "process/machine/motions/oscillation.h"

#include <cmath>
#include <numbers>

namespace diefill::process {
namespace {

constexpr QuantityRule kFrequency = {Dimension::frequency, "32 Hz", "0 Hz", "10000 Hz", true};
constexpr QuantityRule kPhase = {Dimension::angle, "90 deg", "-360 deg", "360 deg"};

}  // namespace

double Oscillation::value(double time, const Envelope& envelope) const {
  return amplitude * envelope.value(time) * std::sin(2 * std::numbers::pi * frequency * time + phase);
}

double Oscillation::rate(double time, const Envelope& envelope) const {
  const double omega = 2 * std::numbers::pi * frequency, angle = omega * time + phase;
  return amplitude *
         (envelope.slope(time) * std::sin(angle) + envelope.value(time) * omega * std::cos(angle));
}

std::vector<double> Oscillation::turning_points(double length) const {
  const double half_period = 0.5 / frequency, quarter = 0.25 / frequency,
               offset = phase / (2 * std::numbers::pi * frequency);
  const double first =
      quarter - offset + half_period * std::ceil((ramps.ramp + offset - quarter) / half_period);
  std::vector<double> points;
  for (const double point : {first, first + half_period})
    if (point <= length - ramps.ramp) points.push_back(point);
  return points;
}

Oscillation read_oscillation(TableReader& table, const QuantityRule& rule) {
  Oscillation oscillation;
  oscillation.amplitude = table.required_quantity("amplitude", rule);
  oscillation.frequency = table.required_quantity("frequency", kFrequency);
  oscillation.phase = table.quantity("phase", kPhase).value_or(0);
  oscillation.ramps = read_ramps(table, 1 / oscillation.frequency);
  return oscillation;
}

}  // namespace diefill::process
