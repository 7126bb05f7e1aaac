#include "geometry/cad/xml_coordinates.h"

#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/cad/read_text_stl.h"
#include "geometry/cad/shown_text.h"

namespace diefill::geometry {

namespace {

constexpr std::string_view kXmlBlanks = " \t\r\n";
constexpr std::size_t kShownCoordinate = 30;
constexpr std::size_t kPiece = 1U << 20U;  // bytes unpacked at once

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kXmlBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kXmlBlanks) - first + 1);
}

bool is_axis(std::string_view name) {
  return name == "x" || name == "y" || name == "z";
}

void check_coordinate(std::string_view axis, std::string_view written) {
  double number = 0;
  if (is_number(without_blanks(written), number)) return;
  throw std::runtime_error("a corner needs numbers, found " + std::string(axis) + " = '" +
                           shown(written, kShownCoordinate) + "'" +
                           (written.find(',') != std::string_view::npos ? " with a comma" : ""));
}

/// `attributes` as they stand in a tag, after its name.
void check_axes_of(std::string_view attributes) {
  for (std::size_t at = 0; at < attributes.size();) {
    const std::size_t equals = attributes.find('=', at);
    const std::size_t open = attributes.find_first_of("\"'", equals);
    if (equals == std::string_view::npos || open == std::string_view::npos) return;
    const std::size_t close = attributes.find(attributes[open], open + 1);
    if (close == std::string_view::npos) return;
    const std::string_view name = without_blanks(attributes.substr(at, equals - at));
    if (is_axis(name)) check_coordinate(name, attributes.substr(open + 1, close - open - 1));
    at = close + 1;
  }
}

/// Calls `look(name, attributes, rest)` for every tag; the name comes without a prefix such as "m:".
template <class Look>
void visit_tags(std::string_view document, Look look) {
  for (std::size_t at = document.find('<'); at != std::string_view::npos; at = document.find('<', at + 1)) {
    const std::size_t end = document.find('>', at);
    if (end == std::string_view::npos) return;
    const std::string_view tag = document.substr(at + 1, end - at - 1);
    const std::size_t blank = std::min(tag.find_first_of(" \t\r\n/", 1), tag.size());
    const std::string_view name = tag.substr(0, blank);
    look(name.substr(name.rfind(':') + 1), tag.substr(blank), document.substr(end + 1));
  }
}

struct CloseArchive {
  void operator()(void* archive) const { unzClose(archive); }
};

/// The file of the archive that is reached.
std::string unpacked(unzFile archive) {
  std::string text;
  if (unzOpenCurrentFile(archive) != UNZ_OK) return text;
  std::vector<char> piece(kPiece);
  for (int got = 1; got > 0;) {
    got = unzReadCurrentFile(archive, piece.data(), static_cast<unsigned>(piece.size()));
    if (got > 0) text.append(piece.data(), static_cast<std::size_t>(got));
  }
  unzCloseCurrentFile(archive);
  return text;
}

std::string name_of_reached(unzFile archive) {
  std::array<char, 1000> name{};
  unz_file_info information{};  // which minizip writes unasked
  unzGetCurrentFileInfo(archive, &information, name.data(), name.size() - 1, nullptr, 0, nullptr, 0);
  return name.data();
}

}  // namespace

void check_vertex_attributes(std::string_view model) {
  visit_tags(model, [](std::string_view name, std::string_view attributes, std::string_view) {
    if (name == "vertex") check_axes_of(attributes);
  });
}

void check_amf_coordinates(std::string_view document) {
  visit_tags(document, [](std::string_view name, std::string_view, std::string_view rest) {
    if (is_axis(name)) check_coordinate(name, rest.substr(0, rest.find('<')));
  });
}

void check_3mf_coordinates(const std::filesystem::path& file) {
  const std::unique_ptr<void, CloseArchive> archive(unzOpen(file.c_str()));
  if (!archive) return;
  for (int found = unzGoToFirstFile(archive.get()); found == UNZ_OK; found = unzGoToNextFile(archive.get()))
    if (name_of_reached(archive.get()).ends_with(".model")) check_vertex_attributes(unpacked(archive.get()));
}

}  // namespace diefill::geometry
