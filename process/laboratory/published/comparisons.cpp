#include "process/laboratory/published/comparisons.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "process/input/scene_error.h"
#include "process/laboratory/published/csv_fields.h"
#include "process/laboratory/published/perform.h"

namespace diefill::process::laboratory {
namespace {

constexpr std::size_t kColumns = 4;

double number_in(const std::string& field, const std::string& where) {
  char* end = nullptr;
  const double value = std::strtod(field.c_str(), &end);
  if (end == field.c_str() || *end != '\0')
    throw SceneError(where + ": found \"" + field + "\", expected a number");
  return value;
}

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
  std::ifstream stream(file);
  std::string text;
  std::getline(stream, text);
  for (int number = 2; std::getline(stream, text); ++number) {
    const std::string where = file.string() + ':' + std::to_string(number);
    const auto fields = csv_fields(text);
    if (fields.size() != kColumns)
      throw SceneError(where + ": found " + std::to_string(fields.size()) + " fields, expected " +
                       std::to_string(kColumns));
    table.rows.push_back(row_of(fields, where, figures));
  }
  return table;
}

}  // namespace diefill::process::laboratory
