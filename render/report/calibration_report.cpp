#include "render/report/calibration_report.h"

#include <algorithm>
#include <cmath>

#include "process/results/rounding.h"
#include "render/report/numbers.h"
#include "render/report/pictures_of.h"
#include "render/report/sections/calibration_data_section.h"

namespace diefill::render::report {
namespace {

std::string axis_text(const std::string& name, const std::string& unit) {
  return name + (unit == "1" || unit.empty() ? "" : " [" + unit + "]");
}

Table parameter_table(const results::Calibration& calibration) {
  Table table{"Parameters: best value and 90 % interval",
              {"Parameter", "Best", "90 % interval", "Searched"},
              {},
              true};
  for (const auto& parameter : calibration.parameters) {
    const std::string unit = results::unit_behind(parameter.unit);
    table.rows.push_back({parameter.key, in_digits(parameter.best, 3) + unit,
                          in_digits(parameter.lower, 3) + " to " + in_digits(parameter.upper, 3) + unit,
                          in_digits(parameter.from, 3) + " to " + in_digits(parameter.to, 3) + unit +
                              (parameter.logarithmic ? ", logarithmic" : "")});
  }
  return table;
}

void add_remarks(Section& section, const results::Calibration& calibration) {
  for (const auto& remark : calibration.remarks) section.blocks.emplace_back(Paragraph{remark + '.', true});
}

Section answer_section(const results::Calibration& calibration) {
  Section section{"The powder", 1, {}};
  if (!calibration.fitted) {
    section.blocks.emplace_back(Paragraph{"No powder was fitted: " + calibration.stopped + '.', true});
    add_remarks(section, calibration);
    return section;
  }
  section.blocks.emplace_back(parameter_table(calibration));
  section.blocks.emplace_back(Paragraph{
      "chi^2 is " + in_digits(calibration.chi_square, 3) + " for " + std::to_string(calibration.data) +
          " measured values and " + std::to_string(calibration.parameters.size()) + " parameters: " +
          (calibration.agrees ? "the powder agrees with the data within their deviations."
                              : "the powder does not agree with the data within their deviations."),
      !calibration.agrees});
  for (const auto& sentence : calibration.insights)
    section.blocks.emplace_back(Paragraph{sentence + '.', false});
  add_remarks(section, calibration);
  section.blocks.emplace_back(
      Paragraph{"Fitted with " + calibration.grains +
                    ". The parameters belong to these: with other wall spheres or another "
                    "stiffness, calibrate again.",
                false});
  return section;
}

Figure profile_picture(const results::CalibratedParameter& parameter, std::size_t data) {
  Chart chart;
  chart.title = "Misfit along " + parameter.key;
  chart.subtitle = "all other parameters as they fit best";
  chart.x.label = axis_text(parameter.key, parameter.unit);
  chart.x.logarithmic = parameter.logarithmic;
  chart.y.label = "Misfit in standard deviations";
  chart.y.lower = 0;
  Curve curve{"", parameter.profile_at, {}, CurveStyle::kLine, {}};
  for (const double misfit : parameter.profile)
    curve.y.push_back(std::sqrt(misfit / static_cast<double>(data)));
  chart.curves = {curve};
  chart.note =
      "Root of chi^2 plus what -2 ln(likelihood) rises, over the number of values: about 1 where the powder "
      "agrees";
  return chart_picture(chart, "misfit along " + parameter.key);
}

/// Where the best parameters lie on a map of two of them.
StarMark best_mark(const results::CalibratedParameter& first, const results::CalibratedParameter& second) {
  const auto place = [](const results::CalibratedParameter& parameter) {
    return parameter.logarithmic ? std::log10(parameter.best) : parameter.best;
  };
  return {{place(first), place(second)}, "best powder"};
}

/// Maps over two parameters each, the first with the second, the third and so on.
Figures parameter_maps(const results::Calibration& calibration) {
  Figures maps{{}, true};
  const auto& parameters = calibration.parameters;
  std::size_t k = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (std::size_t j = i + 1; j < parameters.size() && k < calibration.maps.size(); ++j) {
      const auto& map = calibration.maps[k++];
      FieldStyle style;
      style.stars = {best_mark(parameters[i], parameters[j])};
      if (std::isfinite(calibration.map_edge))
        style.level_lines = {{calibration.map_edge, "edge of the powders that agree (90 %)"}};
      maps.figures.push_back(field_picture(map, "Misfit in standard deviations",
                                           "about 1 where the powder agrees", kRangeFromData,
                                           map.first_name + " and " + map.second_name, style));
    }
  for (const auto& map : calibration.residual_maps) {
    FieldStyle style;
    if (parameters.size() > 1) style.stars = {best_mark(parameters[0], parameters[1])};
    maps.figures.push_back(field_picture(map, map.quantity, "root mean square, in scaled coordinates",
                                         kRangeFromData, map.quantity, style));
  }
  return maps;
}

Section region_section(const results::Calibration& calibration) {
  Section section{"What the data can tell, and what not", 1, {}};
  Figures maps = parameter_maps(calibration), profiles{{}, true};
  for (const auto& parameter : calibration.parameters)
    profiles.figures.push_back(profile_picture(parameter, calibration.data));
  if (!maps.figures.empty()) section.blocks.emplace_back(std::move(maps));
  section.blocks.emplace_back(std::move(profiles));
  if (calibration.parameters.size() > 1) {
    Table table{"Correlation of the parameters over all powders that agree", {""}, {}, true};
    for (const auto& parameter : calibration.parameters) table.header.push_back(parameter.key);
    for (std::size_t i = 0; i < calibration.correlation.size(); ++i) {
      table.rows.push_back({calibration.parameters[i].key});
      for (const double r : calibration.correlation[i])
        table.rows.back().push_back(std::isfinite(r) ? results::at_decimals(r, 2) : "–");
    }
    section.blocks.emplace_back(std::move(table));
  }
  Table worth{"What one more measurement would leave of the uncertainty (linear estimate)",
              {"Measurement", "Region"},
              {},
              true};
  for (const auto& parameter : calibration.parameters) worth.header.push_back(parameter.key);
  for (const auto& each : calibration.worth) {
    worth.rows.push_back({each.name, in_digits(100 * each.volume, 2) + " %"});
    for (const double ratio : each.deviations) worth.rows.back().push_back(in_digits(100 * ratio, 2) + " %");
  }
  if (!worth.rows.empty()) section.blocks.emplace_back(std::move(worth));
  return section;
}

Section screening_section(const results::Calibration& calibration) {
  const results::Screening& screening = calibration.screening;
  Section section{"Effects", 1, {}};
  std::string words =
      std::to_string(screening.runs) + " runs, " +
      (screening.resolution == 0 ? "a full factorial"
                                 : "resolution " + std::to_string(screening.resolution)) +
      ". An effect is the mean at the high level less the mean at the low level" +
      (screening.quantities.empty() ? "" : "; standard errors come from " + screening.error_source) + '.';
  section.blocks.emplace_back(Paragraph{words, false});
  add_remarks(section, calibration);
  Listing letters;
  for (const auto& line : screening.letters) letters.text += line + '\n';
  for (const auto& line : screening.generators) letters.text += line + '\n';
  section.blocks.emplace_back(std::move(letters));
  Table table{"Effects; those beyond their 95 % margin are marked *", {"Effect", "Parameters"}, {}, true};
  for (const auto& quantity : screening.quantities)
    table.header.push_back(axis_text(quantity.name, quantity.unit));
  for (const auto& effect : screening.effects) {
    table.rows.push_back({effect.string, effect.words});
    for (std::size_t q = 0; q < effect.values.size(); ++q)
      table.rows.back().push_back(in_digits(effect.values[q], 3) +
                                  (std::abs(effect.values[q]) > screening.quantities[q].margin ? " *" : ""));
  }
  section.blocks.emplace_back(std::move(table));
  Table errors{"Mean, standard error of an effect, error of the regression without and with interactions",
               {"Quantity", "Mean", "Standard error", "Without [%]", "With [%]"},
               {},
               true};
  for (const auto& quantity : screening.quantities)
    errors.rows.push_back({quantity.name, in_digits(quantity.mean, 4) + results::unit_behind(quantity.unit),
                           in_digits(quantity.error, 2), in_digits(quantity.error_without, 2),
                           in_digits(quantity.error_with, 2)});
  section.blocks.emplace_back(std::move(errors));
  Figures figures{{}, true};
  for (std::size_t q = 0; q < screening.quantities.size(); ++q)
    figures.figures.push_back(effects_picture(screening, q));
  section.blocks.emplace_back(std::move(figures));
  return section;
}

Section points_section(const results::Calibration& calibration) {
  Section section{"Simulated sets of parameters", 1, {}};
  Table table{"", {"#", "Role"}, {}, true};
  for (const auto& parameter : calibration.parameters)
    table.header.push_back(axis_text(parameter.key, parameter.unit));
  for (const char* head : {"chi^2 of its runs", "Core seconds", "State"}) table.header.emplace_back(head);
  double seconds = 0;
  std::vector<std::vector<std::string>> columns;
  const auto& points = calibration.points;
  for (std::size_t p = 0; p < calibration.parameters.size(); ++p)
    columns.push_back(column_of(
        points, [&](const auto& point) { return point.values.at(p); }, 3));
  columns.push_back(column_of(
      points, [](const auto& point) { return point.chi_square; }, 3));
  columns.push_back(column_of(
      points, [](const auto& point) { return point.core_seconds; }, 3));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto& point = points[k];
    table.rows.push_back({std::to_string(k + 1), point.role});
    for (const auto& column : columns) table.rows.back().push_back(column[k]);
    table.rows.back().push_back(point.state + (point.reason.empty() ? "" : ": " + point.reason));
    seconds += point.core_seconds;
  }
  section.blocks.emplace_back(Paragraph{"The search ended because " + calibration.stopped +
                                            ". All runs took " + in_digits(seconds / 60, 3) +
                                            " core minutes.",
                                        false});
  section.blocks.emplace_back(std::move(table));
  section.blocks.emplace_back(Listing{calibration.command});
  return section;
}

}  // namespace

