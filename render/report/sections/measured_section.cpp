#include "render/report/sections/measured_section.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

#include "process/results/figure_table.h"
#include "process/results/none.h"
#include "process/results/rounding.h"
#include "render/report/numbers.h"
#include "render/report/pictures_of.h"

namespace diefill::render::report {
namespace {

using results::MeasuredComparison;

std::vector<double> differences(const MeasuredComparison& comparison) {
  std::vector<double> values;
  for (std::size_t k = 0; k < comparison.measured.size(); ++k)
    values.push_back(comparison.simulated[k] - comparison.measured[k]);
  return values;
}

/// In one line, such as "mean difference 0.2 mm, rms 0.4 mm, correlation 0.9".
std::string comparison_line(const MeasuredComparison& comparison) {
  const auto& all = comparison.zones.front();
  const std::string unit = results::unit_behind(comparison.unit);
  return "simulated less measured: mean " + in_digits(all.simulated - all.measured, 2) + unit + ", rms " +
         in_digits(all.rms, 2) + unit + ", correlation " + in_digits(all.correlation, 2);
}

/// Of places without a simulated value, a sentence; empty where there are none.
std::string places_left_out(const MeasuredComparison& comparison) {
  const std::size_t outside = comparison.measured.size() - comparison.zones.front().points;
  if (outside == 0) return {};
  return std::to_string(outside) + " of " + std::to_string(comparison.measured.size()) +
         " measured places have no simulated value and do not count.";
}

Chart chart_over_first(const MeasuredComparison& comparison) {
  Chart chart;
  chart.subtitle = comparison_line(comparison);
  chart.x.label = with_unit_of(results::capitalised(comparison.first_name), comparison.first_unit);
  chart.y.label = with_unit_of(results::capitalised(comparison.quantity), comparison.unit);
  return chart;
}

std::vector<double> known_deviations(const MeasuredComparison& comparison) {
  const bool known = std::all_of(comparison.deviation.begin(), comparison.deviation.end(),
                                 [](double value) { return std::isfinite(value); });
  return known ? comparison.deviation : std::vector<double>{};
}

std::vector<MeasuredPicture> profile_pictures(const MeasuredComparison& comparison) {
  const std::string what = comparison.quantity + " over " + comparison.first_name + ", " + comparison.name;
  Chart both = chart_over_first(comparison);
  both.title = "Measured and simulated " + what;
  both.curves = {
      {"measured", comparison.first, comparison.measured, CurveStyle::kMarkers, known_deviations(comparison)},
      {"simulated", comparison.first, comparison.simulated, CurveStyle::kLine, {}}};
  Chart difference = chart_over_first(comparison);
  difference.title = "Simulated minus measured " + what;
  difference.y.label = "Difference" + (comparison.unit == "1" ? "" : " [" + comparison.unit + "]");
  const auto [least, most] = std::minmax_element(comparison.first.begin(), comparison.first.end());
  difference.curves = {{"", {*least, *most}, {0, 0}, CurveStyle::kReference, {}},
                       {"", comparison.first, differences(comparison), CurveStyle::kLineAndMarkers,
                        known_deviations(comparison)}};
  return {{"", chart_picture(both, "measured and simulated " + what)},
          {"_difference", chart_picture(difference, "difference of " + what)}};
}

/// The points as a field; without nodes where they are no grid.
results::Field2D field_of(const MeasuredComparison& comparison, const std::vector<double>& values) {
  const std::set<double> first(comparison.first.begin(), comparison.first.end()),
      second(comparison.second.begin(), comparison.second.end());
  results::Field2D field{comparison.quantity,
                         comparison.first_name,
                         comparison.first_unit,
                         comparison.second_name,
                         comparison.second_unit,
                         {first.begin(), first.end()},
                         {second.begin(), second.end()},
                         {},
                         0};
  // Places that fill less than half of a grid do not lie on one.
  if (2 * values.size() < first.size() * second.size() || first.size() < 2 || second.size() < 2) return {};
  field.value.assign(first.size() * second.size(), kNone);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto i = std::lower_bound(field.first.begin(), field.first.end(), comparison.first[k]),
               j = std::lower_bound(field.second.begin(), field.second.end(), comparison.second[k]);
    field.value[static_cast<std::size_t>(j - field.second.begin()) * field.first.size() +
                static_cast<std::size_t>(i - field.first.begin())] = values[k];
  }
  return field;
}

ColourRange range_of(const MeasuredComparison& comparison) {
  ColourRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const auto* values : {&comparison.measured, &comparison.simulated})
    for (const double value : *values)
      if (std::isfinite(value)) range = {std::min(range.lower, value), std::max(range.upper, value)};
  return range.upper > range.lower ? range : kRangeFromData;
}

