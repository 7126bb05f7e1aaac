#include "render/report/sections/filling_section.h"

#include <cmath>
#include <limits>

#include "process/results/cavity_rows.h"
#include "process/results/figure_item.h"
#include "process/results/figure_table.h"
#include "process/results/no_value.h"
#include "process/results/rounding.h"
#include "render/report/figure_text.h"
#include "render/report/numbers.h"

namespace diefill::render::report {
namespace {

using results::CavityRow;
using results::FillResult;

std::string full_mass_of(const CavityRow& row) {
  return row.estimate ? "about " + results::mass_text(row.full_mass, 2) : results::mass_text(row.full_mass);
}

/// Densities that follow from an estimate, to two digits: "about 2.4 g/cm³".
std::string about(const std::string& figure, double stored) {
  const double density = in_shown_unit(figure, stored);
  return "about " + results::at_decimals(density, 1 - static_cast<int>(std::floor(std::log10(density)))) +
         ' ' + unit_in_print(figure);
}

/// Masses, ratio and height of the first cavity.
Table mass_table(const FillResult& result, const CavityRow& row) {
  const auto value = [&](const char* name) { return figure(result, name); };
  Table table;
  if (std::isfinite(row.mass)) table.rows.push_back({row_title("expected_mass_kg"), mass_of(row)});
  if (std::isfinite(row.full_mass)) table.rows.push_back({row_title("full_die_mass_kg"), full_mass_of(row)});
  add_figure(table, result, "fill_ratio");
  if (std::isfinite(row.fill_height))
    table.rows.push_back({explained("fill_height_mm"), in_digits(1e3 * row.fill_height, 3) + " of " +
                                                           shown("fill_height_mm", 1e3 * row.depth)});
  add_figure(table, result, "cycle_time_s", explained("cycle_time_s"));
  const double apparent = value("apparent_density_kg_m3");
  const std::string name = row_title("apparent_density_kg_m3");
  if (!std::isfinite(apparent)) {
    const std::string reason = results::reason_for(result, "apparent_density_kg_m3");
    if (!reason.empty()) table.rows.push_back({name, reason});
  } else if (value("apparent_density_is_estimate") > 0) {
    table.rows.push_back(
        {name, about("apparent_density_kg_m3", apparent) +
                   ", estimated: solid fraction of the powder in the shoe times the density of "
                   "its metal (set powder.apparent_density to the measured value)"});
  } else {
    add_figure(table, result, "apparent_density_kg_m3");
  }
  const char* const fill_density = "expected_fill_density_kg_m3";
  if (row.estimate && value(fill_density) > 0)
    table.rows.push_back({row_title(fill_density), about(fill_density, value(fill_density))});
  else
    add_figure(table, result, fill_density);
  return table;
}

/// How evenly the first cavity is filled.
Table evenness_table(const FillResult& result) {
  const auto& summary = result.summary;
  const std::string mean = row_title("solid_fraction_mean");
  Table table{"Solid fraction", {}, {}};
  if (std::isfinite(summary.mean)) {
    table.rows.push_back({mean + " ± " + results::figure_called("solid_fraction_std").label,
                          results::with_scatter(summary.mean, summary.std) + " (" +
                              std::to_string(summary.grains) + " grains)"});
    table.rows.push_back(
        {"Lowest and highest grain", in_digits(summary.min, 2) + " to " + in_digits(summary.max, 2)});
  } else if (const std::string reason = results::reason_for(result, "solid_fraction"); !reason.empty()) {
    table.rows.push_back({mean, "no value: " + reason});
  }
  for (const char* name : {"cavity_solid_fraction", "azimuthal_variation", "axial_variation"})
    add_figure(table, result, name, explained(name));
  return table;
}

Table model_table(const FillResult& result) {
  Table table{"Model powder", {}, {}};
  for (const char* name :
       {"filled_mass_kg", "fill_density_kg_m3", "model_apparent_density_kg_m3", "grains_left"})
    add_figure(table, result, name);
  return table;
}

/// Figures that belong to things of the scene: zones and heaps.
Table thing_table(const FillResult& result) {
  Table table{"Zones and heaps of the scene", {}, {}};
  for (const results::Figure& figure : results::figure_table()) {
    if (!results::is_per_item(figure)) continue;
    for (const auto& [name, value] : result.figures)
      if (results::find_figure(name) == &figure && std::isfinite(value))
        table.rows.push_back(
            {results::capitalised(results::label_of(figure, results::item_of(figure, name))),
             with_unit(figure.shown.factor * value, unit_in_print(figure), figure.shown.digits)});
  }
  return table;
}

Table cavity_table(const std::vector<CavityRow>& rows) {
  Table table{"All cavities",
              {"Cavity", "Middle [mm]", column_title("cavity_volume_m3"), short_title("expected_mass_kg"),
               short_title("full_die_mass_kg"), column_title("fill_ratio"), column_title("fill_height_mm"),
               "Depth [mm]", column_title("solid_fraction_mean"), "Verdict"},
              {}};
  const auto or_none = [](const std::string& text) { return text.empty() ? std::string("–") : text; };
  const auto volume = column_of(
      rows, [](const CavityRow& row) { return 1e6 * row.volume; }, 3);
  const auto ratio = column_of(rows, &CavityRow::fill_ratio, 2);
  const auto height = column_of(
      rows, [](const CavityRow& row) { return 1e3 * row.fill_height; }, 3);
  const auto depth = column_of(
      rows, [](const CavityRow& row) { return 1e3 * row.depth; }, 3);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const CavityRow& row = rows[k];
    table.rows.push_back(
        {std::to_string(row.number),
         in_digits(1e3 * row.place.x(), 3) + ", " + in_digits(1e3 * row.place.y(), 3), volume[k],
         or_none(mass_of(row)), std::isfinite(row.full_mass) ? full_mass_of(row) : "–", ratio[k], height[k],
         depth[k], or_none(results::with_scatter(row.solid_fraction, row.std)), row.verdict});
  }
  leave_out_empty_columns(table);
  return table;
}

void add_table(Section& section, const Table& table) {
  if (!table.rows.empty()) section.blocks.emplace_back(table);
}

}  // namespace

Section filling_section(const FillResult& result) {
  Section section{"Results", 1, {}};
  const auto rows = results::cavity_rows(result);
  if (!rows.empty()) {
    const CavityRow& first = rows.front();
    if (!first.verdict.empty())
      section.blocks.emplace_back(
          Paragraph{(rows.size() > 1 ? "Cavity 1, the largest: " : "") + first.verdict + ".", true});
    if (rows.size() > 1) add_table(section, cavity_table(rows));
    add_table(section, mass_table(result, first));
    add_table(section, evenness_table(result));
  }
  add_table(section, thing_table(result));
  add_table(section, model_table(result));
  if (!rows.empty())
    section.blocks.emplace_back(
        Paragraph{"Model grains do not have the density of the real metal. Use masses and densities of model "
                  "powder only to compare runs; the fill ratio, in which density cancels, applies to the "
                  "real powder. The mean solid fraction is solid over cell volume of the grains at least two "
                  "diameters below the surface."});
  return section;
}

}  // namespace diefill::render::report
