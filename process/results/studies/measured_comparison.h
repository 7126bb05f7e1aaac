// A simulated profile or map compared with a measured one: difference and correlation, in all and zone
// by zone.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace diefill::results {

/// Statistics over the points of a zone that have a simulated value. NaN: too few of them.
struct MeasuredZone {
  std::string name;  ///< such as "all", "0 to 90 deg", or a zone of the scene
  std::size_t points = 0;
  double measured = 0, simulated = 0;  ///< means
  double rms = 0;                      ///< root of the mean square difference
  double correlation = 0;              ///< pearson_correlation()
};

/// Numbers in `unit`, places in their own units.
struct MeasuredComparison {
  std::string name;            ///< of the measured file, without folder and ending
  std::string quantity, unit;  ///< what is measured
  std::string first_name, first_unit, second_name, second_unit;  ///< second empty: a profile
  std::vector<double> first, second, measured;
  std::vector<double> deviation;    ///< standard deviation of the measured value; NaN: not given
  std::vector<double> simulated;    ///< NaN: none there
  std::vector<MeasuredZone> zones;  ///< "all" first

  bool is_map() const { return !second_name.empty(); }
};

/// Writes `directory`/measured_<name>.csv, point by point, and measured_<name>_zones.csv, each whole or not
/// at all; returns their names. Throws ResultError.
std::vector<std::filesystem::path> write_measured_comparison(const std::filesystem::path& directory,
                                                             const MeasuredComparison& comparison);

}  // namespace diefill::results
