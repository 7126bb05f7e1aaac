#include "process/results/rounding.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace diefill::results {
namespace {

constexpr int kMaxDigits = 5;        // of a value whose scatter is far smaller
constexpr double kRounding = 1e-13;  // of sums, over their value

int exponent_of(double value) {
  return static_cast<int>(std::floor(std::log10(value)));
}

}  // namespace

bool is_rounding(double difference, double size) {
  constexpr double kOfSums = 1e-12;
  return std::abs(difference) <= kOfSums * std::abs(size);
}

int decimals_of_scatter(double scatter) {
  constexpr double kTwoDigitsBelow = 2.95;  // 2.96 would be printed as 3.0
  const int exponent = exponent_of(scatter);
  return (scatter / std::pow(10, exponent) < kTwoDigitsBelow ? 1 : 0) - exponent;
}

int decimals_of_scatter(double scatter, double value) {
  const int decimals = decimals_of_scatter(scatter);
  return value == 0 ? decimals : std::min(decimals, kMaxDigits - 1 - exponent_of(std::abs(value)));
}

std::string at_decimals(double value, int decimals) {
  char text[64];
  if (decimals < 0) {
    const double unit = std::pow(10, -decimals);
    value = std::round(value / unit) * unit;
  }
  std::snprintf(text, sizeof text, "%.*f", std::max(0, decimals), value);
  const std::string shown = text;
  return shown.find_first_not_of("-0.") == std::string::npos && shown[0] == '-' ? shown.substr(1) : shown;
}

std::string with_scatter(double value, double scatter, int digits) {
  if (!std::isfinite(value)) return {};
  if (!std::isfinite(scatter)) return in_significant_digits(value, digits);
  // Sums of the same numbers differ by their rounding.
  if (!(scatter > kRounding * std::abs(value))) return in_significant_digits(value, digits) + " ± 0";
  const int decimals = decimals_of_scatter(scatter, value);
  std::string shown = at_decimals(scatter, decimals);
  if (shown.find_first_not_of("0.") == std::string::npos) shown = in_significant_digits(scatter, 1);
  return at_decimals(value, decimals) + " ± " + shown;
}

std::string in_significant_digits(double value, int digits) {
  char text[64];
  const double size = std::abs(value);
  if (size >= std::pow(10, digits) && size < 1e9)
    std::snprintf(text, sizeof text, "%.0f", value);
  else
    std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string mass_text(double mass, int digits) {
  constexpr double kMilligramsBelow = 1e-4;  // kg
  return std::abs(mass) < kMilligramsBelow && mass != 0 ? in_significant_digits(1e6 * mass, digits) + " mg"
                                                        : in_significant_digits(1e3 * mass, digits) + " g";
}

std::string whole_percent(double share) {
  return at_decimals(100 * share, 0) + " %";
}

std::string unit_behind(const std::string& unit) {
  return unit == "1" || unit.empty() ? "" : ' ' + unit;
}

}  // namespace diefill::results
