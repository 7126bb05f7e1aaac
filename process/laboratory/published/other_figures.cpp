#include "process/laboratory/published/other_figures.h"

#include <algorithm>
#include <cmath>

#include "process/laboratory/published/csv_rows.h"
#include "process/laboratory/published/kept_results.h"
#include "process/laboratory/published/scene_experiment.h"
#include "process/results/csv_field.h"
#include "process/results/formatted.h"
#include "process/results/rounding.h"

namespace diefill::process::laboratory {
namespace {

constexpr std::size_t kColumns = 8;

OtherFigure figure_of(const std::vector<std::string>& fields, const std::string& where) {
  OtherFigure figure{.experiment = fields[0], .size = fields[1], .row = {}};
  fineness_of(figure.size, where);
  figure.row.id = fields[2];
  figure.row.quantity = fields[3];
  figure.row.unit = fields[4];
  figure.row.values = numbers_in(fields[5], where);
  figure.row.grain_diameter = 1e-3 * number_or_nothing_in(fields[6], where);
  figure.row.core_seconds = number_in(fields[7], where);
  return figure;
}

void drop_what_is_no_longer_measured(std::vector<OtherFigure>& kept, const results::LabTable& table) {
  std::erase_if(kept, [&](const OtherFigure& figure) {
    const auto same = [&](const results::LabRow& row) { return row.id == figure.row.id; };
    return figure.experiment == table.experiment && figure.size == table.size &&
           std::none_of(table.rows.begin(), table.rows.end(), same);
  });
}

/// The figures of one experiment; empty without any.
std::string section_of(const SceneExperiment& experiment, const std::vector<OtherFigure>& kept) {
  std::string rows;
  for (const OtherFigure& figure : kept) {
    if (figure.experiment != experiment.name) continue;
    const results::LabRow& row = figure.row;
    rows += "| " + row.quantity + " | " + results::here_text(row) + results::unit_behind(row.unit) + " | " +
            (std::isfinite(row.grain_diameter) ? results::formatted("%.3g", 1e3 * row.grain_diameter) : "-") +
            " | " + results::formatted("%.0f", row.core_seconds) + " | " + figure.size + ", " +
            std::to_string(results::seeds_of(row)) +
            (results::seeds_of(row) > 1 ? " seeds |\n" : " seed |\n");
  }
  if (rows.empty()) return {};
  return "\n## " + experiment.name + ": " + experiment.question +
         "\n| quantity | here | d, mm | core s | size |\n|---|---|---|---|---|\n" + rows;
}

}  // namespace

std::vector<OtherFigure> read_other_figures(const std::filesystem::path& file) {
  std::vector<OtherFigure> kept;
  for_each_row(file, kColumns, MissingFile::no_rows,
               [&](const auto& fields, const auto& where) { kept.push_back(figure_of(fields, where)); });
  return kept;
}

void take_over(std::vector<OtherFigure>& kept, const std::vector<results::LabTable>& measured) {
  for (const auto& table : measured) {
    drop_what_is_no_longer_measured(kept, table);
    for (const auto& row : table.rows) {
      if (!row.published.empty() || row.values.empty()) continue;
      const auto earlier = std::find_if(kept.begin(), kept.end(), [&](const OtherFigure& figure) {
        return figure.experiment == table.experiment && figure.row.id == row.id;
      });
      if (earlier == kept.end())
        kept.push_back({table.experiment, table.size, row});
      else if (replaces(row, table.size, earlier->row, earlier->size))
        *earlier = {table.experiment, table.size, row};
    }
  }
}

std::string csv_of(const std::vector<OtherFigure>& kept) {
  std::string text = "experiment,size,id,quantity,unit,values,d_mm,core_seconds\n";
  for (const OtherFigure& figure : kept) {
    const results::LabRow& row = figure.row;
    text += figure.experiment + ',' + figure.size + ',' + results::csv_text(row.id) + ',' +
            results::csv_text(row.quantity) + ',' + results::csv_text(row.unit) + ',' + text_of(row.values) +
            ',' + results::csv_number(1e3 * row.grain_diameter, 6) + ',' +
            results::csv_number(row.core_seconds, 4) + '\n';
  }
  return text;
}

std::string other_figures_page(const std::vector<OtherFigure>& kept) {
  std::string page = "# Other figures of the laboratory\n\nWritten by `diefill lab fidelity` from `" +
                     std::string(kOtherFigures) +
                     "`; do not edit. What experiments measure that has no published\nvalue to compare with. "
                     "Here: mean +- standard deviation over seeds. d: the coarsest grains of its runs. Core "
                     "s:\nprocessor time of these runs, which other rows may share.\n";
  for (const SceneExperiment& experiment : scene_experiments()) page += section_of(experiment, kept);
  return page;
}

}  // namespace diefill::process::laboratory
