#include "process/laboratory/published/lactose/design_study.h"

#include <algorithm>
#include <cmath>

namespace diefill::process::laboratory {

std::vector<double> values_of(const DesignStudy& study, const SeedResults& seed, const DesignMetric& metric) {
  std::vector<double> values;
  for (std::size_t bed = 0; bed < study.design.size(); ++bed) values.push_back(metric(seed, bed));
  return values;
}

Effects effects_of(const DesignStudy& study, const SeedResults& seed, const DesignMetric& metric) {
  const auto values = values_of(study, seed, metric);
  Effects all{};
  for (std::size_t k = 0; k < kFactors; ++k) all[k] = effect_of(study.design, values, static_cast<Factor>(k));
  return all;
}

double of(const Effects& all, Factor factor) {
  return all[static_cast<std::size_t>(factor)];
}

double largest_other(const Effects& all, const std::vector<Factor>& but) {
  double largest = 0;
  for (std::size_t k = 0; k < kFactors; ++k)
    if (std::find(but.begin(), but.end(), static_cast<Factor>(k)) == but.end())
      largest = std::max(largest, std::abs(all[k]));
  return largest;
}

double agreeing(const Effects& all, const std::vector<SignedFactor>& signs) {
  double count = 0;
  for (const auto& [factor, sign] : signs) count += sign * of(all, factor) > 0 ? 1 : 0;
  return count / static_cast<double>(signs.size());
}

LabQuantity study_quantity(const DesignStudy& study, const std::string& id,
                           const std::function<double(const SeedResults&)>& value) {
  return {.id = id, .quantity = "", .unit = "", .runs = study.runs, .value = value};
}

void add_ranges(LabPlan& plan, const DesignStudy& study, const std::string& powder) {
  for (const NamedMetric& metric : study.metrics)
    for (const bool most : {false, true})
      plan.quantities.push_back(study_quantity(
          study, powder + "-range-" + (most ? "max-" : "min-") + metric.name, [=](const SeedResults& seed) {
            const auto values = values_of(study, seed, metric.value);
            return most ? *std::max_element(values.begin(), values.end())
                        : *std::min_element(values.begin(), values.end());
          }));
}

void add_errors(LabPlan& plan, const DesignStudy& study, const std::string& table) {
  for (const bool pairs : {false, true})
    for (const NamedMetric& metric : study.metrics)
      plan.quantities.push_back(study_quantity(
          study, "ERR-" + table + (pairs ? "-with-" : "-no-") + metric.name, [=](const SeedResults& seed) {
            return regression_error(study.design, values_of(study, seed, metric.value), pairs);
          }));
}

}  // namespace diefill::process::laboratory
