#include "process/calibration/point_runs.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>

#include "process/results/formatted.h"
#include "process/results/no_value.h"
#include "process/results/storage/result_file.h"
#include "process/results/studies/job_cost.h"
#include "process/scene/scene_text.h"

namespace diefill::process::calibration {
namespace {

std::string point_name(std::size_t number) {
  return "point " + std::to_string(number + 1);
}

/// Whether two scenes have the same [powder], [contact] and [walls]; copies of scenes have other paths.
bool same_powder(const std::string& a, const std::string& b) {
  toml::table first = parse_scene_text(a, "scene"), second = parse_scene_text(b, "scene");
  for (toml::table* document : {&first, &second})
    if (toml::table* powder = (*document)["powder"].as_table()) powder->erase("spheres_file");
  for (const char* name : {"powder", "contact", "walls"}) {
    const toml::table* of_first = first[name].as_table();
    const toml::table* of_second = second[name].as_table();
    if ((of_first == nullptr) != (of_second == nullptr)) return false;
    if (of_first != nullptr && *of_first != *of_second) return false;
  }
  return true;
}

}  // namespace

Sample PointOutcome::over_seeds(std::size_t measurement, std::size_t place) const {
  std::vector<double> column;
  for (const auto& row : values[measurement]) column.push_back(row[place]);
  return sample_of(column);
}

PointRuns::PointRuns(const CalibrationPlan& plan, PointOptions options)
    : plan_(plan), options_(std::move(options)) {
  for (const Measurement& measurement : plan_.measurements) {
    std::vector<std::size_t> numbers;
    for (const MeasurementRun& run : measurement.runs) {
      const auto same = [&](const MeasurementRun& other) {
        return other.text == run.text && other.set == run.set && other.file == run.file;
      };
      const auto found = std::find_if(runs_.begin(), runs_.end(), same);
      numbers.push_back(static_cast<std::size_t>(found - runs_.begin()));
      if (found == runs_.end()) runs_.push_back(run);
    }
    measured_by_.push_back(std::move(numbers));
  }
}

std::string PointRuns::folder_of(std::size_t number, std::size_t run) const {
  return results::formatted("p%03zu_r%02zu", number + 1, run + 1);
}

/// Each once, in their order.
std::vector<std::size_t> PointRuns::runs_of(const Point& point) const {
  std::set<std::size_t> numbers;
  for (std::size_t m = 0; m < plan_.measurements.size(); ++m)
    if (plan_.measurements[m].fitted ? point.fitted : point.checks)
      numbers.insert(measured_by_[m].begin(), measured_by_[m].end());
  return {numbers.begin(), numbers.end()};
}

std::vector<Variant> PointRuns::variants_of(const Point& point, std::size_t number) {
  std::vector<Variant> variants;
  for (const std::size_t run : runs_of(point)) {
    auto& kept = scenes_[{number, run}];
    try {
      if (kept.empty()) {
        Variant variant{point_name(number) + ", run " + std::to_string(run + 1), folder_of(number, run),
                        scene_at(plan_, runs_[run], point.place, point.set)};
        variant.scene.seed = seed_of(number, 0);
        kept.push_back(std::move(variant));
      }
    } catch (const SceneError& error) {
      refused_[number] = error.what();
      return {};
    }
    variants.push_back(kept.front());
  }
  return variants;
}

/// The jobs of runs that are only read. Throws SceneError where the directory has none of them.
results::JobList PointRuns::jobs_found(const WantedJobs& wanted) {
  FoundJobs found = find_jobs(options_.directory, wanted);
  other_scenes_ = std::move(found.other_scenes);
  const auto& jobs = found.list.jobs;
  const bool any = std::any_of(jobs.begin(), jobs.end(), [&](const results::Job& job) {
    return std::filesystem::exists(options_.directory / job.folder / kJobScene) &&
           !other_scenes_.contains(job.folder);
  });
  if (!any && !jobs.empty())
    throw SceneError(options_.directory.string() + ": found no runs of " + plan_.file.string() +
                     (other_scenes_.empty() ? "" : ", but runs of other scenes") +
                     "; give the directory that --export-jobs wrote for this file as it stands");
  return std::move(found.list);
}

results::JobList PointRuns::jobs_for(const std::vector<Point>& points) {
  WantedJobs wanted;
  wanted.title = plan_.title;
  wanted.seeds = plan_.seeds;
  // What an earlier call went on to comes again in its turn.
  if (std::filesystem::exists(results::job_list_file(options_.directory)))
    wanted.later = results::read_job_list(options_.directory).variants;
  for (std::size_t k = 0; k < points.size(); ++k)
    for (Variant& variant : variants_of(points[k], k)) wanted.variants.push_back(std::move(variant));
  return options_.write ? write_jobs(options_.directory, wanted, options_.on_note) : jobs_found(wanted);
}

/// A run of another scene is as good as none.
JobState PointRuns::state_of_job(const results::Job& job) const {
  return other_scenes_.contains(job.folder) ? JobState{} : state_of(options_.directory, job);
}

/// Processor time in s. A run of another scene is no part of this calibration's cost.
double PointRuns::cpu_seconds_of_job(const results::Job& job) const {
  return other_scenes_.contains(job.folder)
             ? 0
             : results::read_job_cost(options_.directory / job.folder).cpu_seconds;
}

std::size_t PointRuns::open_of_other_scenes() const {
  return static_cast<std::size_t>(
      std::count_if(open_.jobs.begin(), open_.jobs.end(),
                    [&](const results::Job& job) { return other_scenes_.contains(job.folder); }));
}

void PointRuns::run(const std::vector<Point>& points) {
  const results::JobList all = jobs_for(points);
  results::JobList open = all;
  open.jobs.clear();
  double of_others = 0;
  for (const results::Job& job : all.jobs) {
    const JobState state = state_of_job(job);
    const bool again = options_.run && state.stage == JobState::Stage::failed && !tried_.contains(job.folder);
    if (state.stage == JobState::Stage::open || again)
      open.jobs.push_back(job);
    else
      of_others += cpu_seconds_of_job(job);
  }
  JobOptions jobs = options_.jobs;
  jobs.cpu_seconds -= of_others;
  if (options_.run && !open.jobs.empty() && jobs.cpu_seconds > 0) run_jobs(options_.directory, open, jobs);
  spent_ = 0;
  open_ = open;
  open_.jobs.clear();
  for (const results::Job& job : all.jobs) {
    tried_.insert(job.folder);
    spent_ += cpu_seconds_of_job(job);
    if (state_of_job(job).stage == JobState::Stage::open) open_.jobs.push_back(job);
  }
}

/// No two runs of a calibration have the same seed: what one does alike to all powders then averages out.
std::uint64_t PointRuns::seed_of(std::size_t number, int k) const {
  return plan_.seed + static_cast<std::uint64_t>(number) * static_cast<std::uint64_t>(plan_.seeds) +
         static_cast<std::uint64_t>(k);
}

results::Job PointRuns::job_of(std::size_t number, std::size_t run, int k) const {
  const std::uint64_t seed = seed_of(number, k);
  return {"", seed, results::job_folder(folder_of(number, run), seed)};
}

bool PointRuns::is_written(const Point& point, std::size_t number) const {
  const auto runs = runs_of(point);
  return std::all_of(runs.begin(), runs.end(), [&](std::size_t run) {
    const auto file = options_.directory / job_of(number, run, 0).folder / kJobScene;
    return std::filesystem::exists(file) &&
           same_powder(load_scene_text(file), scene_at(plan_, runs_[run], point.place, point.set).text);
  });
}

namespace {

/// Why the result has no such figure; masses and densities of the real powder rest on the fill ratio.
std::string why_no_value(const results::FillResult& result, const std::string& figure) {
  const std::string own = results::reason_for(result, figure);
  return own.empty() && figure.starts_with("expected_") ? results::reason_for(result, "fill_ratio") : own;
}

}  // namespace

/// Empty where a run is not finished. Throws results::ResultError where a figure has no value and a reason.
std::vector<double> PointRuns::values_of_seed(std::size_t measurement, std::size_t number, int k) const {
  std::vector<results::FillResult> read;
  std::vector<FinishedRun> finished;
  for (const std::size_t run : measured_by_[measurement]) {
    const results::Job job = job_of(number, run, k);
    if (state_of_job(job).stage != JobState::Stage::finished) return {};
    finished.push_back({options_.directory / job.folder, nullptr});
    read.push_back(results::read_results(finished.back().folder));
  }
  for (std::size_t r = 0; r < read.size(); ++r) finished[r].result = &read[r];
  auto values = plan_.measurements[measurement].simulated(finished);
  if (read.size() == 1 && values.size() == 1 && !std::isfinite(values.front()))
    if (auto why = why_no_value(read.front(), plan_.measurements[measurement].figure); !why.empty())
      throw results::ResultError(why);
  return values;
}

/// Rows of values, seed by seed. A result that is damaged or lacks what is measured has none: `reason` says
/// why.
std::vector<std::vector<double>> PointRuns::values_of(std::size_t measurement, std::size_t number,
                                                      std::string& reason) const {
  std::vector<std::vector<double>> rows;
  for (int k = 0; k < plan_.seeds; ++k) {
    try {
      auto values = values_of_seed(measurement, number, k);
      if (std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
        rows.push_back(std::move(values));
    } catch (const results::ResultError& error) {
      reason = error.what();
    }
  }
  return rows;
}

/// Cost and state of a point's runs.
void PointRuns::add_states(const Point& point, std::size_t number, PointOutcome& outcome) const {
  for (const std::size_t run : runs_of(point))
    for (int k = 0; k < plan_.seeds; ++k) {
      const results::Job job = job_of(number, run, k);
      const JobState state = state_of_job(job);
      outcome.core_seconds += cpu_seconds_of_job(job);
      if (state.stage == JobState::Stage::failed) {
        outcome.state = "failed";
        outcome.reason = state.reason;
      } else if (state.stage == JobState::Stage::open && outcome.state == "finished") {
        outcome.state = "left out";
      }
    }
}

PointOutcome PointRuns::outcome(const Point& point, std::size_t number) {
  PointOutcome outcome;
  outcome.values.resize(plan_.measurements.size());
  outcome.state = "finished";
  if (const auto refused = refused_.find(number); refused != refused_.end()) {
    outcome.state = "failed";
    outcome.reason = refused->second;
    return outcome;
  }
  add_states(point, number, outcome);
  for (std::size_t m = 0; m < plan_.measurements.size(); ++m) {
    if (!(plan_.measurements[m].fitted ? point.fitted : point.checks)) continue;
    std::string reason;
    outcome.values[m] = values_of(m, number, reason);
    if (outcome.state != "finished" || (outcome.has(m) && reason.empty())) continue;
    if (!outcome.has(m)) outcome.state = "failed";
    outcome.reason = outcome.has(m) ? "a seed has" : "its results have";
    outcome.reason += " no value of \"" + plan_.measurements[m].name + '"';
    if (!reason.empty()) outcome.reason += ": " + reason;
  }
  return outcome;
}

}  // namespace diefill::process::calibration
