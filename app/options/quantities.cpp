#include "app/options/quantities.h"

#include "process/input/scene_error.h"

namespace diefill::app {
namespace {

using process::Dimension;

/// `value` in the unit that people use for such a quantity.
std::string shown(double value, Dimension dimension) {
  constexpr double kMicrometresBelow = 1e-5;  // m
  if (dimension == Dimension::length && value > 0 && value < kMicrometresBelow)
    return process::number_text(1e6 * value) + " um";
  if (dimension == Dimension::length) return process::number_text(1e3 * value) + " mm";
  if (dimension == Dimension::mass) return process::number_text(1e3 * value) + " g";
  if (dimension == Dimension::density) return process::number_text(1e-3 * value) + " g/cm^3";
  if (dimension == Dimension::time) return process::number_text(value) + " s";
  return process::number_text(value) + " in SI units";
}

double parsed(const std::string& option, const std::string& text, Dimension dimension) {
  try {
    return process::parse_quantity(text, dimension);
  } catch (const process::UnitError& error) {
    throw process::SceneError(option + ": found \"" + text + "\": " + error.what());
  }
}

QuantityLimits widest_limits(Dimension dimension) {
  if (dimension == Dimension::density) return {0, 25e3, true, ""};  // kg/m^3, above osmium
  if (dimension == Dimension::mass) return {0, 1e3, true, ""};      // kg
  return {0, 1e3, true, ""};                                        // m, s
}

}  // namespace

double bounded_quantity(const std::string& option, const std::string& text, Dimension dimension,
                        const QuantityLimits& limits) {
  const double value = parsed(option, text, dimension);
  const bool enough = limits.above_least ? value > limits.least : value >= limits.least;
  if (enough && value <= limits.most) return value;
  const std::string most = shown(limits.most, dimension);
  const std::string range = !limits.above_least
                                ? shown(limits.least, dimension) + " to " + most
                                : "more than " + process::number_text(limits.least) + ", at most " + most;
  throw process::SceneError(option + ": found \"" + text + "\", allowed: " + range +
                            (limits.reason.empty() ? "" : " (" + limits.reason + ")"));
}

double positive_quantity(const std::string& option, const std::string& text, Dimension dimension) {
  return bounded_quantity(option, text, dimension, widest_limits(dimension));
}

double coordinate(const std::string& option, const std::string& text) {
  constexpr double kFarthest = 1e3;  // m
  return bounded_quantity(option, text, Dimension::length, {-kFarthest, kFarthest, false, ""});
}

}  // namespace diefill::app
