// An experiment of the laboratory: a question to the method, answered by driving the engine. To add one: a
// file with a function like `perform`, its declaration and its line in the registry of its family.
#pragma once

#include <string>
#include <vector>

#include "process/results/studies/experiment_result.h"
#include "process/tooling/progress.h"

namespace diefill::process::laboratory {

struct ExperimentOptions {
  bool quick = false;  ///< small beds and few points
  int threads = 2;
  ProgressCallback on_progress = ignore_progress;
};

struct Experiment {
  std::string name;      ///< on the command line and of its files
  std::string question;  ///< one line
  /// Fills in limits and charts.
  void (*perform)(const ExperimentOptions& options, results::ExperimentResult& result);
  std::vector<std::string> published_figures = {};  ///< ids of those that its result is compared with
};

/// Runs it and records its processor time.
results::ExperimentResult perform(const Experiment& experiment, const ExperimentOptions& options);

}  // namespace diefill::process::laboratory
