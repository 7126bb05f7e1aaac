#include "process/laboratory/published/perform.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "process/input/toml_string.h"
#include "process/laboratory/published/charts_over_seeds.h"
#include "process/laboratory/published/custom_runs.h"
#include "process/laboratory/published/halved_steps.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/results/figure_table.h"
#include "process/results/storage/result_file.h"
#include "process/results/studies/job_cost.h"
#include "process/run/assemble.h"
#include "process/scene/folder_names.h"
#include "process/scene/scene_text.h"

namespace diefill::process::laboratory {
namespace {

namespace fs = std::filesystem;

/// Scenes of the runs; of those that the folder lists, at half their time step.
std::vector<Variant> variants_of(const SceneExperiment& experiment, const LabPlan& plan,
                                 const LabSetting& setting, const fs::path& directory) {
  const std::set<std::string> halved = runs_at_half_step(directory);
  std::vector<std::string> names;
  for (const LabRun& run : plan.runs) names.push_back(run.name);
  const auto folders = folder_names(names);
  std::vector<Variant> variants;
  for (std::size_t k = 0; k < plan.runs.size(); ++k) {
    const fs::path file = setting.scenes / plan.runs[k].scene;
    SceneChanges changes = plan.runs[k].changes;
    changes.source = "experiment \"" + names[k] + '"';
    changes.under = line("title", toml_string(experiment.name + ": " + names[k])) + changes.under;
    Scene scene = changed_scene(load_scene_text(file), file, changes);
    if (halved.contains(names[k])) scene = at_half_step(scene);
    variants.push_back({names[k], folders[k], std::move(scene)});
  }
  return variants;
}

/// Everything about the runs that the rows need.
class FinishedRuns {
 public:
  FinishedRuns(const fs::path& directory, const FoundJobs& found, const std::vector<CustomRun>& own,
               int own_seeds)
      : directory_(directory), other_scenes_(found.other_scenes) {
    const results::JobList& list = found.list;
    std::set<std::uint64_t> seeds;
    for (const results::Job& job : list.jobs) seeds.insert(job.seed);
    for (int seed = 1; !own.empty() && seed <= own_seeds; ++seed)
      seeds.insert(static_cast<std::uint64_t>(seed));
    for (const std::uint64_t seed : seeds) {
      std::map<std::string, fs::path> folders;
      for (const results::Job& job : list.jobs) {
        if (job.seed != seed) continue;
        jobs_[job.variant].push_back(job);
        if (!is_other(job) && state_of(directory, job).stage == JobState::Stage::finished)
          folders[job.variant] = directory / job.folder;
      }
      std::map<std::string, std::string> results;
      for (const CustomRun& run : own) {
        const StoredCustomRun& kept = own_[run.name].emplace_back(stored_custom_run(directory, run, seed));
        if (kept.finished) results[run.name] = kept.result;
      }
      seeds_.emplace_back(seed, std::move(folders), std::move(results));
    }
    if (seeds_.empty()) seeds_.emplace_back(1, std::map<std::string, fs::path>());
  }

  const std::vector<SeedResults>& seeds() const { return seeds_; }
  bool is_scene(const std::string& run) const { return jobs_.contains(run); }

  double core_seconds(const std::vector<std::string>& runs) const {
    double sum = 0;
    for (const std::string& run : runs) {
      for (const results::Job& job : jobs_of(run))
        if (!is_other(job)) sum += results::read_job_cost(directory_ / job.folder).cpu_seconds;
      for (const StoredCustomRun& own : own_of(run)) sum += own.core_seconds;
    }
    return sum;
  }

