#include "process/compare/collect.h"

#include <algorithm>
#include <cmath>

#include "process/compare/compared_fields.h"
#include "process/compare/compared_measures.h"
#include "process/compare/job_folder.h"
#include "process/compare/statistics.h"
#include "process/input/scene_error.h"
#include "process/results/none.h"
#include "process/results/rounding.h"
#include "process/results/storage/result_file.h"
#include "process/run/restart/input_record.h"

namespace diefill::process {
namespace {

/// A file as the first run that names it has read it.
struct ReadFile {
  std::string hash, folder;  ///< of its contents; of the run
};

/// What a comparison has besides its runs: fields, and by a measure's key why a run has no value of it.
struct Gathered {
  std::map<std::string, std::vector<results::Field2D>> fields;  ///< by variant
  std::map<std::string, std::string> reasons;
  std::map<std::string, std::string> folders;  ///< of the runs, by variant, seed and final state
  std::map<std::string, ReadFile> files;       ///< that runs have read, by name
};

/// The folder of an earlier run of the same variant with this seed and final state; empty: there is none.
std::string folder_of_the_same(const results::Job& job, const results::FillResult& result,
                               Gathered& gathered) {
  if (result.state_hash.empty()) return {};
  const std::string state = job.variant + '\n' + std::to_string(result.seed) + '\n' + result.state_hash;
  const auto [first, is_new] = gathered.folders.emplace(state, job.folder);
  return is_new ? "" : first->second;
}

/// Throws results::ResultError where the run has read different contents of a file, such as pour.state, than
/// an earlier run: the two differ by more than their scenes.
void refuse_other_inputs(const results::Job& job, const results::FillResult& result, Gathered& gathered) {
  const auto files = recorded_input_files(result);
  if (!files) return;
  for (const InputFile& file : *files) {
    const auto& first = gathered.files.emplace(file.name, ReadFile{file.hash, job.folder}).first->second;
    if (first.hash != file.hash)
      throw results::ResultError("has read different contents of " + file.name + " than " + first.folder);
  }
}

void take_further(results::ComparedRun& run, const results::FillResult& result,
                  const std::vector<FurtherMeasure>& further, Gathered& gathered) {
  std::set<std::string> reasons;  // several measures of one file have the same
  for (const FurtherMeasure& measure : further) {
    try {
      const double value = measure.value(result);
      if (std::isfinite(value)) run.values[measure.about.key] = value;
    } catch (const SceneError& error) {
      gathered.reasons.emplace(measure.about.key, error.what());
      reasons.insert(error.what());
    }
  }
  for (const std::string& reason : reasons) run.reason += (run.reason.empty() ? "" : "; ") + reason;
}

void take_values(results::ComparedRun& run, const results::FillResult& result) {
  run.state_hash = result.state_hash;
  for (const auto& measure : compared_measures()) {
    const double value = value_of(measure, result);
    if (std::isfinite(value)) run.values[measure.key] = value;
  }
  std::set<std::string> keys;
  for (const auto& [key, value] : result.figures)
    if (std::isfinite(value)) keys.insert(key);
  for (const auto& measure : measures_of_named(keys)) run.values[measure.key] = value_of(measure, result);
}

/// Throws the first reason where no run has a value of a measure: the measured data are wrong then.
void refuse_measures_of_no_run(const std::vector<results::ComparedRun>& runs,
                               const std::map<std::string, std::string>& reasons) {
  for (const auto& [key, reason] : reasons)
    if (std::none_of(runs.begin(), runs.end(), [&](const auto& run) { return run.values.contains(key); }))
      throw SceneError(reason);
}

/// The run as it stands; adds its field if it is finished.
results::ComparedRun compared_run(const std::filesystem::path& directory, const results::Job& job,
                                  const std::vector<FurtherMeasure>& further, Gathered& gathered) {
  results::ComparedRun run;
  run.variant = job.variant;
  run.folder = job.folder;
  run.seed = job.seed;
  const JobState state = state_of(directory, job);
  run.reason = state.reason;
  run.exit_code = state.exit_code;
  run.state = state.stage == JobState::Stage::open ? "not finished" : "failed";
  if (!std::filesystem::exists(directory / job.folder))
    run.reason = "its folder " + job.folder + " is missing";
  if (state.stage != JobState::Stage::finished) return run;
  try {
    const auto result = results::read_results(directory / job.folder);
    if (const auto same = folder_of_the_same(job, result, gathered); !same.empty())
      throw results::ResultError("holds a copy of " + same + ", seed " + std::to_string(result.seed) +
                                 ", which is counted once");
    refuse_other_inputs(job, result, gathered);
    take_values(run, result);
    take_further(run, result, further, gathered);
    run.state = "finished";
    if (const auto* field = compared_field(result)) gathered.fields[job.variant].push_back(*field);
  } catch (const results::ResultError& error) {
    run.state = "failed";
    run.reason = error.what() + std::string("; move its folder away to run it again");
    run.exit_code = 1;
  }
  return run;
}

/// Values that are the same but for rounding do not scatter.
Sample without_rounding(Sample sample, double period) {
  if (results::is_rounding(sample.scatter, std::max(std::abs(sample.mean), period))) sample.scatter = 0;
  return sample;
}

/// `period`: of angles; 0 for other measures.
double difference_beyond_rounding(const Sample& first, const Sample& sample, double period) {
  const double off = difference(first.mean, sample.mean, period);
  const double size = std::max({std::abs(first.mean), std::abs(sample.mean), period});
  return results::is_rounding(off, size) ? 0 : off;
}

results::ComparedValue compared_value(const Sample& first, const Sample& sample, double period,
                                      bool is_first) {
  results::ComparedValue value;
  value.mean = sample.mean;
  value.scatter = sample.scatter;
  value.seeds = sample.count;
  value.difference = is_first ? kNone : difference_beyond_rounding(first, sample, period);
  value.interval = is_first ? kNone : welch_half_width(first, sample);
  using results::Verdict;
  if (sample.count == 0 || first.count == 0)
    value.verdict = Verdict::missing;
  else if (is_first)
    value.verdict = Verdict::reference;
  else if (!std::isfinite(value.interval))
    value.verdict = Verdict::scatter_unknown;
  else
    value.verdict = std::abs(value.difference) > value.interval ? Verdict::different : Verdict::none;
  return value;
}

std::vector<double> values_of(const std::string& key, const std::string& variant,
                              const std::vector<results::ComparedRun>& runs) {
  std::vector<double> values;
  for (const auto& run : runs)
    if (run.variant == variant && run.values.contains(key)) values.push_back(run.values.at(key));
  return values;
}

}  // namespace

std::vector<results::ComparedMeasure> compare_runs(const std::vector<std::string>& variants,
                                                   const std::vector<results::ComparedRun>& runs,
                                                   const std::vector<FurtherMeasure>& further) {
  std::set<std::string> keys;
  for (const auto& run : runs)
    for (const auto& [key, value] : run.values) keys.insert(key);
  std::vector<MeasureOfComparison> measures = compared_measures();
  for (auto& named : measures_of_named(keys)) measures.push_back(std::move(named));
  for (const FurtherMeasure& measure : further) measures.push_back(measure.about);
  std::vector<results::ComparedMeasure> all;
  for (const auto& measure : measures) {
    std::vector<Sample> samples;
    for (const auto& variant : variants)
      samples.push_back(
          without_rounding(sample_of(values_of(measure.key, variant, runs), measure.period), measure.period));
    const auto measured = [](const Sample& sample) { return sample.count > 0; };
    if (std::none_of(samples.begin(), samples.end(), measured)) continue;
    results::ComparedMeasure compared{measure.key, measure.name, measure.unit, {}};
    for (std::size_t k = 0; k < samples.size(); ++k)
      compared.values.push_back(compared_value(samples.front(), samples[k], measure.period, k == 0));
    all.push_back(std::move(compared));
  }
  return all;
}

results::Comparison collect(const std::filesystem::path& directory,
                            const std::vector<FurtherMeasure>& further) {
  const results::JobList list = results::read_job_list(directory);
  results::Comparison comparison;
  comparison.title = list.title;
  comparison.variants = list.variants;
  Gathered gathered;
  for (const auto& job : list.jobs)
    comparison.runs.push_back(compared_run(directory, job, further, gathered));
  refuse_measures_of_no_run(comparison.runs, gathered.reasons);
  comparison.measures = compare_runs(comparison.variants, comparison.runs, further);
  for (const auto& variant : comparison.variants) {
    comparison.fields.push_back(mean_field(gathered.fields[variant]));
    comparison.field_seeds.push_back(gathered.fields[variant].size());
  }
  return comparison;
}

}  // namespace diefill::process
