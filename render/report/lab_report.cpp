#include "render/report/lab_report.h"

#include <cmath>

#include "render/charts/experiment_chart.h"
#include "render/report/numbers.h"
#include "render/report/pictures_of.h"

namespace diefill::render::report {

Document powder_sheet(const results::LabTable& table, const std::vector<results::ExperimentChart>& charts) {
  Document document;
  document.title = "Data sheet of the model powder " + table.powder;
  document.subtitle = "Numerical tests, size " + table.size + ", by diefill " + table.program_version;
  Table rows{"Mean and standard deviation over " + std::to_string(table.seeds) + " packings",
             {"Quantity", "Value", "Unit", "Grain size [mm]"},
             {},
             true};
  Section tests{"Tests", 1, {}};
  for (const auto& row : table.rows) {
    rows.rows.push_back({row.quantity, as_text(scatter(row.values)), row.unit == "1" ? "" : row.unit,
                         in_digits(1e3 * row.grain_diameter, 3)});
    if (row.values.empty()) tests.blocks.emplace_back(Paragraph{row.quantity + ": " + row.reason, true});
  }
  tests.blocks.insert(tests.blocks.begin(), rows);
  Figures figures{{}, true};
  for (const auto& chart : charts)
    if (!chart.series.empty()) figures.figures.push_back(chart_picture(chart_of(chart), chart.title));
  tests.blocks.emplace_back(std::move(figures));
  Section notes{"How the numbers are had", 1, {}};
  notes.blocks.emplace_back(Paragraph{
      "Funnel of 60 degrees and cup after ISO 3923-1 and ISO 4490; the coarse size has half their lengths. "
      "Grains are larger than the powder's: the orifice is wider, and flow is converted to the standard's by "
      "the power 5/2 of its width less 1.4 grain sizes (Bierwisch 2009, Eq. 5.1, section 3.2.2).",
      false});
  notes.blocks.emplace_back(Paragraph{
      "Densities are the solid fraction of grains away from the surface times the density of the metal.",
      false});
  document.sections = {tests, notes};
  return document;
}

}  // namespace diefill::render::report
