#include "render/report/sections/over_time.h"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "process/results/figure_table.h"
#include "process/results/probe_columns.h"
#include "render/report/pictures_of.h"

namespace diefill::render::report {
namespace {

using results::FillResult;
using results::ProbeColumn;
using results::ProbeSeries;

constexpr std::size_t kMaxCharts = 12;
constexpr const char* kZoneColumn = "solid fraction";
constexpr std::size_t kManyRows = 40;  // beyond, marks on the curve run into each other

std::string part_behind(const std::string& name) {
  return name.substr(name.find('/') + 1);
}

std::vector<std::string> words_in(const std::string& name) {
  std::istringstream text(name);
  return {std::istream_iterator<std::string>(text), {}};
}

/// The columns named, one curve each.
Chart chart_of(const FillResult& result, const std::string& title, const std::vector<std::string>& names) {
  Chart chart;
  chart.title = results::capitalised(title);
  chart.x.label = "Time [s]";
  std::string unit;
  for (const std::string& name : names) {
    const ProbeColumn column = results::in_shown_unit(*results::find_column(result, name));
    Curve curve;
    curve.name = part_behind(name);
    curve.x = column.time;
    curve.y = column.values;
    curve.style = column.time.size() > kManyRows ? CurveStyle::kLine : CurveStyle::kLineAndMarkers;
    unit = column.unit == "1" ? "" : " [" + column.unit + ']';
    chart.curves.push_back(std::move(curve));
  }
  std::vector<std::string> parts;
  for (const Curve& curve : chart.curves) parts.push_back(curve.name);
  chart.y.label = results::capitalised(common_words(parts)) + unit;
  if (chart.curves.size() == 1) chart.curves.front().name.clear();
  return chart;
}

/// A probe of the scene may have a name like a zone's, but not its columns.
bool is_zone(const ProbeSeries& probe) {
  return probe.name.starts_with(results::kZoneProbe) && probe.columns.back() == kZoneColumn;
}

/// The solid fraction of every zone, named by the zones.
Chart zones_chart(const FillResult& result) {
  std::vector<std::string> names, zones;
  for (const ProbeSeries& probe : result.probes)
    if (is_zone(probe)) {
      names.push_back(probe.name + '/' + kZoneColumn);
      zones.push_back(probe.name.substr(std::string(results::kZoneProbe).size()));
    }
  Chart chart = chart_of(result, "Solid fraction of zones", names);
  chart.y.label = "Solid fraction";
  for (std::size_t k = 0; k < zones.size(); ++k) chart.curves[k].name = zones[k];
  return chart;
}

bool has_points(const Chart& chart) {
  return std::any_of(chart.curves.begin(), chart.curves.end(), [](const Curve& curve) {
    return std::any_of(curve.y.begin(), curve.y.end(), [](double value) { return value == value; });
  });
}

}  // namespace

std::string common_words(const std::vector<std::string>& names) {
  std::vector<std::string> first = words_in(names.front()), last = first;
  for (const std::string& name : names) {
    const auto words = words_in(name);
    first.erase(std::mismatch(first.begin(), first.end(), words.begin(), words.end()).first, first.end());
    const auto differ = std::mismatch(last.rbegin(), last.rend(), words.rbegin(), words.rend()).first;
    last.erase(last.begin(), differ.base());
  }
  std::string common;
  for (const std::string& word : first.empty() ? last : first) common += (common.empty() ? "" : " ") + word;
  return common.empty() ? "value" : common;
}

Section over_time_section(const FillResult& result) {
  Section section{"Over time", 1, {}};
  std::vector<Figure> figures;
  const auto add = [&](const Chart& chart, const std::string& caption) {
    if (has_points(chart) && figures.size() < kMaxCharts) figures.push_back(chart_picture(chart, caption));
  };
  if (std::any_of(result.probes.begin(), result.probes.end(), is_zone))
    add(zones_chart(result), "Zones at the stored instants; no value on too few grains.");
  for (const ProbeSeries& probe : result.probes)
    if (!is_zone(probe) && probe.columns.size() > 1)
      add(chart_of(result, probe.name, results::columns_of_one_unit(probe)),
          "Recorded by \"" + probe.name + "\".");
  if (!figures.empty()) section.blocks.emplace_back(Figures{figures, true});
  return section;
}

}  // namespace diefill::render::report
