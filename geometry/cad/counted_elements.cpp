#include "geometry/cad/counted_elements.h"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <vector>

#include "geometry/cad/ply_header.h"
#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

namespace {

constexpr std::int64_t kMostCornersOfOff = 9;  // of a face; assimp 5.2 leaves out those with more

void refuse_count(const std::string& name, std::uint64_t count, const std::string& what, std::size_t bytes) {
  throw MeshError(name + " is truncated: its header declares " + std::to_string(count) + " " + what +
                  ", more than its " + std::to_string(bytes) + " bytes can hold; export or copy it again");
}

void refuse_end(const std::string& name, const std::string& what, std::uint64_t number, std::uint64_t count) {
  throw MeshError(name + " is truncated: it ends before " + what + " " + std::to_string(number) + " of " +
                  std::to_string(count) + "; export or copy it again");
}

/// Bytes of an element at the least, with empty lists; in a text a digit and a blank for each value.
std::size_t least_bytes(const PlyElement& element, bool is_text) {
  std::size_t bytes = 0;
  for (const PlyProperty& property : element.properties)
    bytes += is_text ? 2 : property.is_list ? property.bytes_of_length : property.bytes;
  return std::max<std::size_t>(1, bytes);
}

void check_binary_ply(const std::string& name, const PlyHeader& header, const std::string& bytes) {
  std::size_t at = header.end;
  for (const PlyElement& element : header.elements)
    for (std::uint64_t k = 0; k < element.count; ++k) {
      at = end_of_element(header, element, bytes, at);
      if (at == std::string::npos) refuse_end(name, element.name, k + 1, element.count);
    }
}

/// A text has an element a line.
void check_text_ply(const std::string& name, const PlyHeader& header, const std::string& bytes) {
  std::istringstream lines(bytes.substr(header.end));
  std::string line;
  for (const PlyElement& element : header.elements)
    for (std::uint64_t k = 0; k < element.count; ++k) {
      do {
        if (!std::getline(lines, line)) refuse_end(name, element.name, k + 1, element.count);
      } while (line.find_first_not_of(" \t\r") == std::string::npos);
    }
}

/// The next line with something else than a comment; false at the end.
bool next_line_of_off(std::istream& lines, std::istringstream& words) {
  for (std::string line; std::getline(lines, line);) {
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    words = std::istringstream(line);
    return true;
  }
  return false;
}

/// Passes over `vertices` corners, a line each, in files of kind OFF with three numbers; false for other
/// lines.
bool skip_corners_of_off(const std::string& name, const std::string& kind, std::uint64_t vertices,
                         std::istream& lines) {
  std::istringstream words;
  std::string coordinate;
  for (std::uint64_t k = 0; k < vertices; ++k) {
    if (!next_line_of_off(lines, words)) refuse_end(name, "corner", k + 1, vertices);
    if (!(words >> coordinate >> coordinate >> coordinate)) return false;
    if (kind == "OFF" && words >> coordinate) return false;
  }
  return true;
}

void check_face_of_off(const std::string& name, std::istream& words, std::uint64_t face,
                       std::uint64_t vertices) {
  std::int64_t corners = 0, corner = 0;
  words >> corners;
  if (corners > kMostCornersOfOff)
    throw MeshError(name + ": face " + std::to_string(face + 1) + " has " + std::to_string(corners) +
                    " corners, allowed in OFF: up to " + std::to_string(kMostCornersOfOff) +
                    "; export it with triangles, or as STL, OBJ or PLY");
  for (; corners > 0 && words >> corner; --corners)
    if (corner < 0 || static_cast<std::uint64_t>(corner) >= vertices)
      throw MeshError(name + " is damaged: face " + std::to_string(face + 1) + " has the corner " +
                      std::to_string(corner) + ", but its " + std::to_string(vertices) +
                      " corners are counted from 0; export it again");
}

}  // namespace

void check_ply_elements(const std::string& name, const std::string& bytes) {
  if (!bytes.starts_with("ply")) return;  // the importer says so
  const auto header = ply_header(bytes);
  if (!header)  // which importers would search for forever
    throw MeshError(name + " is truncated: its header has no line 'end_header'; export or copy it again");
  for (const PlyElement& element : header->elements)
    if (element.count > bytes.size() / least_bytes(element, header->is_text))
      refuse_count(name, element.count, element.name + " elements", bytes.size());
  (header->is_text ? check_text_ply : check_binary_ply)(name, *header, bytes);
}

void check_off_elements(const std::string& name, const std::string& bytes) {
  std::istringstream lines(bytes), words;
  std::string head;
  std::uint64_t vertices = 0, faces = 0;
  if (!next_line_of_off(lines, words) || !(words >> head) || !head.ends_with("OFF")) return;
  if (!(words >> vertices >> faces) && (!next_line_of_off(lines, words) || !(words >> vertices >> faces)))
    return;
  if (vertices > bytes.size() / 2) refuse_count(name, vertices, "corners", bytes.size());
  if (faces > bytes.size() / 2) refuse_count(name, faces, "faces", bytes.size());
  if (!skip_corners_of_off(name, head, vertices, lines)) return;
  for (std::uint64_t face = 0; face < faces; ++face) {
    if (!next_line_of_off(lines, words)) refuse_end(name, "face", face + 1, faces);
    check_face_of_off(name, words, face, vertices);
  }
}

}  // namespace diefill::geometry
