#include "geometry/cad/xml_coordinates.h"

#include <stdexcept>
#include <string>

#include "geometry/cad/read_text_stl.h"
#include "geometry/cad/shown_text.h"
#include "geometry/cad/xml_tags.h"
#include "geometry/cad/zip_archive.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kShownCoordinate = 30;

bool is_axis(std::string_view name) {
  return name == "x" || name == "y" || name == "z";
}

}  // namespace

double xml_number(std::string_view whose, std::string_view name, std::string_view written) {
  double number = 0;
  if (is_number(without_blanks(written), number)) return number;
  throw std::runtime_error(std::string(whose) + " needs numbers, found " + std::string(name) + " = '" +
                           shown(written, kShownCoordinate) + "'" +
                           (written.find(',') != std::string_view::npos ? " with a comma" : ""));
}

void check_vertex_attributes(std::string_view model) {
  visit_tags(model, [](std::string_view name, std::string_view attributes, std::string_view) {
    if (name != "vertex") return;
    visit_attributes(attributes, [](std::string_view axis, std::string_view value) {
      if (is_axis(axis)) xml_number("a corner", axis, value);
    });
  });
}

void check_amf_coordinates(std::string_view document) {
  visit_tags(document, [](std::string_view name, std::string_view, std::string_view rest) {
    if (is_axis(name)) xml_number("a corner", name, rest.substr(0, rest.find('<')));
  });
}

void check_3mf_coordinates(const std::filesystem::path& file) {
  visit_archive(file, ".model", [](UnpackedFile model) {
    check_vertex_attributes(without_comments(std::move(model.text)));
    return true;
  });
}

}  // namespace diefill::geometry
