#include "process/laboratory/published/published_figure.h"

#include <algorithm>
#include <stdexcept>

#include "process/input/scene_error.h"
#include "process/laboratory/published/csv_rows.h"

namespace diefill::process::laboratory {
namespace {

constexpr std::size_t kColumns = 13;

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
  figure.lower = number_or_nothing_in(fields[8], where);
  figure.upper = number_or_nothing_in(fields[9], where);
  figure.kind = fields[10];
  figure.place = fields[11];
  figure.experiment = fields[12];
  return figure;
}

}  // namespace

std::vector<PublishedFigure> read_published_figures(const std::filesystem::path& file) {
  std::vector<PublishedFigure> figures;
  for_each_row(file, kColumns, MissingFile::error,
               [&](const auto& fields, const auto& where) { figures.push_back(figure_of(fields, where)); });
  return figures;
}

void require_figures(const std::vector<PublishedFigure>& figures, const std::vector<std::string>& ids,
                     const std::filesystem::path& file) {
  for (const std::string& id : ids)
    if (std::none_of(figures.begin(), figures.end(), [&](const auto& figure) { return figure.id == id; }))
      throw SceneError(file.string() + ": id: found no row " + id +
                       ", with which the experiment's result is compared; add it, or leave --scenes out for "
                       "the file that comes with the program");
}

const PublishedFigure& figure_called(const std::vector<PublishedFigure>& figures, const std::string& id) {
  const auto found =
      std::find_if(figures.begin(), figures.end(), [&](const auto& figure) { return figure.id == id; });
  if (found == figures.end()) throw std::out_of_range("no published figure " + id);
  return *found;
}

}  // namespace diefill::process::laboratory