  /// Why some of these runs are not finished; empty where all are.
  std::string why_missing(const std::vector<std::string>& runs) const {
    std::size_t open = 0, other = 0, all = 0;
    for (const std::string& run : runs) {
      for (const results::Job& job : jobs_of(run)) {
        ++all;
        other += is_other(job) ? 1U : 0U;
        if (is_other(job)) continue;
        const JobState state = state_of(directory_, job);
        if (state.stage == JobState::Stage::failed) return "run \"" + run + "\" failed: " + state.reason;
        open += state.stage == JobState::Stage::open ? 1U : 0U;
      }
      for (const StoredCustomRun& own : own_of(run)) {
        ++all;
        if (!own.failure.empty()) return "run \"" + run + "\" failed: " + own.failure;
        open += own.finished ? 0U : 1U;
      }
    }
    if (other > 0) return std::to_string(other) + " of " + std::to_string(all) + " runs of a different scene";
    if (open == 0) return {};
    return std::to_string(open) + " of " + std::to_string(all) +
           " runs not finished (budget used, or stopped)";
  }

 private:
  bool is_other(const results::Job& job) const { return other_scenes_.contains(job.folder); }
  std::vector<results::Job> jobs_of(const std::string& run) const {
    const auto found = jobs_.find(run);
    return found == jobs_.end() ? std::vector<results::Job>() : found->second;
  }
  std::vector<StoredCustomRun> own_of(const std::string& run) const {
    const auto found = own_.find(run);
    return found == own_.end() ? std::vector<StoredCustomRun>() : found->second;
  }

