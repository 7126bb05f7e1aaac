#include "geometry/cad/cad_file.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

#include "geometry/cad/counted_elements.h"
#include "geometry/cad/read_binary_stl.h"
#include "geometry/cad/read_text_stl.h"
#include "geometry/cad/shown_text.h"
#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kStlHeader = 84;      // 80 bytes of text and the number of triangles
constexpr std::size_t kStlTriangle = 50;    // 12 floats and 2 bytes of attributes
constexpr std::size_t kLookForText = 1024;  // a text file shows its kind within so many bytes
constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30;  // bytes: binary STL of 21 million triangles

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Bytes that are only letters and line ends, unlike those of any binary file.
bool is_plain_text(const std::string& bytes) {
  const std::size_t looked_at = std::min(bytes.size(), kLookForText);
  return std::all_of(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(looked_at),
                     [](unsigned char c) { return c >= 0x20 || c == '\t' || c == '\r' || c == '\n'; });
}

/// What files of other kinds begin with.
struct FirstBytes {
  std::string bytes, kind;
  std::vector<std::string> endings;  ///< that may begin so
};

const std::vector<FirstBytes>& first_bytes() {
  static const std::vector<FirstBytes> all = {
      {"\x89PNG", "a PNG picture", {}},
      {"\xff\xd8\xff", "a JPEG picture", {}},
      {"%PDF", "a PDF document", {}},
      {"PK\x03\x04", "a ZIP archive", {"3mf", "amf"}},
      {"\x1f\x8b", "a gzip archive", {}},
      {"<!DOCTYPE html", "a web page", {}},
      {"<html", "a web page", {}},
      {"ISO-10303-21", "a STEP file", {"step", "stp"}},
      {"glTF", "a binary glTF file", {"glb", "gltf"}},
      {"ply\n", "a PLY file", {"ply"}},
      {"AC10", "an AutoCAD drawing", {}},
  };
  return all;
}

void check_first_bytes(const std::string& name, const std::string& ending, const std::string& bytes) {
  for (const FirstBytes& other : first_bytes()) {
    if (!bytes.starts_with(other.bytes)) continue;
    if (std::find(other.endings.begin(), other.endings.end(), ending) != other.endings.end()) continue;
    throw MeshError(name + " is actually " + other.kind + ", despite its file extension: " +
                    (other.endings.empty() ? "export the part from the CAD program"
                                           : "rename it to ." + other.endings.front()));
  }
}

/// Text of 16 bits a letter, which no importer reads.
void check_encoding(const std::string& name, const std::string& bytes) {
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
    throw MeshError(name + " is text in UTF-16: save it as plain text (UTF-8), or export it again");
}

/// The bytes a binary STL file declares, or the closing word of a text, must be there.
void check_stl(const std::string& name, const std::string& bytes) {
  if (is_text_stl(bytes)) {
    if (lower_case(bytes).find("endsolid") == std::string::npos)
      throw MeshError(name +
                      " is truncated: it is text without a closing 'endsolid'; export or copy it again");
    return;
  }
  if (is_plain_text(bytes))
    throw MeshError(name +
                    " is text, but not STL: it does not begin with 'solid'; give the file exported from CAD");
  if (is_binary_stl(bytes)) return;
  if (bytes.size() < kStlHeader)
    throw MeshError(name + " is truncated: " + std::to_string(bytes.size()) +
                    " bytes, but a binary STL has a header of 84 bytes; export or copy it again");
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, bytes.data() + kStlHeader - sizeof triangles, sizeof triangles);
  if (triangles == 0)
    throw MeshError(name + " holds no triangles: its header counts none" +
                    (bytes.size() == kStlHeader
                         ? std::string(", and nothing follows it")
                         : ", and the " + std::to_string(bytes.size() - kStlHeader) +
                               " bytes after it are not a whole number of triangles of 50 bytes") +
                    "; export the part again, as a solid");
  const std::size_t expected = kStlHeader + kStlTriangle * triangles;
  if (bytes.size() < expected)
    throw MeshError(name + " is truncated: its header declares " + std::to_string(triangles) +
                    " triangles (" + std::to_string(expected) + " bytes), but the file has " +
                    std::to_string(bytes.size()) + " bytes; export or copy it again");
}

/// Throws where a parameter outside of text is no number, such as nan: OpenCASCADE would compute with it
/// without end.
void check_step(const std::string& name, const std::string& bytes) {
  bool in_text = false;
  char before = ' ';
  std::size_t line = 1;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const char c = bytes[at];
    if (c == '\n') ++line;
    if (c == '\'') in_text = !in_text;
    const bool begins = before == '(' || before == ',';
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
    if (begins && (c == '-' || c == '+')) continue;
    before = c;
    if (in_text || !begins || std::isalpha(static_cast<unsigned char>(c)) == 0) continue;
    const std::string word = bytes.substr(at, 3), lower = lower_case(word);
    const auto after = static_cast<unsigned char>(at + 3 < bytes.size() ? bytes[at + 3] : ')');
    if ((lower == "nan" || lower == "inf") && std::isalnum(after) == 0 && after != '_')
      throw MeshError(name + " has \"" + word + "\" for a number in line " + std::to_string(line) +
                      ": export it again");
  }
}

}  // namespace

namespace {

/// What is in the folder instead of a file.
std::string kind_text(std::filesystem::file_type type) {
  switch (type) {
    case std::filesystem::file_type::directory:
      return "a directory: give the CAD file inside it";
    case std::filesystem::file_type::fifo:
      return "a pipe: give a regular file";
    case std::filesystem::file_type::socket:
      return "a socket: give a regular file";
    default:
      return "a device: give a regular file";
  }
}

/// Size in bytes of what is found to be a regular file that may be read. Devices and pipes never end.
std::size_t size_of_regular(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    throw MeshError(named(file) +
                    (error && error != std::errc::no_such_file_or_directory
                         ? " cannot be reached: " + error.message()
                         : " does not exist: check the path, which is relative to the scene file"));
  if (!std::filesystem::is_regular_file(status))
    throw MeshError(named(file) + " is " + kind_text(status.type()));
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) throw MeshError(named(file) + " cannot be read: " + error.message());
  if (size > kLargestFile)
    throw MeshError(named(file) + " has " + std::to_string(size >> 20U) + " MiB, allowed: up to " +
                    std::to_string(kLargestFile >> 20U) + " MiB: export it with fewer triangles");
  return static_cast<std::size_t>(size);
}

}  // namespace

std::string read_cad_file(const std::filesystem::path& file) {
  std::string bytes(size_of_regular(file), '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw MeshError(named(file) + " cannot be read: check its permissions");
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (bytes.empty()) throw MeshError(named(file) + " is empty: export it again");
  return bytes;
}

void check_content_matches_format(const std::filesystem::path& file, const std::string& ending,
                                  const std::string& bytes) {
  const std::string name = named(file);
  check_encoding(name, bytes);
  check_first_bytes(name, ending, bytes);
  if (ending == "stl") check_stl(name, bytes);
  if (ending == "ply") check_ply_elements(name, bytes);
  if (ending == "off") check_off_elements(name, bytes);
  if (ending == "step" || ending == "stp") check_step(name, bytes);
}

}  // namespace diefill::geometry
