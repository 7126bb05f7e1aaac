#include "process/laboratory/published/comparisons.h"

#include <algorithm>

#include "process/input/scene_error.h"
#include "process/laboratory/published/csv_rows.h"
#include "process/laboratory/published/perform.h"

namespace diefill::process::laboratory {
namespace {

constexpr std::size_t kColumns = 4;

results::LabRow row_of(const std::vector<std::string>& fields, const std::string& where,
                       const std::vector<PublishedFigure>& figures) {
  const auto figure = std::find_if(figures.begin(), figures.end(),
                                   [&](const PublishedFigure& one) { return one.id == fields[0]; });
  if (figure == figures.end()) throw SceneError(where + ": no published figure \"" + fields[0] + '"');
  results::LabRow row;
  row.id = figure->id;
  row.quantity = figure->quantity;
  row.unit = figure->unit;
  row.published = figure->published;
  row.lower = figure->lower;
  row.upper = figure->upper;
  row.values = {number_in(fields[1], where)};
  row.grain_diameter = 1e-3 * number_in(fields[2], where);
  row.reason = '`' + fields[3] + '`';
  row.verdict = verdict_of(row);
  return row;
}

}  // namespace

results::LabTable compared_figures(const std::filesystem::path& file,
                                   const std::vector<PublishedFigure>& figures) {
  results::LabTable table;
  table.experiment = "comparisons";
  table.size = "compared";
  for_each_row(file, kColumns, MissingFile::no_rows, [&](const auto& fields, const auto& where) {
    table.rows.push_back(row_of(fields, where, figures));
  });
  return table;
}

}  // namespace diefill::process::laboratory
