#include "process/laboratory/published/lactose/design_study.h"

#include <algorithm>
#include <cmath>

#include "process/laboratory/published/published_figure.h"
#include "process/results/none.h"

namespace diefill::process::laboratory {

namespace {

/// Level lines over all runs at the least and the largest published value, with a gap between them.
results::ExperimentSeries published_range(const std::vector<PublishedFigure>& figures,
                                          const std::string& powder, const std::string& metric,
                                          std::size_t runs) {
  const auto level = [&](const char* end) {
    return std::stod(figure_called(figures, powder + "-range-" + end + "-" + metric).published);
  };
  const double least = level("min"), largest = level("max"), last = static_cast<double>(runs - 1);
  return {.name = "published, least and largest",
          .role = results::ExperimentSeries::Role::predicted,
          .x = {0, last, kNone, 0, last},
          .y = {least, least, kNone, largest, largest}};
}

results::ExperimentChart metric_chart(const DesignStudy& study, const NamedMetric& metric,
                                      const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = metric.name;
  chart.title = metric.name + " over the runs of the design";
  chart.subtitle = "One bed for each set of parameters";
  chart.x = {.label = "Run of the design"};
  chart.y = {.label = metric.name + " [" + metric.unit + "]", .lower = 0};
  results::ExperimentSeries series{
      .name = "here", .role = results::ExperimentSeries::Role::points, .x = {}, .y = {}};
  series.y = values_of(study, seed, metric.value);
  for (std::size_t k = 0; k < series.y.size(); ++k) series.x.push_back(static_cast<double>(k));
  chart.series.push_back(series);
  return chart;
}

}  // namespace

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
  for (const auto& [factor, sign] : signs) {
    const double effect = of(all, factor);
    if (!std::isfinite(effect)) return kNone;
    count += sign * effect > 0 ? 1 : 0;
  }
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

LabCharts study_charts(const DesignStudy& study, const std::filesystem::path& figures,
                       const std::string& powder) {
  const auto published = powder.empty() ? std::vector<PublishedFigure>{} : read_published_figures(figures);
  return [=](const SeedResults& seed) {
    std::vector<results::ExperimentChart> charts;
    if (!std::all_of(study.runs.begin(), study.runs.end(), [&](const auto& run) { return seed.has(run); }))
      return charts;
    for (const NamedMetric& metric : study.metrics) {
      charts.push_back(metric_chart(study, metric, seed));
      if (!powder.empty())
        charts.back().series.push_back(published_range(published, powder, metric.name, study.design.size()));
    }
    return charts;
  };
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
