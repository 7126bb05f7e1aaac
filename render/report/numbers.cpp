#include "render/report/numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "process/results/figure_table.h"
#include "process/results/formatted.h"
#include "process/results/rounding.h"

namespace diefill::render::report {
namespace {

constexpr const char* kDash = "–";

/// Decimals that leave the largest value `digits` significant digits; none where all values are whole, and
/// where a value other than zero would be shown as zero.
std::optional<int> decimals_of_column(const std::vector<double>& values, int digits) {
  double largest = 0, smallest = std::numeric_limits<double>::infinity();
  bool whole = true;
  for (const double value : values) {
    if (!std::isfinite(value) || value == 0) continue;
    largest = std::max(largest, std::abs(value));
    smallest = std::min(smallest, std::abs(value));
    whole = whole && value == std::round(value);
  }
  if (whole) return std::nullopt;
  const int decimals = std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(largest))));
  if (smallest < 0.5 * std::pow(10, -decimals)) return std::nullopt;
  return decimals;
}

}  // namespace

std::string in_digits(double value, int digits) {
  if (!std::isfinite(value)) return kDash;
  // Whole numbers keep all their digits, or 87,041 spheres would become 87040.
  if (value != std::round(value) || std::abs(value) >= 1e12)
    return results::in_significant_digits(value, digits);
  return results::formatted("%.0f", value);
}

std::vector<std::string> in_one_format(const std::vector<double>& values, int digits) {
  const std::optional<int> decimals = decimals_of_column(values, digits);
  std::vector<std::string> texts;
  for (const double value : values)
    texts.push_back(decimals && std::isfinite(value) ? results::at_decimals(value, *decimals)
                                                     : in_digits(value, digits));
  return texts;
}

std::string with_unit(double value, const std::string& unit, int digits) {
  const std::string number = in_digits(value, digits);
  return number == kDash || unit.empty() ? number : number + " " + unit;
}

std::string with_unit_of(const std::string& name, const std::string& unit) {
  return unit == "1" || unit.empty() ? name : name + " [" + unit + "]";
}

std::string as_duration(double seconds) {
  if (!std::isfinite(seconds)) return kDash;
  char text[64];
  const long whole = std::lround(seconds);
  if (seconds < 60)
    std::snprintf(text, sizeof text, "%.3g s", seconds);
  else if (whole < 3600)
    std::snprintf(text, sizeof text, "%ld min %02ld s", whole / 60, whole % 60);
  else
    std::snprintf(text, sizeof text, "%ld h %02ld min", whole / 3600, whole % 3600 / 60);
  return text;
}

double figure(const results::FillResult& result, const std::string& name) {
  return results::figure_of(result, name);
}

Scatter scatter(const std::vector<double>& values) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  Scatter result{0, 0, 0};
  for (const double value : values)
    if (std::isfinite(value)) {
      result.mean += value;
      ++result.count;
    }
  if (result.count == 0) return {none, none, 0};
  result.mean /= result.count;
  for (const double value : values)
    if (std::isfinite(value)) result.deviation += std::pow(value - result.mean, 2);
  result.deviation = result.count > 1 ? std::sqrt(result.deviation / (result.count - 1)) : none;
  return result;
}

std::string as_text(const Scatter& scatter, int digits) {
  if (scatter.count < 2) return in_digits(scatter.mean, digits);
  return results::with_scatter(scatter.mean, scatter.deviation, digits);
}

std::vector<std::string> as_texts(const std::vector<Scatter>& scatters, int digits) {
  std::vector<std::string> texts = column_of(
      scatters,
      [](const Scatter& one) { return one.count < 2 ? one.mean : std::numeric_limits<double>::quiet_NaN(); },
      digits);
  for (std::size_t k = 0; k < scatters.size(); ++k)
    if (scatters[k].count > 1) texts[k] = as_text(scatters[k], digits);
  return texts;
}

void leave_out_empty_columns(Table& table) {
  for (std::size_t column = table.header.size(); column-- > 0;) {
    const bool empty =
        !table.rows.empty() && std::all_of(table.rows.begin(), table.rows.end(),
                                           [&](const auto& row) { return row[column] == kDash; });
    if (!empty) continue;
    const auto at = static_cast<std::ptrdiff_t>(column);
    table.header.erase(table.header.begin() + at);
    for (auto& row : table.rows) row.erase(row.begin() + at);
  }
}

}  // namespace diefill::render::report
