#include "render/report/powder_spread_report.h"

#include <algorithm>
#include <cmath>

#include "render/report/numbers.h"
#include "render/report/pictures_of.h"

namespace diefill::render::report {
namespace {

/// Every run as a dot: the best powder over its seeds, beside the powders that agree.
Figure dots(const results::SpreadFigure& figure) {
  Chart chart;
  chart.title = figure.name;
  chart.subtitle = "one point per run";
  chart.y.label = with_unit_of("Value", figure.unit);
  chart.x.label = "Run";
  chart.x.lower = 0;
  double x = 0;
  Curve seeds{"best powder, other seeds", {}, {}, CurveStyle::kMarkers, {}},
      powders{"powders that agree with the data", {}, {}, CurveStyle::kMarkers, {}};
  for (const double value : figure.of_seeds) {
    seeds.x.push_back(x += 1);
    seeds.y.push_back(value);
  }
  for (const double value : figure.of_powders) {
    powders.x.push_back(x += 1);
    powders.y.push_back(value);
  }
  chart.x.upper = x + 1;
  chart.curves = {std::move(seeds), std::move(powders)};
  return chart_picture(chart, figure.name);
}

Table figures_table(const results::PowderSpread& spread) {
  Table table{
      "Standard deviations; by the powder: what its uncertainty adds to the scatter over seeds, where "
      "that is more than chance (10 %)",
      {"Figure", "Mean over powders", "By the powder", "Over seeds", "Best powder"},
      {},
      true};
  for (const auto& figure : spread.figures)
    table.rows.push_back({with_unit_of(figure.name, figure.unit), in_digits(figure.mean, 4),
                          std::isfinite(figure.powder) && !figure.significant ? "not significant"
                                                                              : in_digits(figure.powder, 2),
                          in_digits(figure.scatter, 2), in_digits(figure.best, 4)});
  return table;
}

Table powders_table(const results::PowderSpread& spread) {
  Table table{"Powders", {""}, {}, true};
  for (std::size_t k = 0; k < spread.keys.size(); ++k)
    table.header.push_back(with_unit_of(spread.keys[k], spread.units[k]));
  std::vector<std::vector<double>> powders = {spread.best};
  powders.insert(powders.end(), spread.powders.begin(), spread.powders.end());
  for (std::size_t k = 0; k < powders.size(); ++k)
    table.rows.push_back({k == 0 ? "best" : "powder " + std::to_string(k)});
  for (std::size_t key = 0; key < spread.keys.size(); ++key) {
    const auto texts = column_of(powders, [&](const auto& powder) { return powder[key]; });
    for (std::size_t k = 0; k < powders.size(); ++k) table.rows[k].push_back(texts[k]);
  }
  return table;
}

}  // namespace

Document powder_spread_document(const results::PowderSpread& spread) {
  constexpr const char* kDecided[] = {"expected_mass_kg", "filled_mass_kg", "solid_fraction_field_std",
                                      "solid_fraction_mean"};
  Document document;
  document.title = spread.title;
  document.subtitle =
      "Uncertainty of the powder " + spread.powder_file + ", by diefill " + spread.program_version;
  Section answer{"What the uncertainty of the powder does", 1, {}};
  Figures figures{{}, true};
  for (const char* key : kDecided)
    for (const auto& figure : spread.figures)
      if (figure.key == key) {
        answer.blocks.emplace_back(Paragraph{results::spread_text(figure) + '.', false});
        figures.figures.push_back(dots(figure));
      }
  for (const auto& failed : spread.failed) answer.blocks.emplace_back(Paragraph{failed, true});
  answer.blocks.emplace_back(figures_table(spread));
  answer.blocks.emplace_back(std::move(figures));
  document.sections = {answer,
                       Section{"Powders that were run", 1, {powders_table(spread), Listing{spread.command}}}};
  return document;
}

}  // namespace diefill::render::report
