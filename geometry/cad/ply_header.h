// What the head of a PLY file says about its elements.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace diefill::geometry {

/// A property of an element.
struct PlyProperty {
  std::string name, type;  ///< `type`: of its values, as PLY names it
  bool is_list = false;
  std::size_t bytes = 1;            ///< of a value in a binary file
  std::size_t bytes_of_length = 0;  ///< of a list's length
};

/// A kind of element, and how many of it follow the head.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

/// Elements follow the head in its order.
struct PlyHeader {
  bool is_text = true, is_big_endian = false;
  std::vector<PlyElement> elements;
  std::size_t end = 0;  ///< byte at which the elements begin
};

/// Nothing where the head has no end.
std::optional<PlyHeader> ply_header(const std::string& bytes);

/// The whole number without sign of so many bytes at `at`.
std::uint64_t ply_number(const std::string& bytes, std::size_t at, std::size_t size, bool is_big_endian);

/// The byte behind the element of a binary file that begins at `at`; npos where the file ends before.
std::size_t end_of_element(const PlyHeader& header, const PlyElement& element, const std::string& bytes,
                           std::size_t at);

}  // namespace diefill::geometry
