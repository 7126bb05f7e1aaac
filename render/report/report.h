// Reports of one run, or of several compared with each other, as one HTML page and as a PDF.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "process/results/fill_result.h"
#include "process/results/studies/measured_comparison.h"
#include "render/report/document.h"
#include "render/report/viewer/viewed_run.h"

namespace diefill::render::report {

/// A run and the name by which the report calls it.
struct Run {
  std::string name;
  results::FillResult result;
  std::string strategy;  ///< that it is a run of, where a comparison says so; empty: derived from the scene
  /// The same result as of each further cavity of the die, for maps of their own; empty where there is one.
  std::vector<results::FillResult> other_cavities = {};
  std::vector<results::MeasuredComparison> measured = {};  ///< what the result is compared with
  std::vector<Film> films = {};                            ///< of the run
};

/// Measures what the interactive view shows besides the results; called for the runs that it shows.
using MeasureForView = std::function<ViewExtras(const results::FillResult&)>;

/// The report as content: of one run all that is known about it; of several first the comparison, then every
/// run. Runs whose scenes differ only in the seed are one strategy, whose scatter is given.
/// The interactive view shows the first run of each strategy; without `measure` it lacks densities other than
/// those of the grains at the end.
/// start_offscreen() must have been called. Throws std::invalid_argument without runs.
Document report_of(const std::vector<Run>& runs, const MeasureForView& measure = {});

}  // namespace diefill::render::report
