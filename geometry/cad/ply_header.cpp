#include "geometry/cad/ply_header.h"

#include <limits>
#include <map>
#include <sstream>

namespace diefill::geometry {

namespace {

/// Bytes of one value in a PLY file; types that PLY does not have are left to the importer.
std::size_t bytes_of(const std::string& type) {
  static const std::map<std::string, std::size_t> sizes = {
      {"short", 2}, {"ushort", 2}, {"int16", 2},   {"uint16", 2}, {"int", 4},     {"uint", 4},
      {"int32", 4}, {"uint32", 4}, {"float32", 4}, {"float", 4},  {"float64", 8}, {"double", 8}};
  const auto known = sizes.find(type);
  return known == sizes.end() ? 1 : known->second;
}

PlyProperty ply_property(std::istream& words, const std::string& type) {
  PlyProperty property;
  property.type = type;
  if (type == "list") {
    std::string length;
    words >> length >> property.type;
    property.is_list = true;
    property.bytes_of_length = bytes_of(length);
  }
  property.bytes = bytes_of(property.type);
  words >> property.name;
  return property;
}

}  // namespace

std::optional<PlyHeader> ply_header(const std::string& bytes) {
  PlyHeader header;
  std::istringstream lines(bytes);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word, type;
    words >> word >> type;
    if (word == "end_header" && line.find_first_not_of(" \t\r", word.size()) == std::string::npos) {
      header.end = lines.eof() ? bytes.size() : static_cast<std::size_t>(lines.tellg());
      return header;
    }
    if (word == "format")
      header.is_text = type == "ascii", header.is_big_endian = type == "binary_big_endian";
    if (word == "element") {
      header.elements.push_back({.name = type, .properties = {}});
      if (!(words >> header.elements.back().count))
        header.elements.back().count = std::numeric_limits<std::uint64_t>::max();
    }
    if (word == "property" && !header.elements.empty())
      header.elements.back().properties.push_back(ply_property(words, type));
  }
  return std::nullopt;
}

std::uint64_t ply_number(const std::string& bytes, std::size_t at, std::size_t size, bool is_big_endian) {
  std::uint64_t number = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t place = is_big_endian ? at + k : at + size - 1 - k;
    number = (number << 8U) | static_cast<unsigned char>(bytes[place]);
  }
  return number;
}

std::size_t end_of_element(const PlyHeader& header, const PlyElement& element, const std::string& bytes,
                           std::size_t at) {
  for (const PlyProperty& property : element.properties) {
    std::uint64_t values = 1;
    if (property.is_list) {
      if (property.bytes_of_length > bytes.size() - at) return std::string::npos;
      values = ply_number(bytes, at, property.bytes_of_length, header.is_big_endian);
      at += property.bytes_of_length;
    }
    if (values > (bytes.size() - at) / property.bytes) return std::string::npos;
    at += static_cast<std::size_t>(values) * property.bytes;
  }
  return at;
}

}  // namespace diefill::geometry