MeasuredPicture scatter_picture(const MeasuredComparison& comparison) {
  Chart chart;
  chart.title = "Simulated over measured " + comparison.quantity + ", " + comparison.name;
  chart.subtitle = comparison_line(comparison);
  chart.x.label = with_unit_of("Measured " + comparison.quantity, comparison.unit);
  chart.y.label = with_unit_of("Simulated " + comparison.quantity, comparison.unit);
  const ColourRange range = range_of(comparison);
  chart.curves = {
      {"equal", {range.lower, range.upper}, {range.lower, range.upper}, CurveStyle::kReference, {}},
      {"points", comparison.measured, comparison.simulated, CurveStyle::kMarkers, {}}};
  return {"_scatter", chart_picture(chart, "simulated over measured " + comparison.quantity)};
}

std::vector<MeasuredPicture> map_pictures(const MeasuredComparison& comparison) {
  std::vector<MeasuredPicture> pictures;
  const auto measured = field_of(comparison, comparison.measured);
  if (!measured.value.empty()) {
    const ColourRange range = range_of(comparison);
    FieldStyle style;
    style.unit = comparison.unit == "1" ? "" : comparison.unit;
    const std::string what = comparison.quantity + ", " + comparison.name;
    pictures.push_back(
        {"", field_picture(measured, "Measured " + what, "", range, "measured " + what, style)});
    pictures.push_back(
        {"_simulated", field_picture(field_of(comparison, comparison.simulated), "Simulated " + what,
                                     "at the measured places", range, "simulated " + what, style)});
    style.scale_label = "difference of " + comparison.quantity;
    pictures.push_back(
        {"_difference",
         difference_picture(field_of(comparison, differences(comparison)), "Difference of " + what,
                            comparison_line(comparison), "simulated less measured " + what, style)});
  }
  pictures.push_back(scatter_picture(comparison));
  return pictures;
}

Table table_of(const MeasuredComparison& comparison) {
  const std::string of = comparison.unit == "1" ? "" : " [" + comparison.unit + "]";
  Table table{comparison.name + ": " + comparison.quantity + ", zone by zone",
              {"Zone", "Points", "Measured" + of, "Simulated" + of, "Difference" + of, "RMS difference" + of,
               "Correlation"},
              {},
              true};
  using Zone = results::MeasuredZone;
  const auto& zones = comparison.zones;
  const auto measured = column_of(zones, &Zone::measured, 3),
             simulated = column_of(zones, &Zone::simulated, 3), rms = column_of(zones, &Zone::rms, 2),
             correlation = column_of(zones, &Zone::correlation, 2);
  const auto difference = column_of(
      zones, [](const Zone& zone) { return zone.simulated - zone.measured; }, 2);
  for (std::size_t k = 0; k < zones.size(); ++k)
    table.rows.push_back({zones[k].name, std::to_string(zones[k].points), measured[k], simulated[k],
                          difference[k], rms[k], correlation[k]});
  return table;
}

}  // namespace

std::vector<MeasuredPicture> measured_pictures(const MeasuredComparison& comparison) {
  return comparison.is_map() ? map_pictures(comparison) : profile_pictures(comparison);
}

Section measured_section(const std::vector<MeasuredComparison>& comparisons, int level) {
  Section section{"Against measured data", level, {}};
  for (const MeasuredComparison& comparison : comparisons) {
    section.blocks.emplace_back(Paragraph{comparison.name + ", " + comparison_line(comparison) + '.'});
    if (std::string left_out = places_left_out(comparison); !left_out.empty())
      section.blocks.emplace_back(Paragraph{std::move(left_out), true});
    section.blocks.emplace_back(table_of(comparison));
    Figures figures{{}, true};
    for (auto& picture : measured_pictures(comparison)) figures.figures.push_back(std::move(picture.figure));
    section.blocks.emplace_back(std::move(figures));
  }
  return section;
}

std::string measured_text(const MeasuredComparison& comparison) {
  std::string text = comparison.name + ", " + comparison_line(comparison) + '\n';
  if (const std::string left_out = places_left_out(comparison); !left_out.empty())
    text += "  " + left_out + '\n';
  for (const auto& zone : comparison.zones) {
    char line[240];
    std::snprintf(line, sizeof line,
                  "  %-32s %5zu points  measured %-9s simulated %-9s rms %-9s correlation %s\n",
                  zone.name.c_str(), zone.points, in_digits(zone.measured, 3).c_str(),
                  in_digits(zone.simulated, 3).c_str(), in_digits(zone.rms, 2).c_str(),
                  in_digits(zone.correlation, 2).c_str());
    text += line;
  }
  return text;
}

}  // namespace diefill::render::report
