#include "process/compare/compared_fields.h"

#include <cmath>

#include "process/results/field_value.h"
#include "process/results/none.h"
#include "process/results/places_without_value.h"
#include "process/results/studies/correlation.h"

namespace diefill::process {
namespace {

/// Mean of the fields that have a value there, where at least half of them hold powder.
double mean_at(const std::vector<results::Field2D>& fields, double first, double second) {
  double sum = 0;
  std::size_t values = 0, unvalued = 0;
  for (const auto& field : fields) {
    const double value = results::value_at(field, first, second);
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
  for (std::size_t n = 0; n < first.value.size(); ++n) {
    const double other = results::value_at(second, first.first[n % columns], first.second[n / columns]);
    if (!std::isfinite(first.value[n]) || !std::isfinite(other)) continue;
    a.push_back(first.value[n]);
    b.push_back(other);
  }
  return results::pearson_correlation(a, b);
}

}  // namespace diefill::process
