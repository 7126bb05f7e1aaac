#include "app/tables/run_summary.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "process/results/cavity_rows.h"
#include "process/results/figure_table.h"
#include "process/results/no_value.h"
#include "process/results/rounding.h"

namespace diefill::app {

namespace {

using results::CavityRow;

using results::figure_called;
using results::figure_of;

/// The unit that a figure is shown in: "cm3", since terminals need not know more than ASCII.
std::string unit_of(const char* figure) {
  std::string unit = figure_called(figure).shown.unit;
  std::erase(unit, '^');
  return unit;
}

/// "fill height, mm": a figure over a column.
std::string column(const char* figure) {
  const std::string unit = unit_of(figure);
  return results::short_label(figure_called(figure)) + (unit == "1" ? std::string() : ", " + unit);
}

std::string label(const char* figure) {
  return results::short_label(figure_called(figure));
}

std::string millimetres(double length) {
  return std::isfinite(length) ? results::at_decimals(1e3 * length, 1) : "-";
}

/// "0.31 +- 0.05": terminals need not know more than ASCII.
std::string with_scatter(double value, double scatter) {
  std::string text = results::with_scatter(value, scatter);
  const std::string sign = "±";
  if (const auto place = text.find(sign); place != std::string::npos) text.replace(place, sign.size(), "+-");
  return text;
}

/// Columns padded to their widest cell.
std::string table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> width(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) width[k] = std::max(width[k], row[k].size());
  std::string text;
  for (const auto& row : rows) {
    std::string line = " ";
    for (std::size_t k = 0; k < row.size(); ++k)
      line += std::string(width[k] - row[k].size() + 2, ' ') + row[k];
    text += line + '\n';
  }
  return text;
}

std::string cavity_table(const std::vector<CavityRow>& rows) {
  std::vector<std::vector<std::string>> cells = {{"cavity", "place, mm", column("cavity_volume_m3"),
                                                  label("expected_mass_kg"), label("full_die_mass_kg"),
                                                  column("fill_ratio"), column("fill_height_mm"),
                                                  column("solid_fraction_mean")}};
  for (const CavityRow& row : rows) {
    const auto shown = [](double value, double factor) {
      return std::isfinite(value) ? results::in_significant_digits(factor * value, 3) : std::string("-");
    };
    const std::string fraction = with_scatter(row.solid_fraction, row.std);
    cells.push_back(
        {std::to_string(row.number),
         results::at_decimals(1e3 * row.place.x(), 1) + ", " + results::at_decimals(1e3 * row.place.y(), 1),
         shown(row.volume, figure_called("cavity_volume_m3").shown.factor),
         std::isfinite(row.mass) ? mass_of(row) : "-",
         std::isfinite(row.full_mass) ? results::mass_text(row.full_mass, row.estimate ? 2 : 3) : "-",
         std::isfinite(row.fill_ratio) ? results::at_decimals(row.fill_ratio, 2) : "-",
         millimetres(row.fill_height) + " of " + millimetres(row.depth),
         fraction.empty() ? "too few grains" : fraction});
  }
  return table(cells);
}

/// The apparent density that the mass is based on.
std::string apparent_density(const results::FillResult& result) {
  const char* const name = "apparent_density_kg_m3";
  const double density = figure_called(name).shown.factor * figure_of(result, name);
  if (!std::isfinite(density)) return label(name) + ' ' + results::reason_for(result, name);
  if (figure_of(result, "apparent_density_is_estimate") > 0)
    return label(name) + " about " + results::in_significant_digits(density, 2) + ' ' + unit_of(name) +
           ", estimated: solid fraction of the powder in the shoe times the density of its metal; give "
           "powder.apparent_density";
  return label(name) + ' ' + results::in_significant_digits(density, figure_called(name).shown.digits) + ' ' +
         unit_of(name);
}

std::string mean_solid_fraction(const results::FillResult& result) {
  const auto& summary = result.summary;
  if (!std::isfinite(summary.mean)) {
    const std::string reason = results::reason_for(result, "solid_fraction");
    return label("solid_fraction_mean") + ": no value" + (reason.empty() ? std::string() : ", " + reason) +
           '\n';
  }
  return label("solid_fraction_mean") + ' ' + with_scatter(summary.mean, summary.std) +
         " (standard deviation over " + std::to_string(summary.grains) +
         " single grains two diameters below the surface)\n";
}

}  // namespace

std::string filling_text(const results::FillResult& result) {
  const auto rows = results::cavity_rows(result);
  if (rows.empty()) {
    char text[120];
    std::snprintf(text, sizeof text, "no cavity; %.0f grains (%.4g g) left the tools\n",
                  figure_of(result, "grains_left"),
                  figure_called("mass_left_kg").shown.factor * figure_of(result, "mass_left_kg"));
    return text;
  }
  std::string text;
  for (const CavityRow& row : rows)
    text += (rows.size() > 1 ? "cavity " + std::to_string(row.number) + ": " : "") + row.verdict + '\n';
  if (rows.size() > 1) text += cavity_table(rows);
  const CavityRow& first = rows.front();
  text += label("expected_mass_kg") + ' ' + (std::isfinite(first.mass) ? mass_of(first) : "unknown");
  if (rows.size() > 1) text += " in cavity 1";
  if (std::isfinite(first.fill_ratio))
    text += ", " + label("fill_ratio") + ' ' + results::at_decimals(first.fill_ratio, 2) +
            " of a die full at apparent density";
  text += ", " + label("fill_height_mm") + ' ' + millimetres(first.fill_height) + " of " +
          millimetres(first.depth) + " mm";
  if (const double cycle = figure_of(result, "cycle_time_s"); cycle > 0)
    text += ", " + label("cycle_time_s") + ' ' + results::in_significant_digits(cycle, 3) + " s";
  return text + "; " + apparent_density(result) + '\n' + mean_solid_fraction(result);
}

}  // namespace diefill::app
