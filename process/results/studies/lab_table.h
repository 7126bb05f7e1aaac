// Table of an experiment of the laboratory: published figures and what the simulation has in their place,
// with scatter over seeds, verdict and cost. Stored as <experiment>.json and <experiment>.csv.
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace diefill::results {

/// One quantity. NaN: none.
struct LabRow {
  std::string id;  ///< of the published figure; of quantities without one the experiment's own
  std::string quantity, setting, unit;
  std::string published;                                    ///< number, or "trend"; empty: not published
  double lower = std::numeric_limits<double>::quiet_NaN();  ///< in `unit`, smallest value that agrees
  double upper = std::numeric_limits<double>::quiet_NaN();  ///< the same, largest
  std::vector<double> values;                               ///< of the seeds that have one, in `unit`
  std::string verdict;                                      ///< "met", "not met", "no value" or "-"
  std::string reason;                                       ///< why there is no value, or how it was had
  double grain_diameter = std::numeric_limits<double>::quiet_NaN();  ///< m, the coarsest of its runs
  double core_seconds = 0;  ///< s of processor time of its runs, those of other quantities among them
  std::size_t seeds = 0;    ///< that one value follows from together, such as a scatter; 0: a value of each
};

/// How many seeds the row rests on.
std::size_t seeds_of(const LabRow& row);

/// Mean of the row's values, NaN for none; and their standard deviation, NaN for fewer than two.
double mean_of(const LabRow& row);
double scatter_of(const LabRow& row);

/// "0.59 (0.575 to 0.605)" of a row: published value and range.
std::string published_text(const LabRow& row);
/// Mean with scatter, such as "0.5995 +- 0.0012"; "-" without a value.
std::string here_text(const LabRow& row);

struct LabTable {
  std::string experiment, question, size, powder, program_version;
  int seeds = 1;
  double core_seconds = 0;  ///< of all runs of the experiment
  std::vector<LabRow> rows;
};

/// Writes `directory`/<experiment>.json and .csv, each whole or not at all. Throws ResultError.
void write_lab_table(const std::filesystem::path& directory, const LabTable& table);

/// Reads `directory`/<experiment>.json. Throws ResultError, in one line, where it is missing or is no such
/// table.
LabTable read_lab_table(const std::filesystem::path& directory, const std::string& experiment);

}  // namespace diefill::results
