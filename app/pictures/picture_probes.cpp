// What probes recorded: over time, or one column against another; all sources in one chart.
#include <algorithm>
#include <functional>
#include <stdexcept>

#include "app/pictures/picture_files.h"
#include "process/input/nearest_key.h"
#include "process/results/figure_table.h"
#include "process/results/probe_columns.h"

namespace diefill::app {
namespace {

using results::ProbeColumn;

void require_probes(const results::FillResult& result) {
  if (result.probes.empty())
    throw std::invalid_argument(
        "the results contain nothing recorded over time; add a [[probe]] to the scene, or [[measure.zone]] "
        "with measure.snapshot_interval, and run it again");
}

ProbeColumn column_of(const results::FillResult& result, const std::string& option, const std::string& name) {
  require_probes(result);
  if (const auto column = results::find_column(result, name)) return results::in_shown_unit(*column);
  const std::vector<std::string> names = results::column_names(result);
  std::string message = option + ": found \"" + name + "\"";
  const auto nearest = process::nearest_key(name, names);
  message += nearest ? "; did you mean \"" + *nearest + "\"? Allowed:" : "; allowed:";
  for (const std::string& known : names) message += (known == names.front() ? " \"" : ", \"") + known + '"';
  throw std::invalid_argument(message);
}

std::vector<ProbeColumn> columns_of(const PictureRequest& request, const PictureSource& source) {
  require_probes(request.sources.front().result);
  const auto names = request.y.empty()
                         ? results::columns_of_one_unit(request.sources.front().result.probes.front())
                         : request.y;
  std::vector<ProbeColumn> columns;
  for (const auto& name : names) columns.push_back(column_of(source.result, "--y", name));
  for (const ProbeColumn& one : columns)
    if (one.unit != columns.front().unit)
      throw std::invalid_argument("--y: found \"" + one.name + "\" in " + one.unit + " and \"" +
                                  columns.front().name + "\" in " + columns.front().unit +
                                  ", allowed: columns of one unit; draw the others apart");
  return columns;
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit == "1" ? name : name + " [" + unit + ']';
}

/// Name of the axis of several columns: what they have in common, the probe or the column.
std::string axis_name(const std::vector<ProbeColumn>& columns) {
  const auto probe = [](const ProbeColumn& one) { return one.name.substr(0, one.name.find('/')); };
  const auto column = [](const ProbeColumn& one) { return one.name.substr(one.name.find('/') + 1); };
  const ProbeColumn& first = columns.front();
  if (columns.size() == 1) return probe(first) == column(first) ? column(first) : first.name;
  for (const auto& part : {std::function<std::string(const ProbeColumn&)>(column),
                           std::function<std::string(const ProbeColumn&)>(probe)})
    if (std::all_of(columns.begin(), columns.end(),
                    [&](const ProbeColumn& one) { return part(one) == part(first); }))
      return part(first);
  return "value";
}

std::string curve_name(const std::string& run, const ProbeColumn& column, bool several) {
  if (!several) return run;
  return run.empty() ? column.name : run + ": " + column.name;
}

}  // namespace

Pictures make_probe_chart(const PictureRequest& request) {
  render::Chart chart;
  chart.x.label = "Time [s]";
  for (const PictureSource& source : request.sources) {
    const auto columns = columns_of(request, source);
    if (chart.curves.empty())
      chart.y.label = results::capitalised(with_unit(axis_name(columns), columns.front().unit));
    for (const ProbeColumn& column : columns) {
      render::Curve curve;
      curve.name = curve_name(legend_of(request, source), column, columns.size() > 1);
      curve.x = column.time;
      curve.y = column.values;
      if (!request.x.empty()) {
        const ProbeColumn along = column_of(source.result, "--x", request.x);
        curve.x = results::values_at(along, column.time);
        chart.x.label = results::capitalised(with_unit(along.name, along.unit));
      }
      chart.curves.push_back(std::move(curve));
    }
  }
  const PictureSource& first = request.sources.front();
  const bool alone = request.sources.size() == 1;
  chart.title = alone ? title_of(request, first) : chart.y.label;
  chart.subtitle = alone ? subtitle_of(first) : std::string();
  return write_chart(request, "probe", std::move(chart));
}

}  // namespace diefill::app
