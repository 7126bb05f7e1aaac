#include "process/calibration/calibrate.h"

#include <algorithm>

#include "process/calibration/calibration_results.h"
#include "process/calibration/methods/next_points.h"
#include "process/calibration/methods/space_filling.h"
#include "process/calibration/powder_origin.h"
#include "process/calibration/starting_powder.h"
#include "process/compare/backups.h"
#include "process/measured_data/deviations.h"
#include "process/results/formatted.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/file_contents.h"
#include "process/run/assemble.h"

namespace diefill::process::calibration {
namespace {

/// Sets of parameters from the edge of the region, for checks: with the best one they are enough for the
/// worth of a measurement (measurement_worth.cpp); no more than two for each parameter.
std::size_t edge_points(std::size_t parameters) {
  constexpr std::size_t kUsual = 4;
  return std::min(std::max(kUsual, parameters + 1), 2 * parameters);
}

std::vector<double> plain(const Eigen::VectorXd& place) {
  return {place.begin(), place.end()};
}

std::vector<Point> start_points(const CalibrationPlan& plan) {
  std::vector<Point> points;
  const auto even =
      space_filling(static_cast<std::size_t>(plan.start_points), plan.parameters.size(), plan.seed);
  for (Eigen::Index k = 0; k < even.rows(); ++k) points.push_back({"start", plain(even.row(k).transpose())});
  return points;
}

/// The calibration on its way.
class Search {
 public:
  Search(const CalibrationPlan& plan, const CalibrateOptions& options)
      : plan_(plan), options_(options), runs_(plan, options.points) {
    simulated_.points = start_points(plan);
  }

  /// Until nothing helps any more, or runs are to be done elsewhere; says why it ended.
  std::string go() {
    for (;;) {
      simulate();
      fit_ = fit_points(plan_, simulated_);
      if (!options_.points.run && !runs_.open_jobs().jobs.empty()) return open_text();
      if (runs_.over_budget()) return "the budget is used";
      if (!fit_) return why_no_fit(plan_, simulated_);
      const NextPoints next =
          next_points(*fit_->likelihood, fit_->region, taken(), static_cast<std::size_t>(points_of_round()),
                      plan_.seed + simulated_.points.size());
      report(next);
      if (!next.worthwhile()) return reason(next);
      if (points_left() < 1)
        return "the search reached its most points (" + std::to_string(plan_.most_points) + ")";
      if (!take({{"search", plain(next.places.front())}})) return elsewhere_text();
      for (std::size_t k = 1; k < next.places.size(); ++k)
        simulated_.points.push_back({"search", plain(next.places[k])});
    }
  }

  /// The best parameters and those of the region's edge on what is to be checked.
  void check() {
    if (!fit_) return;
    const std::size_t searched = simulated_.points.size();
    if (const std::string obstacle = take_checks(); !obstacle.empty()) {
      if (has_checks() || !plan_.finer_grains.empty())
        remarks_.push_back("the check was not run: " + obstacle);
      return;
    }
    simulate();
    std::size_t left_out = 0;
    for (std::size_t k = searched; k < simulated_.outcomes.size(); ++k)
      left_out += simulated_.outcomes[k].state == "left out" ? 1 : 0;
    if (left_out > 0)
      remarks_.push_back("the check is incomplete: " + std::to_string(left_out) + " of its " +
                         std::to_string(simulated_.points.size() - searched) +
                         " sets of parameters have runs that are not finished" +
                         (runs_.over_budget() ? ": the budget is used" : ""));
  }

  results::Calibration account(const std::string& stopped) const {
    results::Calibration account = calibration_results(plan_, simulated_, fit_);
    account.remarks.insert(account.remarks.end(), remarks_.begin(), remarks_.end());
    account.command = options_.command;
    account.program_version = program_version();
    account.stopped = stopped;
    return account;
  }

  const std::optional<Fit>& fit() const { return fit_; }
  const results::JobList& open_jobs() const { return runs_.open_jobs(); }

 private:
  int points_left() const { return plan_.most_points - static_cast<int>(simulated_.points.size()); }
  /// As many as are left where these are fewer; one at least, to say what a further one would bring.
  int points_of_round() const { return std::clamp(points_left(), 1, plan_.points_at_once); }

  bool has_checks() const {
    return std::any_of(plan_.measurements.begin(), plan_.measurements.end(),
                       [](const Measurement& measurement) { return !measurement.fitted; });
  }

  /// Takes on the points of the check; what stands against it, or nothing.
  std::string take_checks() {
    if (runs_.over_budget()) return "the budget is used; --resume with a larger one runs it";
    if (!runs_.open_jobs().jobs.empty()) return open_text();
    if (!take({{"best", plain(fit_->region.best), true, true}})) return elsewhere_text();
    if (has_checks())
      for (const auto& place : edge_of(fit_->region, edge_points(plan_.parameters.size())))
        simulated_.points.push_back({"edge", plain(place), false, true});
    if (!plan_.finer_grains.empty())
      simulated_.points.push_back({"finer", plain(fit_->region.best), true, true, finer_grains_of(plan_)});
    return {};
  }

