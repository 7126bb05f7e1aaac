// Ways of filling side by side: every measure of every variant with its scatter over seeds, and whether it
// differs from the first variant by more than that. Stored as comparison.json and comparison.csv.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::results {

/// What can be said of a difference from the first variant.
enum class Verdict {
  reference,        ///< this is the first variant
  none,             ///< within the 95 % interval of Welch: no difference is seen
  different,        ///< beyond it
  scatter_unknown,  ///< one of the two has a single seed
  missing           ///< one of the two has no value
};

/// Such as "none" or "scatter unknown".
std::string description(Verdict verdict);

/// One measure of one variant over its seeds. NaN: no value.
struct ComparedValue {
  double mean = 0;
  double scatter = 0;       ///< standard deviation over seeds (of a sample); NaN for fewer than two
  std::uint64_t seeds = 0;  ///< runs with a value
  double difference = 0;    ///< mean less that of the first variant; the shorter way round for angles
  double interval = 0;      ///< half width of the 95 % interval of the difference (Welch)
  Verdict verdict = Verdict::missing;
};

/// One measure of all variants, in their order.
struct ComparedMeasure {
  std::string key;   ///< of `ComparedRun::values`
  std::string name;  ///< for people
  std::string unit;  ///< such as "g"; "1" for ratios
  std::vector<ComparedValue> values;
};

/// One run of the comparison.
struct ComparedRun {
  std::string variant, folder;
  std::uint64_t seed = 0;
  std::string state;   ///< finished, failed or not finished
  std::string reason;  ///< why it failed, or lacks values of a measure; empty otherwise
  int exit_code = 0;   ///< of a run that failed
  std::string state_hash;
  std::map<std::string, double> values;  ///< by ComparedMeasure::key, in its unit
};

struct Comparison {
  std::string title;
  std::vector<std::string> variants;
  std::vector<ComparedMeasure> measures;
  std::vector<ComparedRun> runs;
  /// Per variant the solid fraction over angle and height (or in the first section, of cavities that are no
  /// rings), mean over its seeds; without nodes where no run is finished. Not stored.
  std::vector<Field2D> fields;
  std::vector<std::size_t> field_seeds;  ///< how many seeds each of them is the mean of
};

/// How the numbers are to be read: what scatter, interval and "none" mean.
std::string statistics_text();

/// Writes `directory`/comparison.json, with figures in the units of report.json, since keys name them, and
/// comparison.csv, with units that people read. Every key of a run's values is one of a measure. Each whole
/// or not at all. Throws ResultError.
void write_comparison(const std::filesystem::path& directory, const Comparison& comparison);

}  // namespace diefill::results
