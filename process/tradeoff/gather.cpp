#include "process/tradeoff/gather.h"

#include <algorithm>
#include <cmath>

#include "process/compare/compared_fields.h"
#include "process/compare/job_folder.h"
#include "process/compare/statistics.h"
#include "process/results/none.h"
#include "process/results/storage/result_file.h"
#include "process/results/studies/job_cost.h"
#include "process/results/studies/mean.h"
#include "process/tradeoff/quantities.h"

namespace diefill::process {
namespace {

results::TradeoffValue value_over(const std::vector<double>& runs) {
  const Sample sample = sample_of(runs);
  return {sample.mean, sample.scatter, sample.count, kNone};
}

/// The runs of one setting.
struct Runs {
  std::vector<std::vector<double>> values;  ///< quantity by quantity, run by run
  std::vector<double> core_seconds, core_seconds_per_second, wall_seconds, peak_memory;
  std::string failure;
};

void add_run(Runs& runs, const std::vector<MeasuredQuantity>& quantities, const results::JobCost& cost,
             const results::FillResult& result) {
  for (std::size_t q = 0; q < quantities.size(); ++q) runs.values[q].push_back(quantities[q].value(result));
  runs.core_seconds.push_back(cost.cpu_seconds);
  runs.core_seconds_per_second.push_back(cost.cpu_seconds / result.figures.at("simulated_s"));
  runs.wall_seconds.push_back(cost.wall_seconds);
  runs.peak_memory.push_back(cost.peak_memory_bytes);
}

Runs read_runs(const std::filesystem::path& directory, const TriedSetting& setting, int seeds,
               const std::vector<MeasuredQuantity>& quantities) {
  Runs runs;
  runs.values.resize(quantities.size());
  for (const results::Job& job : jobs_of(setting, seeds)) {
    const JobState state = state_of(directory, job);
    if (state.stage == JobState::Stage::failed) runs.failure = state.reason;
    if (state.stage != JobState::Stage::finished) continue;
    try {
      add_run(runs, quantities, results::read_job_cost(directory / job.folder),
              results::read_results(directory / job.folder));
    } catch (const results::ResultError& damaged) {
      runs.failure = damaged.what();
    }
  }
  return runs;
}

std::string state_text(const TriedSetting& setting, const Runs& runs) {
  if (!runs.core_seconds.empty()) return "finished";
  if (!setting.refused.empty()) return "refused";
  return runs.failure.empty() ? "left out" : "failed";
}

results::TradeoffPoint point_of(const TriedSetting& setting, const Runs& runs) {
  results::TradeoffPoint point;
  point.name = setting.name;
  point.label = setting.label;
  point.changes = setting.changes;
  point.seeds = runs.core_seconds.size();
  point.core_seconds = results::mean_of_finite(runs.core_seconds);
  point.core_seconds_per_second = results::mean_of_finite(runs.core_seconds_per_second);
  point.wall_seconds = results::mean_of_finite(runs.wall_seconds);
  point.peak_memory_bytes =
      runs.peak_memory.empty() ? kNone : *std::max_element(runs.peak_memory.begin(), runs.peak_memory.end());
  for (const auto& values : runs.values) point.values.push_back(value_over(values));
  point.error = kNone;
  point.reason = setting.refused.empty() ? runs.failure : setting.refused;
  point.state = state_text(setting, runs);
  return point;
}

/// Quantities that no run has a value of.
void drop_missing(results::Tradeoff& tradeoff) {
  for (std::size_t q = tradeoff.quantities.size(); q-- > 0;) {
    const auto has = [q](const results::TradeoffPoint& point) { return point.values[q].seeds > 0; };
    if (std::any_of(tradeoff.points.begin(), tradeoff.points.end(), has)) continue;
    const auto place = static_cast<std::ptrdiff_t>(q);
    tradeoff.quantities.erase(tradeoff.quantities.begin() + place);
    for (auto& point : tradeoff.points) point.values.erase(point.values.begin() + place);
  }
}

/// Whether `a` comes before `b` in a chart of the parameter: coarser first, else smaller first.
bool before(const Parameter& parameter, const std::string& a, const std::string& b) {
  if (const int order = fineness(parameter, a, b); order != 0) return order < 0;
  const auto first = number_of(parameter, a), second = number_of(parameter, b);
  return first && second && *first < *second;
}

results::ParameterRow row_of(const ParameterValues& varied, const Scene& scene,
                             const std::vector<TriedSetting>& settings) {
  struct Entry {
    std::size_t point;
    std::string value;
  };
  std::vector<Entry> entries = {{0, varied.parameter.current(scene)}};
  for (std::size_t k = 1; k < settings.size(); ++k)
    if (settings[k].changes.size() == 1 && settings[k].changes.front().parameter == varied.parameter.name)
      entries.push_back({k, settings[k].changes.front().value});
  std::stable_sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    return before(varied.parameter, a.value, b.value);
  });
  results::ParameterRow row{varied.parameter.name, varied.parameter.label, {}, {}};
  for (const Entry& entry : entries) {
    row.points.push_back(entry.point);
    row.values.push_back(entry.value);
  }
  return row;
}

