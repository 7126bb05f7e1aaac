#include "process/laboratory/published/family_tables.h"

#include <algorithm>
#include <cmath>

#include "process/laboratory/published/perform.h"
#include "process/run/assemble.h"

namespace diefill::process::laboratory {

namespace {

constexpr const char* kEnding = "_figures";

}  // namespace

results::LabTable table_of_figures(const results::ExperimentResult& result,
                                   const std::vector<PublishedFigure>& published) {
  results::LabTable table;
  table.experiment = result.name + kEnding;
  table.question = result.question;
  table.size = result.quick ? "quick" : "full";
  table.program_version = program_version();
  table.core_seconds = result.cpu_seconds;
  for (const auto& figure : result.figures) {
    results::LabRow row;
    row.id = figure.id;
    take_published(figure_called(published, figure.id), row);
    if (std::isfinite(figure.value)) row.values.push_back(figure.value);
    row.reason = figure.how;
    row.grain_diameter = figure.grain_diameter;
    row.core_seconds = result.cpu_seconds;
    row.verdict = verdict_of(row);
    table.rows.push_back(row);
  }
  return table;
}

std::vector<results::LabTable> family_tables(const std::filesystem::path& laboratory) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  if (!fs::is_directory(laboratory)) return {};
  for (const auto& family : fs::directory_iterator(laboratory)) {
    if (!family.is_directory()) continue;
    for (const auto& file : fs::directory_iterator(family.path()))
      if (file.path().extension() == ".json" && file.path().stem().string().ends_with(kEnding))
        files.push_back(file.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<results::LabTable> tables;
  for (const auto& file : files)
    tables.push_back(results::read_lab_table(file.parent_path(), file.stem().string()));
  return tables;
}

}  // namespace diefill::process::laboratory
