#include "process/measure/figures/variation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "process/results/none.h"

namespace diefill::process {
namespace {

struct MeanAndSpread {
  double mean = kNone, spread = kNone;
  std::size_t count = 0;
};

MeanAndSpread of_values(const std::vector<double>& values) {
  MeanAndSpread found;
  double sum = 0, squares = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    sum += value;
    ++found.count;
  }
  if (found.count == 0) return found;
  found.mean = sum / static_cast<double>(found.count);
  for (const double value : values)
    if (std::isfinite(value)) squares += (value - found.mean) * (value - found.mean);
  found.spread = std::sqrt(squares / static_cast<double>(found.count));
  return found;
}

/// Columns that stand for places of their own: of a closed turn the last is the first again.
std::size_t own_columns(const results::Field2D& map) {
  const bool closed = map.first_name == "azimuth" && map.first.size() > 1 &&
                      map.first.back() - map.first.front() > 360 - 1e-9;
  return map.first.size() - (closed ? 1 : 0);
}

void add(results::SpreadProfile& profile, double place, const MeanAndSpread& value) {
  profile.mean.x.push_back(place);
  profile.mean.y.push_back(value.mean);
  profile.spread.push_back(value.spread);
}

std::optional<std::size_t> index_of(const std::vector<double>& nodes, double place) {
  constexpr double kSame = 1e-6;
  const auto found = std::lower_bound(nodes.begin(), nodes.end(), place - kSame);
  if (found == nodes.end() || *found > place + kSame) return std::nullopt;
  return static_cast<std::size_t>(found - nodes.begin());
}

}  // namespace

results::SpreadProfile profile_over_height(const results::Field2D& map) {
  results::SpreadProfile profile{{map.quantity, "1", map.second_name, map.second_unit, {}, {}}, {}};
  for (std::size_t j = 0; j < map.second.size(); ++j) {
    const auto row = map.value.begin() + static_cast<std::ptrdiff_t>(j * map.first.size());
    add(profile, map.second[j], of_values({row, row + static_cast<std::ptrdiff_t>(own_columns(map))}));
  }
  return profile;
}

results::SpreadProfile profile_over_azimuth(const results::Field2D& map) {
  results::SpreadProfile profile{{map.quantity, "1", map.first_name, map.first_unit, {}, {}}, {}};
  for (std::size_t i = 0; i < map.first.size(); ++i) {
    std::vector<double> column;
    for (std::size_t j = 0; j < map.second.size(); ++j) column.push_back(map.value[j * map.first.size() + i]);
    add(profile, map.first[i], of_values(column));
  }
  return profile;
}

results::Field2D difference(const results::Field2D& before, const results::Field2D& after) {
  if (before.first_name != after.first_name || before.second_name != after.second_name)
    throw std::invalid_argument("maps over " + before.first_name + " and " + before.second_name +
                                " cannot be compared with maps over " + after.first_name + " and " +
                                after.second_name);
  results::Field2D change = before;
  change.quantity = std::string("change of ") + before.quantity;
  bool common = false;
  for (std::size_t j = 0; j < before.second.size(); ++j)
    for (std::size_t i = 0; i < before.first.size(); ++i) {
      double& value = change.value[j * before.first.size() + i];
      const auto column = index_of(after.first, before.first[i]);
      const auto row = index_of(after.second, before.second[j]);
      const bool both = column && row;
      value = both ? after.value[*row * after.first.size() + *column] - value : kNone;
      common |= both;
    }
  if (!common) throw std::invalid_argument("the two maps have no common grid point");
  return change;
}

results::Histogram histogram(const std::string& quantity, const std::string& unit,
                             const std::vector<double>& values, double width) {
  results::Histogram counts{quantity, unit, {}, {}, 0, 0, 0};
  const MeanAndSpread all = of_values(values);
  counts.grains = all.count;
  counts.mean = all.mean;
  counts.std = all.spread;
  if (all.count == 0) return counts;
  double lowest = std::numeric_limits<double>::max(), highest = std::numeric_limits<double>::lowest();
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  const double first = std::floor(lowest / width);
  const auto bins = static_cast<std::size_t>(std::floor(highest / width) - first) + 1;
  for (std::size_t n = 0; n < bins; ++n)
    counts.middle.push_back((first + static_cast<double>(n) + 0.5) * width);
  counts.share.assign(bins, 0.0);
  for (const double value : values)
    if (std::isfinite(value))
      counts.share[static_cast<std::size_t>(std::floor(value / width) - first)] +=
          1.0 / static_cast<double>(all.count);
  return counts;
}

std::vector<double> counted_fractions(const results::GrainSolidFraction& fraction) {
  const bool any = std::any_of(fraction.in_cavity.begin(), fraction.in_cavity.end(),
                               [](std::uint8_t inside) { return inside != 0; });
  std::vector<double> values;
  for (std::size_t k = 0; k < fraction.solid_fraction.size(); ++k)
    if (fraction.open[k] == 0 && (!any || fraction.in_cavity[k] != 0))
      values.push_back(fraction.solid_fraction[k]);
  return values;
}

}  // namespace diefill::process
