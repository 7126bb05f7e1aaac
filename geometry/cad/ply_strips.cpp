#include "geometry/cad/ply_strips.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "geometry/cad/ply_header.h"
#include "geometry/cad/shown_text.h"

namespace diefill::geometry {

namespace {

constexpr const char* kStrips = "tristrips";

using Triangle = std::array<std::int64_t, 3>;

/// Adds the triangles of the strips that -1 separates in a list. Every other one is listed the other way
/// round.
void add_triangles(const std::vector<std::int64_t>& list, std::vector<Triangle>& triangles) {
  std::size_t length = 0;  // corners of the strip so far
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (list[k] == -1) {
      length = 0;
      continue;
    }
    if (++length < 3) continue;
    Triangle triangle = {list[k - 2], list[k - 1], list[k]};
    // One without extent leads from a strip to the next.
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
    if (length % 2 == 0) std::swap(triangle[0], triangle[1]);
    triangles.push_back(triangle);
  }
}

std::int64_t whole_number(const std::string& word) {
  std::size_t end = 0;
  std::int64_t number = 0;
  try {
    number = std::stoll(word, &end);
  } catch (const std::logic_error&) {
    end = std::string::npos;
  }
  if (end != word.size())
    throw std::runtime_error("a triangle strip has '" + shown(word, 30) + "' for the number of a corner");
  return number;
}

/// The byte behind the line of a text that begins at `at`.
std::size_t end_of_line(const std::string& bytes, std::size_t at) {
  const std::size_t end = bytes.find('\n', at);
  return end == std::string::npos ? bytes.size() : end + 1;
}

/// The line with something in it that begins at `at` or behind; `at` becomes the byte behind it.
std::string next_line(const std::string& bytes, std::size_t& at) {
  std::string line;
  while (at < bytes.size() && line.find_first_not_of(" \t\r\n") == std::string::npos) {
    const std::size_t begin = at;
    at = end_of_line(bytes, at);
    line = bytes.substr(begin, at - begin);
  }
  return line;
}

std::vector<std::int64_t> list_in_text(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  std::vector<std::int64_t> list;
  if (!(words >> word)) throw std::runtime_error("it ends within its triangle strips");
  const std::int64_t length = whole_number(word);
  while (words >> word) list.push_back(whole_number(word));
  if (length != static_cast<std::int64_t>(list.size()))
    throw std::runtime_error("a triangle strip counts " + std::to_string(length) + " corners, but has " +
                             std::to_string(list.size()) + " in its line");
  return list;
}

/// Signed as its type says; the largest number of four bytes stands for -1 too.
std::int64_t corner_in_binary(const std::string& bytes, std::size_t at, const PlyProperty& property,
                              bool is_big_endian) {
  const std::uint64_t number = ply_number(bytes, at, property.bytes, is_big_endian);
  const bool has_sign = !property.type.starts_with("u");
  switch (property.bytes) {
    case 1:
      return has_sign ? static_cast<std::int8_t>(number) : static_cast<std::int64_t>(number);
    case 2:
      return has_sign ? static_cast<std::int16_t>(number) : static_cast<std::int64_t>(number);
    default:
      return static_cast<std::int32_t>(number);
  }
}

std::vector<std::int64_t> list_in_binary(const std::string& bytes, std::size_t at,
                                         const PlyProperty& property, bool is_big_endian) {
  std::vector<std::int64_t> list(
      static_cast<std::size_t>(ply_number(bytes, at, property.bytes_of_length, is_big_endian)));
  at += property.bytes_of_length;
  for (std::int64_t& corner : list) {
    corner = corner_in_binary(bytes, at, property, is_big_endian);
    at += property.bytes;
  }
  return list;
}

/// Passes `at` over the elements of a kind. Calls `look(line, begin)` with the line of each in a text, and
/// with the byte where it begins.
template <class Look>
void pass_over(const PlyHeader& header, const PlyElement& element, const std::string& bytes, std::size_t& at,
               Look look) {
  for (std::uint64_t k = 0; k < element.count; ++k) {
    const std::size_t begin = at;
    std::string line;
    if (header.is_text)
      line = next_line(bytes, at);
    else
      at = end_of_element(header, element, bytes, at);
    if (at == std::string::npos) throw std::runtime_error("it ends within its elements");
    look(line, begin);
  }
}

void append_face(const PlyHeader& header, const Triangle& triangle, std::string& bytes) {
  if (header.is_text) {
    bytes += "3 " + std::to_string(triangle[0]) + ' ' + std::to_string(triangle[1]) + ' ' +
             std::to_string(triangle[2]) + '\n';
    return;
  }
  bytes += '\3';
  for (const std::int64_t corner : triangle)
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned shift = 8 * (header.is_big_endian ? 3 - k : k);
      bytes += static_cast<char>(static_cast<std::uint64_t>(corner) >> shift & 0xffU);
    }
}

/// The head of the file with `triangles` faces in place of strips, and without other faces.
std::string head_with_faces(const std::string& head, std::size_t triangles) {
  std::istringstream lines(head);
  std::string kept;
  bool left_out = false;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word, name;
    words >> word >> name;
    if (word == "element") {
      left_out = name == kStrips || name == "face";
      if (name == kStrips)
        kept += "element face " + std::to_string(triangles) + "\nproperty list uchar int vertex_indices\n";
    } else if (word != "property") {
      left_out = false;
    }
    if (!left_out) kept += line + '\n';
  }
  return kept;
}

void check_strips(const PlyHeader& header, const PlyElement& strips) {
  for (const PlyElement& element : header.elements)
    if (element.name == "face" && element.count > 0)
      throw std::runtime_error("it holds faces and triangle strips: export it with triangles alone");
  const auto& properties = strips.properties;
  const bool whole = properties.size() == 1 && properties.front().is_list &&
                     !properties.front().type.starts_with("f") && properties.front().type != "double";
  if (!whole)
    throw std::runtime_error(
        "its triangle strips are not one list of whole numbers: export it with triangles");
}

}  // namespace

std::string with_faces_for_strips(std::string bytes) {
  const auto header = ply_header(bytes);
  if (!header) return bytes;
  const auto& elements = header->elements;
  const auto strips = std::find_if(elements.begin(), elements.end(),
                                   [](const PlyElement& element) { return element.name == kStrips; });
  if (strips == elements.end()) return bytes;
  check_strips(*header, *strips);
  std::size_t at = header->end;
  const auto nothing = [](const std::string&, std::size_t) {};
  for (auto before = elements.begin(); before != strips; ++before)
    pass_over(*header, *before, bytes, at, nothing);
  const std::size_t begin = at;
  std::vector<Triangle> triangles;
  pass_over(*header, *strips, bytes, at, [&](const std::string& line, std::size_t place) {
    add_triangles(header->is_text
                      ? list_in_text(line)
                      : list_in_binary(bytes, place, strips->properties.front(), header->is_big_endian),
                  triangles);
  });
  std::string with_faces = head_with_faces(bytes.substr(0, header->end), triangles.size());
  with_faces.append(bytes, header->end, begin - header->end);
  for (const Triangle& triangle : triangles) append_face(*header, triangle, with_faces);
  return with_faces.append(bytes, at);
}

}  // namespace diefill::geometry
