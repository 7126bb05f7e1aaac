// Result of an experiment of the laboratory: limits with their prediction, and curves for charts. Plain
// values in the units that their labels name.
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace diefill::results {

/// A curve of an experiment's chart.
struct ExperimentSeries {
  enum class Role {
    measured,   ///< by the simulation: points and the line through them
    points,     ///< the same, points alone
    predicted,  ///< a curve
    published   ///< points of the source
  };
  std::string name;
  Role role = Role::measured;
  std::vector<double> x, y;  ///< equal lengths, in the axes' units; NaN where there is no value
  bool in_legend = true;
  std::vector<double> y_scatter = {};  ///< standard deviation over seeds at each point; empty: not known
};

struct ExperimentAxis {
  std::string label;  ///< with unit
  bool logarithmic = false;
  double lower =
      std::numeric_limits<double>::quiet_NaN();  ///< NaN: from the data; so is 0 below negative ones
  double upper = std::numeric_limits<double>::quiet_NaN();
};

/// A chart: measurement and prediction over one quantity.
struct ExperimentChart {
  std::string name;  ///< of its files, without ending
  std::string title, subtitle, note;
  ExperimentAxis x, y;
  std::vector<ExperimentSeries> series;
  bool first_seed_only = false;  ///< of events at other instants with each seed, whose mean is no event
};

/// A limit that was determined.
struct ExperimentLimit {
  std::string name;
  double measured = 0;                                          ///< NaN: no value
  double predicted = std::numeric_limits<double>::quiet_NaN();  ///< NaN: no theory
  std::string unit;
  std::string source;  ///< of the prediction
};

/// A published figure, as the experiment has it.
struct ExperimentFigure {
  std::string id;    ///< of sample_tools/laboratory/published_figures.csv
  double value = 0;  ///< in its unit; NaN: not found
  std::string how;   ///< what was measured, where the figure's name leaves that open
  double grain_diameter = std::numeric_limits<double>::quiet_NaN();  ///< m, the coarsest of its runs
};

/// All that one experiment found.
struct ExperimentResult {
  std::string name, question;
  bool quick = false;
  double cpu_seconds = 0;
  std::vector<ExperimentLimit> limits;
  std::vector<ExperimentFigure> figures;
  std::vector<ExperimentChart> charts;
};

/// Writes `<experiment>.json` and a `<chart>.csv` for every chart into the directory: one row a point with x,
/// series, role, y and, in charts of several seeds, the standard deviation. Throws ResultError when that
/// fails.
void write_experiment(const std::filesystem::path& directory, const ExperimentResult& result);

/// Writes `<chart>.csv` alone. Throws ResultError when that fails.
void write_chart(const std::filesystem::path& directory, const ExperimentChart& chart);

/// Writes the table of all limits as `<name>.csv` and `<name>.json`. Throws ResultError when that fails.
void write_limits(const std::filesystem::path& directory, const std::string& name,
                  const std::vector<ExperimentResult>& results);

}  // namespace diefill::results
