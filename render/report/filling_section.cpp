#include "render/report/filling_section.h"

#include <cmath>
#include <limits>

#include "process/results/cavity_rows.h"
#include "process/results/no_value.h"
#include "process/results/rounding.h"
#include "render/report/numbers.h"

namespace diefill::render::report {
namespace {

using results::CavityRow;
using results::FillResult;

void add_row(Table& table, const std::string& name, double value, const std::string& unit, int digits = 4) {
  if (std::isfinite(value)) table.rows.push_back({name, with_unit(value, unit, digits)});
}

std::string full_mass_of(const CavityRow& row) {
  return row.estimate ? "about " + results::mass_in_words(row.full_mass, 2)
                      : results::mass_in_words(row.full_mass);
}

/// Densities that follow from an estimate, to two digits: "about 2400 kg/m³".
std::string about(double density) {
  return "about " + results::at_decimals(density, 1 - static_cast<int>(std::floor(std::log10(density)))) +
         " kg/m³";
}

/// Masses, ratio and height of the first cavity.
Table mass_table(const FillResult& result, const CavityRow& row) {
  const auto value = [&](const char* name) { return figure(result, name); };
  Table table;
  if (std::isfinite(row.mass)) table.rows.push_back({"Mass of the real powder in the cavity", mass_of(row)});
  if (std::isfinite(row.full_mass))
    table.rows.push_back({"A die full at apparent density holds", full_mass_of(row)});
  add_row(table, "Fill ratio: mass over that of the full die", row.fill_ratio, "", 2);
  if (std::isfinite(row.fill_height))
    table.rows.push_back(
        {"Fill height: mean height of the surface above the floor",
         in_digits(1e3 * row.fill_height, 3) + " of " + in_digits(1e3 * row.depth, 3) + " mm"});
  add_row(table, "Cycle time: the scene's steps without waiting for rest", value("cycle_time_s"), "s", 3);
  const double apparent = value("apparent_density_kg_m3");
  const std::string name = "Apparent density of the real powder";
  if (!std::isfinite(apparent)) {
    const std::string reason = results::reason_for(result, "apparent_density_kg_m3");
    if (!reason.empty()) table.rows.push_back({name, reason});
  } else if (value("apparent_density_is_estimate") > 0) {
    table.rows.push_back(
        {name, about(apparent) + ", estimated: solid fraction of the powder in the shoe times the density of "
                                 "its metal (set powder.apparent_density to the measured value)"});
  } else {
    add_row(table, name, apparent, "kg/m³");
  }
  const double density = value("expected_fill_density_kg_m3");
  if (row.estimate && density > 0)
    table.rows.push_back({"Fill density of the real powder", about(density)});
  else
    add_row(table, "Fill density of the real powder", density, "kg/m³", 3);
  return table;
}

/// How evenly the first cavity is filled.
Table evenness_table(const FillResult& result) {
  const auto value = [&](const char* name) { return figure(result, name); };
  const auto& summary = result.summary;
  Table table{"Solid fraction", {}, {}};
  if (std::isfinite(summary.mean)) {
    table.rows.push_back({"Mean solid fraction ± standard deviation over grains",
                          results::with_scatter(summary.mean, summary.std) + " (" +
                              std::to_string(summary.grains) + " grains)"});
    table.rows.push_back(
        {"Lowest and highest grain", in_digits(summary.min, 2) + " to " + in_digits(summary.max, 2)});
  } else if (const std::string reason = results::reason_for(result, "solid_fraction"); !reason.empty()) {
    table.rows.push_back({"Mean solid fraction", "no value: " + reason});
  }
  add_row(table, "Solid fraction of the cavity: all powder in it over its volume",
          value("cavity_solid_fraction"), "", 3);
  add_row(table, "Azimuthal variation: range over mean of the filled fraction, 12 sectors",
          100 * value("azimuthal_variation"), "%", 2);
  add_row(table, "Axial variation: range over mean of the solid fraction over height",
          100 * value("axial_variation"), "%", 2);
  return table;
}

Table model_table(const FillResult& result) {
  const auto value = [&](const char* name) { return figure(result, name); };
  Table table{"Model powder", {}, {}};
  add_row(table, "Filled mass of model powder", 1e3 * value("filled_mass_kg"), "g");
  add_row(table, "Fill density of model powder", value("fill_density_kg_m3"), "kg/m³");
  add_row(table, "Apparent density of model powder (left outside the cavity)",
          value("model_apparent_density_kg_m3"), "kg/m³");
  add_row(table, "Grains that left the tools", value("grains_left"), "");
  return table;
}

Table cavity_table(const std::vector<CavityRow>& rows) {
  Table table{"All cavities",
              {"Cavity", "Middle [mm]", "Volume [cm³]", "Mass", "Full die", "Fill ratio", "Fill height [mm]",
               "Depth [mm]", "Mean solid fraction", "Verdict"},
              {}};
  const auto or_none = [](const std::string& text) { return text.empty() ? std::string("–") : text; };
  for (const CavityRow& row : rows)
    table.rows.push_back({std::to_string(row.number),
                          in_digits(1e3 * row.place.x(), 3) + ", " + in_digits(1e3 * row.place.y(), 3),
                          in_digits(1e6 * row.volume, 3), or_none(mass_of(row)),
                          std::isfinite(row.full_mass) ? full_mass_of(row) : "–",
                          in_digits(row.fill_ratio, 2), in_digits(1e3 * row.fill_height, 3),
                          in_digits(1e3 * row.depth, 3),
                          or_none(results::with_scatter(row.solid_fraction, row.std)), row.verdict});
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
