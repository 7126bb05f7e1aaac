#include "render/report/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "process/results/figure_table.h"
#include "process/results/rounding.h"
#include "render/fields/field_places.h"
#include "render/report/figure_text.h"
#include "render/report/pictures_of.h"
#include "render/report/sections/speed_series.h"
#include "render/style/ticks.h"

namespace diefill::render::report {
namespace {

/// Columns of the ranking.
constexpr std::array kColumns = {"expected_mass_kg", "estimated_mass_kg", "fill_ratio",
                                 "fill_height_mm",   "cycle_time_s",      "azimuthal_variation",
                                 "axial_variation",  "filled_mass_kg",    "fill_density_kg_m3"};

/// A figure of the strategy in the unit in which it is read.
Scatter as_read(const Strategy& strategy, const char* figure) {
  const Scatter value = strategy.of(figure);
  return {in_shown_unit(figure, value.mean), in_shown_unit(figure, value.deviation), value.count};
}

/// What strategies are ranked by.
struct Merit {
  const char* figure;
  double sign;  ///< -1: the lowest comes first
  const char* order;
};

/// The first of these that all strategies have decides: even filling before much of it, since uneven density
/// is what warps the sintered part.
const Merit& merit_for(const std::vector<Strategy>& strategies) {
  static constexpr std::array kMerits = {
      Merit{"azimuthal_variation", -1, "lowest first"}, Merit{"fill_ratio", 1, "highest first"},
      Merit{"fill_density_kg_m3", 1, "highest first"}, Merit{"filled_mass_kg", 1, "highest first"}};
  const auto* found = std::find_if(kMerits.begin(), kMerits.end(), [&](const Merit& merit) {
    return std::all_of(strategies.begin(), strategies.end(), [&](const Strategy& strategy) {
      return std::isfinite(strategy.of(merit.figure).mean);
    });
  });
  return found == kMerits.end() ? kMerits.back() : *found;
}

/// Strategies by falling merit, those whose merit is not known last.
std::vector<const Strategy*> ranked(const std::vector<Strategy>& strategies, const Merit& by) {
  const auto merit = [&](const Strategy& strategy) {
    const double value = by.sign * strategy.of(by.figure).mean;
    return std::isfinite(value) ? value : -std::numeric_limits<double>::infinity();
  };
  std::vector<const Strategy*> order;
  for (const auto& strategy : strategies) order.push_back(&strategy);
  std::stable_sort(order.begin(), order.end(),
                   [&](const Strategy* a, const Strategy* b) { return merit(*a) > merit(*b); });
  return order;
}

void add_column(Table& table, const std::vector<const Strategy*>& rows, const char* figure) {
  std::vector<Scatter> values;
  for (const Strategy* strategy : rows) values.push_back(as_read(*strategy, figure));
  const auto texts = as_texts(values, 3);
  table.header.push_back(column_title(figure));
  for (std::size_t k = 0; k < rows.size(); ++k) table.rows[k].push_back(texts[k]);
}

Section ranking(const std::vector<Strategy>& strategies) {
  Section section{"Ranking", 1, {}};
  const Merit& merit = merit_for(strategies);
  Table table{"By " + results::short_label(results::figure_called(merit.figure)) + ", " + merit.order +
                  "; ± is the standard deviation over seeds",
              {"Strategy", "Runs"},
              {},
              true};
  const auto order = ranked(strategies, merit);
  for (const Strategy* strategy : order)
    table.rows.push_back({strategy->name, std::to_string(strategy->runs.size())});
  for (const char* column : kColumns) add_column(table, order, column);
  add_column(table, order, "solid_fraction_mean");
  leave_out_empty_columns(table);
  section.blocks.emplace_back(table);
  const bool single = std::any_of(strategies.begin(), strategies.end(),
                                  [](const Strategy& strategy) { return strategy.runs.size() < 2; });
  if (single)
    section.blocks.emplace_back(
        Paragraph{"The scatter of a strategy with a single run is unknown: a difference smaller than the "
                  "scatter over seeds is not significant. Run more seeds before deciding.",
                  true});
  return section;
}

/// The field that shows the most of a run: the map of a ring, or the first section.
const results::Field2D* main_field(const results::FillResult& result) {
  if (!result.maps.empty()) return &result.maps.front();
  return result.sections.empty() ? nullptr : &result.sections.front().field;
}

/// A strategy's field with what surrounds the powder on it.
Figure map_of(const Strategy& strategy, const results::Field2D& field, const ColourRange& range) {
  const auto& result = strategy.first();
  const std::string seed = strategy.runs.size() > 1 ? ", seed " + std::to_string(result.seed) + " of " +
                                                          std::to_string(strategy.runs.size()) + " runs"
                                                    : "";
  FieldStyle style;
  std::string subtitle = result.powder_name + seed;
  if (result.maps.empty()) {
    add_section_places(style, result, result.sections.front().plane);
    subtitle += ", " + section_text(result.sections.front().plane);
  } else {
    add_map_places(style, result, field);
  }
  return field_picture(field, strategy.name, subtitle, range, strategy.name + seed, style);
}

Section maps(const std::vector<Strategy>& strategies, const ColourRange& given) {
  Section section{"Maps on one scale", 1, {}};
  std::vector<const results::FillResult*> results;
  for (const auto& strategy : strategies) results.push_back(&strategy.first());
  const ColourRange range = std::isnan(given.lower) ? solid_fraction_range(results) : given;
  Figures figures{{}, true};
  for (const auto& strategy : strategies)
    if (const auto* field = main_field(strategy.first()); field != nullptr && !field->value.empty())
      figures.figures.push_back(map_of(strategy, *field, range));
  if (figures.figures.empty())
    section.blocks.emplace_back(Paragraph{"The results contain no maps."});
  else
    section.blocks.emplace_back(figures);
  return section;
}

const results::Profile* profile_like(const results::FillResult& result, const results::Profile& wanted) {
  for (const auto& profile : result.profiles)
    if (profile.quantity == wanted.quantity && profile.x_name == wanted.x_name &&
        profile.unit == wanted.unit && profile.x_unit == wanted.x_unit)
      return &profile;
  return nullptr;
}

/// The mean of a profile over a strategy's runs with the scatter as error bars; the first run's alone where
/// their abscissae differ.
Curve curve_of(const Strategy& strategy, const results::Profile& wanted) {
  Curve curve{strategy.name, {}, {}, CurveStyle::kLineAndMarkers, {}};
  const auto* first = profile_like(strategy.first(), wanted);
  if (first == nullptr) return curve;
  curve.x = first->x;
  if (curve.x.size() > 40) curve.style = CurveStyle::kLine;
  std::vector<const results::Profile*> same;
  for (const Run* run : strategy.runs)
    if (const auto* profile = profile_like(run->result, wanted))
      if (profile->x == first->x) same.push_back(profile);
  for (std::size_t n = 0; n < curve.x.size(); ++n) {
    std::vector<double> values;
    for (const auto* profile : same) values.push_back(profile->y[n]);
    const Scatter value = scatter(values);
    curve.y.push_back(value.mean);
    if (same.size() > 1) curve.y_error.push_back(value.deviation);  // NaN, no bar, where one run has a value
  }
  return curve;
}

std::string axis_name(const std::string& name, const std::string& unit) {
  return results::capitalised(name) + " [" + (unit.empty() ? "–" : unit == "deg" ? "°" : unit) + "]";
}

Section curves(const std::vector<Strategy>& strategies) {
  Section section{"Curves", 1, {}};
  Figures figures{{}, true};
  for (const auto& profile : strategies.front().first().profiles) {
    Chart chart;
    chart.title = axis_name(profile.quantity, profile.unit);
    chart.title.resize(chart.title.rfind(" ["));
    chart.x.label = axis_name(profile.x_name, profile.x_unit);
    chart.y.label = axis_name(profile.quantity, profile.unit);
    if (chart.x.in_degrees()) {
      chart.x.lower = 0;
      chart.x.upper = 360;
    }
    for (const auto& strategy : strategies) {
      Curve curve = curve_of(strategy, profile);
      if (!curve.x.empty()) chart.curves.push_back(curve);
    }
    figures.figures.push_back(
        chart_picture(chart, chart.title + " over " + profile.x_name +
                                 ". Bars: standard deviation over seeds, where there are several."));
  }
  if (figures.figures.empty())
    section.blocks.emplace_back(Paragraph{"The results contain no curves."});
  else
    section.blocks.emplace_back(figures);
  return section;
}

/// Lines of one scene that the other does not have.
std::string lines_missing(const std::vector<std::string>& from, std::vector<std::string> of) {
  std::string text;
  for (const auto& line : of)
    if (std::find(from.begin(), from.end(), line) == from.end()) text += (text.empty() ? "" : "; ") + line;
  return text.empty() ? "–" : text;
}

std::string change(const Scatter& value, const Scatter& reference) {
  if (!std::isfinite(value.mean) || !std::isfinite(reference.mean)) return "–";
  const double difference = value.mean - reference.mean;
  if (results::is_rounding(difference, reference.mean)) return "0";
  std::string text = (difference >= 0 ? "+" : "−") + in_digits(std::abs(difference), 3);
  if (reference.mean != 0)
    text += std::string(" (") + (difference >= 0 ? "+" : "−") +
            in_digits(std::abs(100 * difference / reference.mean), 2) + " %)";
  return text;
}

Section differences(const std::vector<Strategy>& strategies) {
  const Strategy& first = strategies.front();
  Section section{"Differences from \"" + first.name + "\"", 1, {}};
  Table figures{"Change of the mean", {"Strategy"}, {}, true};
  for (const char* column : kColumns) figures.header.push_back(column_title(column));
  Table scenes{"Lines of the scenes", {"Strategy", "Only in its scene", "Only in the first scene"}, {}};
  const auto reference = effective_lines(first.first().scene_text);
  for (std::size_t n = 1; n < strategies.size(); ++n) {
    std::vector<std::string> row = {strategies[n].name};
    for (const char* column : kColumns)
      row.push_back(change(as_read(strategies[n], column), as_read(first, column)));
    figures.rows.push_back(row);
    const auto lines = effective_lines(strategies[n].first().scene_text);
    scenes.rows.push_back(
        {strategies[n].name, lines_missing(reference, lines), lines_missing(lines, reference)});
  }
  leave_out_empty_columns(figures);
  leave_out_empty_columns(scenes);
  section.blocks.emplace_back(figures);
  section.blocks.emplace_back(scenes);
  return section;
}

Section scatter_section(const std::vector<Strategy>& strategies) {
  Section section{"Single runs", 1, {}};
  Table table{"",
              {"Run", "Seed", column_title("expected_mass_kg"), column_title("filled_mass_kg"),
               column_title("fill_ratio"), column_title("solid_fraction_mean"),
               "Deviation from its strategy's mean mass [%]"},
              {},
              true};
  std::vector<const Run*> runs;
  std::vector<double> deviations;  // %
  for (const auto& strategy : strategies) {
    const double mean = strategy.of("filled_mass_kg").mean;
    for (const Run* run : strategy.runs) {
      runs.push_back(run);
      deviations.push_back(strategy.runs.size() > 1 ? 100 * (figure(run->result, "filled_mass_kg") / mean - 1)
                                                    : std::numeric_limits<double>::quiet_NaN());
    }
  }
  const auto column = [&](const char* name, int digits) {
    return column_of(
        runs, [&](const Run* run) { return in_shown_unit(name, figure(run->result, name)); }, digits);
  };
  const auto expected = column("expected_mass_kg", 3), mass = column("filled_mass_kg", 4),
             ratio = column("fill_ratio", 3), solid = column("solid_fraction_mean", 3),
             deviation = in_one_format(deviations, 2);
  for (std::size_t k = 0; k < runs.size(); ++k)
    table.rows.push_back({runs[k]->name, std::to_string(runs[k]->result.seed), expected[k], mass[k], ratio[k],
                          solid[k], deviation[k]});
  leave_out_empty_columns(table);
  section.blocks.emplace_back(table);
  return section;
}

}  // namespace

std::vector<Section> comparison_sections(const std::vector<Strategy>& strategies, const ColourRange& range) {
  std::vector<Section> sections = {ranking(strategies), maps(strategies, range), curves(strategies)};
  if (series_over_speed(strategies)) sections.push_back(speed_section(strategies));
  if (strategies.size() > 1) sections.push_back(differences(strategies));
  sections.push_back(scatter_section(strategies));
  return sections;
}

}  // namespace diefill::render::report
