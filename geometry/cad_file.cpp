#include "geometry/cad_file.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

#include "geometry/mesh.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kStlHeader = 84;      // 80 bytes of text and the number of triangles
constexpr std::size_t kStlTriangle = 50;    // 12 floats and 2 bytes of attributes
constexpr std::size_t kLookForText = 1024;  // a text file shows its first facet within so many bytes

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Binary files may begin with "solid" too; only text goes on with facets or the end.
bool is_text_stl(const std::string& bytes) {
  const std::string start = lower_case(bytes.substr(0, kLookForText));
  if (start.find('\0') != std::string::npos) return false;
  const std::size_t word = start.find_first_not_of(" \t\r\n");
  if (word == std::string::npos || start.compare(word, 5, "solid") != 0) return false;
  return start.find("facet") != std::string::npos || start.find("endsolid") != std::string::npos ||
         bytes.size() < kStlHeader;
}

}  // namespace

std::string read_cad_file(const std::filesystem::path& file) {
  const std::string name = std::string("'").append(file.string()).append("'");
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw MeshError("CAD file " + name +
                    " does not exist: check the path, it is taken relative to the scene file");
  if (std::filesystem::is_directory(file, error))
    throw MeshError("CAD file " + name + " is a directory: name the STL, OBJ, PLY or 3MF file inside it");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw MeshError("CAD file " + name + " cannot be read: check its permissions");
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (bytes.empty()) throw MeshError("CAD file " + name + " is empty: export it again");
  return bytes;
}

void check_stl_is_whole(const std::filesystem::path& file, const std::string& bytes) {
  const std::string name = "STL file '" + file.string() + "'";
  if (is_text_stl(bytes)) {
    if (lower_case(bytes).find("endsolid") == std::string::npos)
      throw MeshError(name +
                      " is cut short: it is text without a closing 'endsolid'; export or copy it again");
    return;
  }
  if (bytes.size() < kStlHeader)
    throw MeshError(name + " is cut short: " + std::to_string(bytes.size()) +
                    " bytes, while a binary STL has a header of 84 bytes; export or copy it again");
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, bytes.data() + kStlHeader - sizeof triangles, sizeof triangles);
  const std::size_t expected = kStlHeader + kStlTriangle * triangles;
  if (bytes.size() < expected)
    throw MeshError(name + " is cut short: its header promises " + std::to_string(triangles) +
                    " triangles (" + std::to_string(expected) + " bytes), the file has " +
                    std::to_string(bytes.size()) + " bytes; export or copy it again");
}

}  // namespace diefill::geometry
