// Cost against error: what settings of a scene cost and how large their errors are, as tradeoff.json and
// tradeoff.csv, and for charts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace diefill::results {

/// A number that settings are judged by.
struct TradeoffQuantity {
  std::string key;          ///< such as "filled_mass"
  std::string column = {};  ///< heading in tradeoff.csv, name in tradeoff.json; empty: `name`
  std::string name;         ///< for people
  std::string unit;         ///< such as "g"; "1" for ratios
  bool decides = true;      ///< counts in TradeoffPoint::error; others are for information
  std::string scale = {};   ///< key of the quantity whose reference errors are fractions of; empty: its own
  double reference = 0;     ///< mean of the reference setting, or the target; NaN where there is none
  bool is_target = false;   ///< a published value took the place of the reference setting's
  double scatter = 0;       ///< over seeds, pooled over all settings, over the scale; NaN: not known
  /// Error over the scale that seeds alone explain (95 %) of a setting with the most seeds; NaN: not known.
  double floor = 0;

  const std::string& name_in_files() const { return column.empty() ? name : column; }
};

/// A quantity of one setting over its seeds. NaN: no value.
struct TradeoffValue {
  double mean = 0;
  double scatter = 0;       ///< standard deviation of a sample; NaN for fewer than two seeds
  std::uint64_t seeds = 0;  ///< runs with a value
  double error = 0;         ///< distance from the reference over the quantity's scale
  /// Error over the scale that the seeds of this setting and of the reference alone explain (95 %). Not
  /// stored.
  double floor = std::numeric_limits<double>::quiet_NaN();
};

/// One value of one parameter.
struct ParameterChange {
  std::string parameter, value;  ///< as --vary takes them
};

/// One setting.
struct TradeoffPoint {
  std::string name;   ///< such as "grain_diameter=1.88 mm"; "base" for the scene as it stands
  std::string label;  ///< as short as a chart needs it, such as "d 1.88 mm"
  std::vector<ParameterChange> changes;  ///< of the base
  std::string state;                     ///< finished, failed, left out or refused
  std::string reason;                    ///< why not finished; empty otherwise
  std::uint64_t seeds = 0;               ///< finished runs
  double core_seconds = 0;             ///< s of processor time of a run, mean over seeds; NaN: none finished
  double core_seconds_per_second = 0;  ///< the same over the simulated time
  double wall_seconds = 0;             ///< s by the clock, mean over seeds
  double peak_memory_bytes = 0;        ///< largest resident set
  std::vector<TradeoffValue> values;   ///< in the order of Tradeoff::quantities
  double error = 0;                    ///< largest of the deciding quantities' errors; NaN: none
  std::string worst;                   ///< key of the quantity with that error
  std::vector<std::string> beyond;     ///< keys of deciding quantities with errors above their own limits
  bool reference = false, recommended = false, pareto = false;
};

/// Settings that differ in one parameter alone, coarsest first where the parameter has an order.
struct ParameterRow {
  std::string name, label;          ///< as --vary spells it; for people, such as "grain diameter d"
  std::vector<std::size_t> points;  ///< into Tradeoff::points
  std::vector<std::string> values;  ///< one for each
};

struct Tradeoff {
  std::string title;    ///< of the scene
  std::string command;  ///< that made it
  std::vector<TradeoffQuantity> quantities;
  std::vector<TradeoffPoint> points;  ///< the base first
  std::vector<ParameterRow> parameters;
  double floor = 0;      ///< largest of the deciding quantities' floors; NaN: not known, a single seed
  double tolerance = 0;  ///< error that the user accepts
  std::string advice;    ///< which setting to take, and why, in a sentence
  std::vector<std::string> remarks;  ///< what was left out, and why
};

/// Writes `directory`/tradeoff.json and tradeoff.csv, each whole or not at all. Throws ResultError.
void write_tradeoff(const std::filesystem::path& directory, const Tradeoff& tradeoff);

}  // namespace diefill::results
