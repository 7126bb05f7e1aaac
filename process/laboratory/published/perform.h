// Runs an experiment's scenes as jobs, continues where it was stopped, and compares the results with the
// published figures.
#pragma once

#include "process/compare/job_folder.h"
#include "process/compare/run_jobs.h"
#include "process/laboratory/published/published_figure.h"
#include "process/laboratory/published/scene_experiment.h"
#include "process/results/studies/lab_table.h"

namespace diefill::process::laboratory {

struct LabOutcome {
  results::LabTable table;
  std::vector<results::ExperimentChart> charts;
  bool finished = true;  ///< all runs; a quantity may have no value even so
};

/// Where and how the runs are made.
struct LabJobs {
  std::filesystem::path directory;
  JobOptions options;  ///< its `cpu_seconds` are the budget
  int seeds = 1;
  NoteCallback on_note;
  bool run = true;  ///< false: only what is finished there is measured, and no run's folder is touched
};

/// Quantity, unit and range of the published figure that the row stands for.
void take_published(const PublishedFigure& figure, results::LabRow& row);

/// "met" or "not met" of a mean; "-" where the row has no limits, "no value" without one.
std::string verdict_of(const results::LabRow& row);

/// Whether the folder has a run of the experiment that was made of another scene, such as one with another
/// powder. Throws SceneError and results::ResultError.
bool holds_runs_of_other_scenes(const SceneExperiment& experiment, const LabSetting& setting,
                                const std::filesystem::path& directory, int seeds);

/// Throws SceneError, results::ResultError, and what run_jobs throws.
LabOutcome perform(const SceneExperiment& experiment, const LabSetting& setting,
                   const std::vector<PublishedFigure>& figures, const LabJobs& jobs);

}  // namespace diefill::process::laboratory
