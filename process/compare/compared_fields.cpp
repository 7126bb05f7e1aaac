#include "process/compare/compared_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "process/results/places_without_value.h"

namespace diefill::process {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Where `value` lies among rising nodes: the node at or below it and the share of the way to the next one.
std::pair<std::size_t, double> place_among(const std::vector<double>& nodes, double value) {
  const auto above = std::upper_bound(nodes.begin(), nodes.end(), value);
  const auto below = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - nodes.begin(), 1) - 1);
  if (below + 1 >= nodes.size()) return {below, value == nodes.back() ? 0 : kNone};
  return {below, value < nodes.front() ? kNone : (value - nodes[below]) / (nodes[below + 1] - nodes[below])};
}

/// Bilinear between the nodes; NaN beyond them and beside nodes without a value, unvalued_powder() where one
/// of those holds powder and the others are no holes.
double value_at(const results::Field2D& field, double first, double second) {
  if (field.value.empty()) return kNone;
  const auto [i, right] = place_among(field.first, first);
  const auto [j, up] = place_among(field.second, second);
  if (std::isnan(right) || std::isnan(up)) return kNone;
  const double weights[2][2] = {{(1 - up) * (1 - right), (1 - up) * right}, {up * (1 - right), up * right}};
  double sum = 0;
  bool unvalued = false;
  for (std::size_t b = 0; b < 2; ++b)
    for (std::size_t a = 0; a < 2; ++a) {
      if (!(weights[b][a] > 0)) continue;
      const double value = field.value[(j + b) * field.first.size() + i + a];
      if (results::is_unvalued_powder(value))
        unvalued = true;
      else
        sum += weights[b][a] * value;
    }
  return unvalued && !std::isnan(sum) ? results::unvalued_powder() : sum;
}

/// Mean of the fields that have a value there, where at least half of them hold powder.
double mean_at(const std::vector<results::Field2D>& fields, double first, double second) {
  double sum = 0;
  std::size_t values = 0, unvalued = 0;
  for (const auto& field : fields) {
    const double value = value_at(field, first, second);
    unvalued += results::is_unvalued_powder(value);
    if (!std::isfinite(value)) continue;
    sum += value;
    ++values;
  }
  if (2 * (values + unvalued) < fields.size() || values + unvalued == 0) return kNone;
  return values > 0 ? sum / static_cast<double>(values) : results::unvalued_powder();
}

}  // namespace

const results::Field2D* compared_field(const results::FillResult& result) {
  if (!result.maps.empty()) return &result.maps.front();
  if (!result.sections.empty()) return &result.sections.front().field;
  return nullptr;
}

results::Field2D mean_field(const std::vector<results::Field2D>& fields) {
  if (fields.empty()) return {};
  results::Field2D mean = fields.front();
  const std::size_t columns = mean.first.size();
  for (std::size_t n = 0; n < mean.value.size(); ++n)
    mean.value[n] = mean_at(fields, mean.first[n % columns], mean.second[n / columns]);
  return mean;
}

double correlation(const results::Field2D& first, const results::Field2D& second) {
  std::vector<double> a, b;
  const std::size_t columns = first.first.size();
  double mean_a = 0, mean_b = 0;
  for (std::size_t n = 0; n < first.value.size(); ++n) {
    const double other = value_at(second, first.first[n % columns], first.second[n / columns]);
    if (!std::isfinite(first.value[n]) || !std::isfinite(other)) continue;
    a.push_back(first.value[n]);
    b.push_back(other);
    mean_a += a.back();
    mean_b += other;
  }
  if (a.size() < 3) return kNone;
  mean_a /= static_cast<double>(a.size());
  mean_b /= static_cast<double>(a.size());
  double product = 0, square_a = 0, square_b = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    product += (a[n] - mean_a) * (b[n] - mean_b);
    square_a += (a[n] - mean_a) * (a[n] - mean_a);
    square_b += (b[n] - mean_b) * (b[n] - mean_b);
  }
  return square_a > 0 && square_b > 0 ? product / std::sqrt(square_a * square_b) : kNone;
}

}  // namespace diefill::process