  fs::path directory_;
  std::set<std::string> other_scenes_;
  std::map<std::string, std::vector<results::Job>> jobs_;
  std::map<std::string, std::vector<StoredCustomRun>> own_;  ///< of each seed
  std::vector<SeedResults> seeds_;
};

/// Values over the seeds that have all runs, and the coarsest grains among these.
void measure(const LabQuantity& quantity, const FinishedRuns& runs, results::LabRow& row) {
  std::vector<SeedResults> seeds;
  for (const SeedResults& seed : runs.seeds()) {
    const auto has = [&](const std::string& run) { return seed.has(run); };
    if (!std::all_of(quantity.runs.begin(), quantity.runs.end(), has)) continue;
    seeds.push_back(seed);
    for (const std::string& run : quantity.runs)
      if (runs.is_scene(run))
        row.grain_diameter =
            std::fmax(row.grain_diameter, results::figure_of(seed.of(run), "grain_diameter_m"));
  }
  std::vector<double> values;
  try {
    if (!quantity.over_seeds) {
      for (const SeedResults& seed : seeds) values.push_back(quantity.value(seed));
    } else if (seeds.size() > 1) {
      values.push_back(quantity.over_seeds(seeds));
      row.seeds = seeds.size();
    }
  } catch (const results::ResultError& error) {
    row.reason = error.what();
  }
  for (const double value : values)
    if (std::isfinite(value)) row.values.push_back(value);
}

/// Charts of what there is; a result that lacks what they draw leaves them out, and `on_note` gets the
/// reason.
std::vector<results::ExperimentChart> charts_of(const SceneExperiment& experiment, const LabPlan& plan,
                                                const std::vector<SeedResults>& seeds,
                                                const NoteCallback& on_note) {
  std::vector<std::vector<results::ExperimentChart>> of_seeds;
  try {
    for (const SeedResults& seed : seeds) of_seeds.push_back(plan.charts(seed));
  } catch (const results::ResultError& error) {
    if (on_note) on_note(std::string("charts of ") + experiment.name + ": " + error.what());
  }
  auto charts = charts_over_seeds(std::move(of_seeds));
  for (auto& chart : charts)
    if (chart.name == experiment.name) chart.name += "_chart";  // <experiment>.csv is the table
  return charts;
}

results::LabRow row_of(const LabQuantity& quantity, const FinishedRuns& runs,
                       const std::vector<PublishedFigure>& figures, bool published_powder) {
  results::LabRow row;
  row.id = quantity.id;
  const auto published = std::find_if(figures.begin(), figures.end(),
                                      [&](const auto& figure) { return figure.id == quantity.id; });
  if (published != figures.end()) take_published(*published, row);
  if (!quantity.quantity.empty()) row.quantity = quantity.quantity;
  if (!quantity.unit.empty()) row.unit = quantity.unit;
  if (row.quantity.empty()) row.quantity = row.id;
  measure(quantity, runs, row);
  row.core_seconds = runs.core_seconds(quantity.runs);
  if (const std::string missing = runs.why_missing(quantity.runs); !missing.empty()) row.reason = missing;
  if (row.values.empty() && row.reason.empty())
    row.reason = quantity.over_seeds ? "takes two seeds at least" : "the results do not have it";
  row.verdict = published_powder || row.published.empty() ? verdict_of(row) : "-";
  return row;
}

/// Makes the runs, those whose time step proves too long a second time.
results::JobList make_runs(const SceneExperiment& experiment, const LabPlan& plan, const LabSetting& setting,
                           const LabJobs& jobs) {
  results::JobList list;
  do {
    const auto variants = variants_of(experiment, plan, setting, jobs.directory);
    list = write_jobs(jobs.directory, {experiment.name, variants, jobs.seeds, {}}, jobs.on_note);
    run_jobs(jobs.directory, list, jobs.options);
  } while (halve_steps_that_were_too_long(jobs.directory, list, jobs.on_note));
  return list;
}

}  // namespace

void take_published(const PublishedFigure& figure, results::LabRow& row) {
  row.quantity = figure.quantity;
  row.setting = figure.model.empty() ? figure.setting : figure.model + "; " + figure.setting;
  row.unit = figure.unit;
  row.published = figure.published;
  row.lower = figure.lower;
  row.upper = figure.upper;
}

std::string verdict_of(const results::LabRow& row) {
  if (row.values.empty()) return "no value";
  if (!std::isfinite(row.lower) && !std::isfinite(row.upper)) return "-";
  const double mean = results::mean_of(row);
  return mean < row.lower || mean > row.upper ? "not met" : "met";
}

bool holds_runs_of_other_scenes(const SceneExperiment& experiment, const LabSetting& setting,
                                const fs::path& directory, int seeds) {
  const WantedJobs wanted{
      experiment.name, variants_of(experiment, experiment.plan(setting), setting, directory), seeds, {}};
  return !find_jobs(directory, wanted).other_scenes.empty();
}

LabOutcome perform(const SceneExperiment& experiment, const LabSetting& setting,
                   const std::vector<PublishedFigure>& figures, const LabJobs& jobs) {
  const LabPlan plan = experiment.plan(setting);
  FoundJobs found;
  if (!plan.runs.empty()) {
    if (jobs.run) {
      found.list = make_runs(experiment, plan, setting, jobs);
    } else {
      const auto variants = variants_of(experiment, plan, setting, jobs.directory);
      found = find_jobs(jobs.directory, {experiment.name, variants, jobs.seeds, {}});
    }
  }
  if (jobs.run) make_custom_runs(plan.custom_runs, jobs);
  const FinishedRuns runs(jobs.directory, found, plan.custom_runs, jobs.seeds);
  LabOutcome outcome;
  outcome.table.experiment = experiment.name;
  outcome.table.question = experiment.question;
  outcome.table.size = name_of(setting.size);
  outcome.table.powder = setting.powder.empty() ? "" : setting.powder.filename().string();
  outcome.table.program_version = program_version();
  outcome.table.seeds = jobs.seeds;
  std::vector<std::string> all;
  for (const LabRun& run : plan.runs) all.push_back(run.name);
  for (const CustomRun& run : plan.custom_runs) all.push_back(run.name);
  outcome.table.core_seconds = runs.core_seconds(all);
  outcome.finished = runs.why_missing(all).empty();
  for (const LabQuantity& quantity : plan.quantities)
    outcome.table.rows.push_back(row_of(quantity, runs, figures, setting.powder.empty()));
  if (plan.charts) outcome.charts = charts_of(experiment, plan, runs.seeds(), jobs.on_note);
  return outcome;
}

}  // namespace diefill::process::laboratory