/// Maps of the finished runs.
std::vector<results::Field2D> fields_of(const std::filesystem::path& directory, const TriedSetting& setting,
                                        int seeds) {
  std::vector<results::Field2D> fields;
  for (const results::Job& job : jobs_of(setting, seeds)) {
    if (state_of(directory, job).stage != JobState::Stage::finished) continue;
    try {
      const auto result = results::read_results(directory / job.folder);
      if (const auto* field = compared_field(result)) fields.push_back(*field);
    } catch (const results::ResultError&) {
      continue;  // reported by read_runs
    }
  }
  return fields;
}

/// Correlations of runs with the mean of `reference`; with that of the other runs where they are the
/// reference's own.
std::vector<double> correlations(const std::vector<results::Field2D>& runs,
                                 const std::vector<results::Field2D>& reference, bool own) {
  std::vector<double> values;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    auto others = reference;
    if (own) others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    values.push_back(others.empty() ? kNone : correlation(mean_field(others), runs[k]));
  }
  return values;
}

}  // namespace

std::vector<results::Job> jobs_of(const TriedSetting& setting, int seeds) {
  std::vector<results::Job> jobs;
  for (int k = 0; setting.refused.empty() && k < seeds; ++k) jobs.push_back(job_of(setting.variant, k));
  return jobs;
}

results::Tradeoff gather(const std::filesystem::path& directory, const Scene& scene,
                         const std::vector<TriedSetting>& settings,
                         const std::vector<ParameterValues>& parameters, int seeds) {
  results::Tradeoff tradeoff;
  tradeoff.title = scene.title;
  for (const TriedSetting& setting : settings) {
    // Masses of a slice are per length, which the setting may have changed.
    const auto quantities = measured_quantities(setting.refused.empty() ? setting.variant.scene : scene);
    tradeoff.quantities.clear();
    for (const auto& quantity : quantities) tradeoff.quantities.push_back(quantity.about);
    tradeoff.points.push_back(point_of(setting, read_runs(directory, setting, seeds, quantities)));
  }
  drop_missing(tradeoff);
  for (const ParameterValues& varied : parameters) {
    auto row = row_of(varied, scene, settings);
    if (row.points.size() > 1) tradeoff.parameters.push_back(std::move(row));
  }
  return tradeoff;
}

void add_map_correlation(results::Tradeoff& tradeoff, const std::filesystem::path& directory,
                         const std::vector<TriedSetting>& settings, int seeds, std::size_t reference) {
  if (reference >= settings.size()) return;
  const auto map = fields_of(directory, settings[reference], seeds);
  if (map.empty()) return;
  tradeoff.quantities.push_back({.key = kMapCorrelation,
                                 .name = "correlation of the density map with that of the reference",
                                 .unit = "1",
                                 .decides = false});
  for (std::size_t k = 0; k < settings.size(); ++k)
    tradeoff.points[k].values.push_back(
        value_over(correlations(fields_of(directory, settings[k], seeds), map, k == reference)));
}

}  // namespace diefill::process