Figure effects_picture(const results::Screening& screening, std::size_t quantity) {
  const auto& about = screening.quantities[quantity];
  Chart chart;
  chart.title = "Effects on " + about.name;
  chart.subtitle = "with 95 % margins";
  chart.x.label = "Effect";
  chart.x.lower = 0;
  chart.y.label = axis_text("Mean at high minus mean at low level", about.unit);
  double x = 0;
  for (const auto& effect : screening.effects) {
    x += 1;
    if (!effect.main && std::abs(effect.values[quantity]) <= about.margin)
      continue;  // legible: what stands out
    Curve curve{
        effect.string + ": " + effect.words, {x}, {effect.values[quantity]}, CurveStyle::kMarkers, {}};
    if (std::isfinite(about.margin)) curve.y_error = {about.margin};
    chart.curves.push_back(std::move(curve));
  }
  chart.x.upper = x + 1;
  Curve zero{"", {0, x + 1}, {0, 0}, CurveStyle::kReference, {}};
  chart.curves.push_back(zero);
  chart.note = "All main effects, and those strings of interactions that stand out from their margin";
  return chart_picture(chart, "effects on " + about.name);
}

Document calibration_document(const results::Calibration& calibration) {
  Document document;
  document.title = calibration.title;
  const bool screened = calibration.screening.runs > 0;
  document.subtitle = std::string(screened ? "Screening" : "Calibration") + " by diefill " +
                      calibration.program_version + ", starting from " + calibration.powder;
  if (screened) {
    document.sections.push_back(screening_section(calibration));
  } else {
    document.sections.push_back(answer_section(calibration));
    if (calibration.fitted) {
      document.sections.push_back(measured_and_simulated(calibration, true));
      document.sections.push_back(region_section(calibration));
      const auto& all = calibration.measurements;
      if (std::any_of(all.begin(), all.end(), [](const auto& each) { return !each.fitted; }))
        document.sections.push_back(measured_and_simulated(calibration, false));
    }
  }
  document.sections.push_back(points_section(calibration));
  return document;
}

}  // namespace diefill::render::report
