#include "render/style/ticks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>

namespace diefill::render {
namespace {

constexpr double kRoundingSlack = 1e-9;  // in steps: a limit that is a multiple up to rounding counts as one

// First and last multiple of `step` inside `range`, as counts of steps.
std::pair<long long, long long> multiples_inside(const Interval& range, double step) {
  return {std::llround(std::ceil(range.lower / step - kRoundingSlack)),
          std::llround(std::floor(range.upper / step + kRoundingSlack))};
}

Ticks ticks_of_step(const Interval& range, double step) {
  Ticks ticks;
  const auto [first, last] = multiples_inside(range, step);
  for (long long k = first; k <= last; ++k) {
    ticks.at.push_back(static_cast<double>(k) * step);
    ticks.labels.push_back(tick_label(ticks.at.back(), step));
  }
  return ticks;
}

/// Part of a full turn that ticks of degrees stand apart; on finer ranges that of nice_ticks.
double angle_step(const Interval& range, int most) {
  if (range.length() >= 60) {
    for (const double step : {15.0, 30.0, 45.0, 60.0, 90.0, 180.0}) {
      const auto [first, last] = multiples_inside(range, step);
      if (last - first + 1 <= most) return step;
    }
  }
  return nice_step(range, most);
}

Interval widened_to(const Interval& range, double step) {
  return {std::floor(range.lower / step + kRoundingSlack) * step,
          std::ceil(range.upper / step - kRoundingSlack) * step};
}

double percentile(const std::vector<double>& sorted, double fraction) {
  const double place = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

std::string power_of_ten(int exponent) {
  static constexpr std::array<const char*, 10> kRaised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += kRaised[static_cast<std::size_t>(digit - '0')];
  return text;
}

std::string decade_label(int mantissa, int exponent, bool in_full) {
  if (in_full) {
    const double value = mantissa * std::pow(10.0, exponent);
    return tick_label(value, std::pow(10.0, exponent));
  }
  return (mantissa == 1 ? "" : std::to_string(mantissa) + "·") + power_of_ten(exponent);
}

std::string written(double value, std::chars_format format, int decimals) {
  std::array<char, 64> text{};
  const auto result = std::to_chars(text.begin(), text.end(), value, format, decimals);
  return {text.data(), result.ptr};
}

// "1.5e-07" -> "1.5·10⁻⁷".
std::string typeset(const std::string& scientific) {
  const auto mark = scientific.find('e');
  return scientific.substr(0, mark) + "·" + power_of_ten(std::stoi(scientific.substr(mark + 1)));
}

}  // namespace

double nice_step(const Interval& range, int most) {
  const double length = std::max(range.length(), 1e-300);
  double power = std::pow(10.0, std::floor(std::log10(length / std::max(most, 2))));
  for (;; power *= 10) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const auto [first, last] = multiples_inside(range, factor * power);
      if (last - first + 1 <= std::max(most, 2)) return factor * power;
    }
  }
}

Ticks nice_ticks(const Interval& range, int most) {
  return ticks_of_step(range, nice_step(range, most));
}

Ticks angle_ticks(const Interval& range, int most) {
  return ticks_of_step(range, angle_step(range, most));
}

Interval widen_to_angles(const Interval& range, int most) {
  return widened_to(range, angle_step(range, most));
}

Ticks decade_ticks(const Interval& range) {
  Ticks ticks;
  const bool label_between = std::log10(range.upper / range.lower) < 2;
  const int first = static_cast<int>(std::floor(std::log10(range.lower) + kRoundingSlack));
  const int last = static_cast<int>(std::floor(std::log10(range.upper) + kRoundingSlack));
  const bool in_full = first >= -3 && last <= 4;
  for (int exponent = first; exponent <= last; ++exponent) {
    for (int mantissa = 1; mantissa <= 9; ++mantissa) {
      const double value = mantissa * std::pow(10.0, exponent);
      if (value < range.lower * (1 - kRoundingSlack) || value > range.upper * (1 + kRoundingSlack)) continue;
      const bool labelled = mantissa == 1 || (label_between && (mantissa == 2 || mantissa == 5));
      ticks.at.push_back(value);
      ticks.labels.push_back(labelled ? decade_label(mantissa, exponent, in_full) : "");
    }
  }
  return ticks;
}

Interval widen_to_nice(const Interval& range, int most) {
  return widened_to(range, nice_step(range, most));
}

Interval robust_range(std::span<const double> values, double least_relative_span) {
  std::vector<double> finite;
  std::copy_if(values.begin(), values.end(), std::back_inserter(finite),
               [](double v) { return std::isfinite(v); });
  if (finite.empty()) return {0, 1};
  std::sort(finite.begin(), finite.end());
  Interval range{percentile(finite, 0.02), percentile(finite, 0.98)};
  const double magnitude = std::max(std::abs(range.lower), std::abs(range.upper));
  const double least = magnitude > 0 ? least_relative_span * magnitude : 1.0;
  if (range.length() < least) {
    const double centre = 0.5 * (range.lower + range.upper);
    range = {centre - 0.5 * least, centre + 0.5 * least};
  }
  return widen_to_nice(range, 6);
}

std::string tick_label(double value, double step) {
  const double size = std::max(std::abs(value), step);
  const auto order = [](double number) {
    return static_cast<int>(std::floor(std::log10(number) + kRoundingSlack));
  };
  const bool is_zero = std::abs(value) < 1e-6 * step;
  if (is_zero && step < 1e-4) return "0";
  const std::string sign = value < 0 && !is_zero ? "−" : "";
  if (!is_zero && (size >= 1e6 || size < 1e-4))
    return sign + typeset(written(std::abs(value), std::chars_format::scientific, order(size) - order(step)));
  return sign + written(std::abs(value), std::chars_format::fixed, std::max(0, -order(step)));
}

}  // namespace diefill::render
