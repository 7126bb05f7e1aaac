// Columns of what probes recorded, by name, so that any can be drawn against any other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::results {

/// How the tables of zones are named, before the zone's own name.
inline constexpr const char* kZoneProbe = "zone ";

/// One column of a probe.
struct ProbeColumn {
  std::string name;          ///< "PROBE/COLUMN"
  std::string unit;          ///< of `values`
  std::vector<double> time;  ///< s
  std::vector<double> values;
};

/// Names of all columns, "PROBE/COLUMN"; the times are none.
std::vector<std::string> column_names(const FillResult& result);

/// Names of the columns of one probe that have the unit of its first column after the time: what one chart
/// can show of it.
std::vector<std::string> columns_of_one_unit(const ProbeSeries& probe);

/// The column "PROBE/COLUMN"; "PROBE" alone stands for its first column after the time. None of another name.
std::optional<ProbeColumn> find_column(const FillResult& result, const std::string& name);

/// The same column in the unit that users read: g for kg, mm for m.
ProbeColumn in_shown_unit(ProbeColumn column);

/// The column's values at other times (s), linear between its rows; NaN before the first and after the last.
std::vector<double> values_at(const ProbeColumn& column, const std::vector<double>& times);

}  // namespace diefill::results
