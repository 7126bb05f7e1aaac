#include "geometry/cad/cad_parts.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <stdexcept>

#include "geometry/cad/amf_document.h"
#include "geometry/cad/cad_file.h"
#include "geometry/cad/cad_readers.h"
#include "geometry/cad/gltf_document.h"
#include "geometry/cad/read_text_stl.h"
#include "geometry/cad/shown_text.h"
#include "geometry/cad/xml_coordinates.h"

namespace diefill::geometry {

namespace {

std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// Names for parts that have none; parts that share one are numbered, the first too, so that none of them is
/// taken for the only one.
void make_names_unique(std::vector<CadPart>& parts) {
  std::map<std::string, int> count;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    std::string& name = parts[k].name;
    name = as_utf8(name);
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    if (name.empty()) name = "part " + std::to_string(k + 1);
    parts[k].plain_name = name;
    ++count[name];
  }
  std::set<std::string> taken;
  for (const CadPart& part : parts)
    if (count[part.name] == 1) taken.insert(part.name);
  for (CadPart& part : parts) {
    if (count[part.plain_name] == 1) continue;
    for (int copy = 1; !taken.insert(part.name).second || copy == 1; ++copy)
      part.name = part.plain_name + " (" + std::to_string(copy) + ")";
  }
}

}  // namespace

const std::vector<CadFormat>& cad_formats() {
  static const std::vector<CadFormat> formats = {
      {"stl", SurfaceKind::kTriangles, false}, {"step", SurfaceKind::kCurved, true},
      {"stp", SurfaceKind::kCurved, true},     {"iges", SurfaceKind::kCurved, true},
      {"igs", SurfaceKind::kCurved, true},     {"obj", SurfaceKind::kTriangles, false},
      {"ply", SurfaceKind::kTriangles, false}, {"off", SurfaceKind::kTriangles, false},
      {"3mf", SurfaceKind::kTriangles, true},  {"amf", SurfaceKind::kTriangles, true},
      {"dae", SurfaceKind::kTriangles, true},  {"gltf", SurfaceKind::kTriangles, true},
      {"glb", SurfaceKind::kTriangles, true},
  };
  return formats;
}

const CadFormat* cad_format(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  const auto& formats = cad_formats();
  const auto found = std::find_if(formats.begin(), formats.end(),
                                  [&](const CadFormat& format) { return format.ending == ending; });
  return found == formats.end() ? nullptr : &*found;
}

std::string cad_formats_text() {
  std::string words;
  const auto& formats = cad_formats();
  for (std::size_t k = 0; k < formats.size(); ++k)
    words += (k == 0 ? "" : k + 1 < formats.size() ? ", " : " or ") + upper_case(formats[k].ending);
  return words;
}

namespace {

CadParts read_by_kind(const std::filesystem::path& file, const CadFormat& format, double chord_tolerance) {
  if (format.surface == SurfaceKind::kCurved) return read_curved_faces(file, format, chord_tolerance);
  if (format.ending == "3mf") {
    check_3mf_coordinates(file);
    return read_3mf(file);
  }
  if (format.ending == "amf") check_amf_coordinates(amf_document(file));
  if (format.ending == "gltf" || format.ending == "glb")
    refuse_unread_corners(json_of_gltf(read_cad_file(file)));
  if (format.ending == "stl") {
    const std::string bytes = read_cad_file(file);
    if (is_text_stl(bytes)) return read_text_stl(bytes);
  }
  return read_triangles(file, format);
}

}  // namespace

CadParts read_cad_parts(const std::filesystem::path& file, const CadFormat& format, double chord_tolerance) {
  CadParts contents = read_by_kind(file, format, chord_tolerance);
  std::erase_if(contents.parts, [](const CadPart& part) { return part.mesh.triangles.empty(); });
  if (contents.parts.empty()) throw std::runtime_error("it contains no surface");
  make_names_unique(contents.parts);
  return contents;
}

}  // namespace diefill::geometry
