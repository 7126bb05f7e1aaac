#include "process/results/probe_columns.h"

#include <algorithm>
#include <limits>

namespace diefill::results {
namespace {

constexpr std::size_t kFirst = 1;  // column after the time

std::string full_name(const ProbeSeries& probe, std::size_t column) {
  return probe.name + '/' + probe.columns[column];
}

std::vector<double> values_of(const ProbeSeries& probe, std::size_t column) {
  std::vector<double> values;
  for (std::size_t k = column; k < probe.values.size(); k += probe.columns.size())
    values.push_back(probe.values[k]);
  return values;
}

}  // namespace

std::vector<std::string> column_names(const FillResult& result) {
  std::vector<std::string> names;
  for (const ProbeSeries& probe : result.probes)
    for (std::size_t c = kFirst; c < probe.columns.size(); ++c) names.push_back(full_name(probe, c));
  return names;
}

std::vector<std::string> columns_of_one_unit(const ProbeSeries& probe) {
  std::vector<std::string> names;
  for (std::size_t c = kFirst; c < probe.columns.size(); ++c)
    if (probe.units[c] == probe.units[kFirst]) names.push_back(full_name(probe, c));
  return names;
}

std::optional<ProbeColumn> find_column(const FillResult& result, const std::string& name) {
  for (const ProbeSeries& probe : result.probes)
    for (std::size_t c = kFirst; c < probe.columns.size(); ++c)
      if (name == full_name(probe, c) || (c == kFirst && name == probe.name))
        return ProbeColumn{full_name(probe, c), probe.units[c], values_of(probe, 0), values_of(probe, c)};
  return std::nullopt;
}

ProbeColumn in_shown_unit(ProbeColumn column) {
  struct Shown {
    const char* from;
    const char* to;
  };
  constexpr double kThousand = 1000;
  for (const Shown& unit : {Shown{"kg", "g"}, Shown{"kg/s", "g/s"}, Shown{"m", "mm"}}) {
    if (column.unit != unit.from) continue;
    column.unit = unit.to;
    for (double& value : column.values) value *= kThousand;
    break;
  }
  return column;
}

std::vector<double> values_at(const ProbeColumn& column, const std::vector<double>& times) {
  std::vector<double> values;
  for (const double time : times) {
    const auto after = std::lower_bound(column.time.begin(), column.time.end(), time);
    const auto k = static_cast<std::size_t>(after - column.time.begin());
    if (after != column.time.end() && *after == time)
      values.push_back(column.values[k]);
    else if (k == 0 || after == column.time.end())
      values.push_back(std::numeric_limits<double>::quiet_NaN());
    else
      values.push_back(column.values[k - 1] + (column.values[k] - column.values[k - 1]) *
                                                  (time - column.time[k - 1]) /
                                                  (column.time[k] - column.time[k - 1]));
  }
  return values;
}

}  // namespace diefill::results