  /// Takes points on, unless they would be new and only finished runs count.
  bool take(const std::vector<Point>& points) {
    for (std::size_t k = 0; k < points.size(); ++k)
      if (options_.open_runs == OpenRuns::leave_out &&
          !runs_.is_written(points[k], simulated_.points.size() + k))
        return false;
    simulated_.points.insert(simulated_.points.end(), points.begin(), points.end());
    return true;
  }

  std::string open_text() const {
    const std::size_t others = runs_.open_of_other_scenes();
    return std::to_string(runs_.open_jobs().jobs.size()) + " runs are not finished" +
           (others == 0 ? "" : ": " + std::to_string(others) + " of these folders hold runs of other scenes");
  }

  static std::string elsewhere_text() {
    return "all runs are collected; --export-jobs writes those of the next round";
  }

  void simulate() {
    runs_.run(simulated_.points);
    for (std::size_t k = simulated_.outcomes.size(); k < simulated_.points.size(); ++k)
      simulated_.outcomes.push_back(runs_.outcome(simulated_.points[k], k));
  }

  std::vector<Eigen::VectorXd> taken() const {
    std::vector<Eigen::VectorXd> places;
    for (const Point& point : simulated_.points)
      places.push_back(Eigen::Map<const Eigen::VectorXd>(point.place.data(),
                                                         static_cast<Eigen::Index>(point.place.size())));
    return places;
  }

  void report(const NextPoints& next) const {
    if (!options_.on_note) return;
    std::string line = std::to_string(simulated_.points.size()) + " points:";
    for (std::size_t k = 0; k < plan_.parameters.size(); ++k) {
      const ParameterRange& range = plan_.parameters[k];
      const auto d = static_cast<Eigen::Index>(k);
      line += results::formatted(" %s %.3g (%.3g to %.3g)", range.key.c_str(),
                                 range.value_at(fit_->region.best[d]), range.value_at(fit_->region.lower[d]),
                                 range.value_at(fit_->region.upper[d]));
    }
    options_.on_note(line + results::formatted("; expected gain %.2g, scatter %.2g, emulator's share %.2g",
                                               next.expected_gain, next.scatter, next.emulator_share));
  }

  static std::string reason(const NextPoints& next) {
    const char* start = next.places.empty()
                            ? "no set of parameters is left that differs enough from those that were run"
                            : "more runs would change little";
    return start + results::formatted(
                       ": expected gain %.2g of the misfit, scatter over seeds %.2g; the "
                       "emulators add %.0f %% to the measurements' variance",
                       next.expected_gain, next.scatter, 100 * next.emulator_share);
  }

  const CalibrationPlan& plan_;
  const CalibrateOptions& options_;
  PointRuns runs_;
  SimulatedPoints simulated_;
  std::optional<Fit> fit_;
  std::vector<std::string> remarks_;  ///< about the check
};

/// powder.toml of the best parameters. One of an earlier state of the search is renamed.
void write_powder(const CalibrationPlan& plan, const Fit& fit, const results::Calibration& account,
                  const PointOptions& options) {
  const Measurement& first = plan.measurements[fit.measurement.front()];
  const Scene scene = scene_at(plan, first.runs.front(), plain(fit.region.best));
  const std::string text = powder_file_text(scene, powder_comment(account, plan, fit),
                                            powder_calibration_table(account, plan), program_version());
  const std::filesystem::path file = options.directory / "powder.toml";
  if (std::filesystem::exists(file)) {
    if (results::contents_or_nothing(file) == text) return;
    const auto renamed = back_up(file);
    if (options.on_note)
      options.on_note("note: the earlier powder.toml was renamed to " + renamed.filename().string());
  }
  results::write_text_atomically(file, text);
}

/// What is better known before hours are spent.
void note_doubtful_data(const CalibrationPlan& plan, const NoteCallback& on_note) {
  if (!on_note) return;
  for (const Measurement& measurement : plan.measurements)
    if (const std::string remark = remark_on_deviations(measurement.data); !remark.empty())
      on_note("note: measurement \"" + measurement.name + "\": " + remark);
}

}  // namespace

results::Calibration calibrate(const CalibrationPlan& plan, const CalibrateOptions& given) {
  CalibrateOptions options = given;
  options.points.run = given.open_runs == OpenRuns::run;
  options.points.write = given.open_runs != OpenRuns::leave_out;
  note_doubtful_data(plan, options.points.on_note);
  Search search(plan, options);
  const std::string stopped = search.go();
  search.check();
  results::Calibration account = search.account(stopped);
  account.open_runs = search.open_jobs().jobs.size();
  if (options.open_runs == OpenRuns::write) {
    write_job_scripts(options.points.directory, search.open_jobs(), options.points.on_note);
    return account;
  }
  if (search.fit()) write_powder(plan, *search.fit(), account, options.points);
  return account;
}

}  // namespace diefill::process::calibration
