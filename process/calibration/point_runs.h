// Runs the simulations that sets of parameters take, as jobs of a comparison (compare/run_jobs.h), and reads
// the measured values off their results.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "process/calibration/calibration_file.h"
#include "process/compare/job_folder.h"
#include "process/compare/run_jobs.h"
#include "process/compare/statistics.h"

namespace diefill::process::calibration {

/// One set of parameters to simulate.
struct Point {
  std::string role;                    ///< as in results::CalibrationPoint
  std::vector<double> place;           ///< in the unit cube
  bool fitted = true, checks = false;  ///< which measurements it takes
  std::string set = {};                ///< TOML that its scenes change besides
};

/// What a point's runs gave.
struct PointOutcome {
  /// Measurement by measurement, a row for each seed whose runs are all finished and have a value of it; NaN
  /// at places without one.
  std::vector<std::vector<std::vector<double>>> values;
  std::string state, reason;  ///< finished, failed or left out; why, or why a seed of it has no value
  double core_seconds = 0;

  bool has(std::size_t measurement) const { return !values[measurement].empty(); }
  /// One value of a measurement over the seeds that have it; without a mean where none has.
  Sample over_seeds(std::size_t measurement, std::size_t place) const;
};

struct PointOptions {
  std::filesystem::path directory;
  JobOptions jobs;
  NoteCallback on_note;
  bool run = true;    ///< false: no run is started
  bool write = true;  ///< false: finished runs are only read; nothing is written or renamed
};

class PointRuns {
 public:
  PointRuns(const CalibrationPlan& plan, PointOptions options);

  /// Runs what is not finished of these points, failed ones once. Points are identified by their place in the
  /// list, which only grows. Throws Interrupted, std::runtime_error as run_jobs does, and, where runs are
  /// only read, SceneError for a directory that has none of these points.
  void run(const std::vector<Point>& points);
  /// What the runs gave; of a result that is damaged or lacks what is measured, the reason. Throws SceneError
  /// where no result can have it.
  PointOutcome outcome(const Point& point, std::size_t number);
  /// Whether the budget of processor time is spent.
  bool over_budget() const { return spent_ >= options_.jobs.cpu_seconds; }
  /// Jobs of the latest run() that are neither finished nor failed.
  const results::JobList& open_jobs() const { return open_; }
  /// How many of these hold a run of another scene; known where runs are only read.
  std::size_t open_of_other_scenes() const;
  /// Whether scenes of this point have been written before.
  bool is_written(const Point& point, std::size_t number) const;

 private:
  results::JobList jobs_for(const std::vector<Point>& points);
  results::JobList jobs_found(const WantedJobs& wanted);
  JobState state_of_job(const results::Job& job) const;
  double cpu_seconds_of_job(const results::Job& job) const;
  std::vector<std::size_t> runs_of(const Point& point) const;
  std::vector<Variant> variants_of(const Point& point, std::size_t number);
  std::vector<double> values_of_seed(std::size_t measurement, std::size_t number, int k) const;
  std::vector<std::vector<double>> values_of(std::size_t measurement, std::size_t number,
                                             std::string& reason) const;
  void add_states(const Point& point, std::size_t number, PointOutcome& outcome) const;
  std::string folder_of(std::size_t number, std::size_t run) const;
  std::uint64_t seed_of(std::size_t number, int k) const;
  results::Job job_of(std::size_t number, std::size_t run, int k) const;

  const CalibrationPlan& plan_;
  PointOptions options_;
  std::vector<MeasurementRun> runs_;                   ///< of all measurements, each once
  std::vector<std::vector<std::size_t>> measured_by_;  ///< runs of each measurement
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Variant>> scenes_;
  std::map<std::size_t, std::string> refused_;  ///< points that a scene cannot have, and why
  std::set<std::string> tried_;                 ///< folders run in this session
  std::set<std::string> other_scenes_;          ///< folders with a run of another scene, which does not count
  results::JobList open_;
  double spent_ = 0;  ///< s of processor time of all jobs
};

}  // namespace diefill::process::calibration
