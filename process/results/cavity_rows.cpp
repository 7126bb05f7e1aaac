#include "process/results/cavity_rows.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "process/results/no_value.h"
#include "process/results/rounding.h"

namespace diefill::results {
namespace {

CavityRow row_of(const FillResult& result, const CavityState& cavity, int number) {
  const std::string prefix = figure_prefix(number);
  const auto value = [&](const std::string& name) {
    const auto found = result.figures.find(prefix + name);
    return found == result.figures.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
  };
  CavityRow row;
  row.number = number;
  row.place = 0.5 * (cavity.lower_corner + cavity.upper_corner).head<2>();
  row.volume = cavity.volume;
  row.mass = value("expected_mass_kg");
  const auto guess = result.figures.find("apparent_density_is_estimate");
  row.estimate = guess != result.figures.end() && guess->second > 0;
  if (!std::isfinite(row.mass)) {
    row.mass = value("estimated_mass_kg");
    row.estimate = true;
  }
  row.full_mass = value("full_die_mass_kg");
  row.fill_ratio = value("fill_ratio");
  row.fill_height = 1e-3 * value("fill_height_mm");
  row.depth = cavity.upper_corner.z() - cavity.lower_corner.z();
  row.solid_fraction = number == 1 ? result.summary.mean : value("solid_fraction");
  row.std = number == 1 ? result.summary.std : value("solid_fraction_std");
  const double counted = value("solid_fraction_grains");
  row.grains =
      number == 1 ? result.summary.grains : static_cast<std::uint64_t>(std::isfinite(counted) ? counted : 0);
  row.verdict = statement(result, kVerdictTopic, verdict_name(number));
  return row;
}

}  // namespace

std::vector<CavityRow> cavity_rows(const FillResult& result) {
  std::vector<CavityRow> rows;
  if (!(result.cavity.volume > 0)) return rows;
  rows.push_back(row_of(result, result.cavity, 1));
  for (std::size_t n = 0; n < result.other_cavities.size(); ++n)
    rows.push_back(row_of(result, result.other_cavities[n], static_cast<int>(n) + 2));
  return rows;
}

std::string figure_prefix(int number) {
  return number == 1 ? std::string() : "cavity_" + std::to_string(number) + "_";
}

std::string verdict_name(int number) {
  return "cavity " + std::to_string(number);
}

std::string quantity_in_cavity(const std::string& quantity, int number) {
  return number > 1 ? quantity + ", " + verdict_name(number) : quantity;
}

std::pair<std::string, int> quantity_and_cavity(const std::string& quantity) {
  const std::string mark = ", cavity ";
  const auto at = quantity.rfind(mark);
  int number = 0;
  if (at != std::string::npos) {
    const char* const end = quantity.data() + quantity.size();
    const auto read = std::from_chars(quantity.data() + at + mark.size(), end, number);
    if (read.ptr == end && number > 1) return {quantity.substr(0, at), number};
  }
  return {quantity, 1};
}

std::string mass_of(const CavityRow& row) {
  if (!std::isfinite(row.mass)) return {};
  return row.estimate ? "about " + mass_text(row.mass, 2) : mass_text(row.mass);
}

}  // namespace diefill::results
