// What the uncertainty of a calibrated powder does to the figures of a filled die, beside the scatter over
// seeds.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace diefill::results {

/// One figure over both sets of runs. Numbers in `unit`; NaN: not known.
struct SpreadFigure {
  std::string key, name, unit;
  std::vector<double> of_seeds;    ///< of the best powder, a run for each seed; NaN: no value
  std::vector<double> of_powders;  ///< of powders that agree with the data, each with a seed of its own
  double best = 0;                 ///< mean of the best powder
  double scatter = 0;              ///< standard deviation over seeds
  double mean = 0;                 ///< over powders
  double spread = 0;               ///< standard deviation over powders, scatter over seeds included
  double powder =
      0;  ///< what of it the powder adds: root of spread^2 less scatter^2, 0 where that is below 0
  /// Whether chance alone makes the ratio of the variances as large in less than 10 % of cases; otherwise
  /// `powder` is a number by chance.
  bool significant = false;
};

struct PowderSpread {
  std::string title, powder_file, command, program_version;
  std::vector<std::string> keys, units;      ///< of the parameters
  std::vector<double> best;                  ///< parameters of the best powder
  std::vector<std::vector<double>> powders;  ///< parameters of the others
  std::vector<SpreadFigure> figures;
  std::vector<std::string> failed;  ///< runs without results, with the reason
};

/// In one sentence, such as "filled mass 12.1 g: +-0.3 g by the powder, +-0.1 g over seeds", or that the two
/// cannot be distinguished; where runs lack a value, how many have one.
std::string spread_text(const SpreadFigure& figure);

/// Writes `directory`/powder_samples.json and powder_samples.csv, each whole or not at all. Throws
/// ResultError.
void write_powder_spread(const std::filesystem::path& directory, const PowderSpread& spread);

}  // namespace diefill::results
