#include "process/laboratory/published/published_figure.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "process/input/scene_error.h"
#include "process/laboratory/published/csv_fields.h"

namespace diefill::process::laboratory {
namespace {

constexpr std::size_t kColumns = 13;

/// NaN for an empty field.
double limit_in(const std::string& field, const std::string& where) {
  if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
  char* end = nullptr;
  const double value = std::strtod(field.c_str(), &end);
  if (end == field.c_str() || *end != '\0')
    throw SceneError(where + ": found \"" + field + "\", expected a number or nothing");
  return value;
}

PublishedFigure figure_of(const std::vector<std::string>& fields, const std::string& where) {
  PublishedFigure figure;
  figure.id = fields[0];
  figure.source = fields[1];
  figure.section = fields[2];
  figure.model = fields[3];
  figure.setting = fields[4];
  figure.quantity = fields[5];
  figure.unit = fields[6];
  figure.published = fields[7];
  figure.lower = limit_in(fields[8], where);
  figure.upper = limit_in(fields[9], where);
  figure.kind = fields[10];
  figure.place = fields[11];
  figure.experiment = fields[12];
  return figure;
}

}  // namespace

std::vector<PublishedFigure> read_published_figures(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream)
    throw SceneError(file.string() +
                     ": cannot be read; give the folder of the laboratory's scenes with --scenes");
  std::vector<PublishedFigure> figures;
  std::string line;
  std::getline(stream, line);
  for (int number = 2; std::getline(stream, line); ++number) {
    const std::string where = file.string() + ':' + std::to_string(number);
    const auto fields = csv_fields(line);
    if (fields.size() != kColumns)
      throw SceneError(where + ": found " + std::to_string(fields.size()) + " fields, expected " +
                       std::to_string(kColumns));
    figures.push_back(figure_of(fields, where));
  }
  return figures;
}

const PublishedFigure& figure_called(const std::vector<PublishedFigure>& figures, const std::string& id) {
  const auto found =
      std::find_if(figures.begin(), figures.end(), [&](const auto& figure) { return figure.id == id; });
  if (found == figures.end()) throw std::out_of_range("no published figure " + id);
  return *found;
}

}  // namespace diefill::process::laboratory
