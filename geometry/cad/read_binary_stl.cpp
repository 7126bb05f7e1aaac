#include "geometry/cad/read_binary_stl.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>

#include "geometry/mesh/equal_vertices.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kHeader = 84;    // 80 bytes of text and the number of triangles
constexpr std::size_t kTriangle = 50;  // a normal, three corners, 2 bytes of attributes
constexpr std::size_t kCorners = 12;   // where they begin
constexpr std::size_t kAhead = 8;      // triangles; memory takes as long to come as these do

/// Triangles of the solid that begins at byte `from`; 0 where none does. Bytes may be left after the last
/// triangle. Programs that do not know the number before the end leave 0 or the largest one.
std::size_t triangles_at(const std::string& bytes, std::size_t from) {
  if (from > bytes.size() || bytes.size() - from < kHeader + kTriangle) return 0;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + from + kHeader - sizeof count, sizeof count);
  const std::size_t room = bytes.size() - from - kHeader;
  const bool not_counted = count == 0 || count == std::numeric_limits<std::uint32_t>::max();
  if (not_counted) return from == 0 && room % kTriangle == 0 ? room / kTriangle : 0;
  return count <= room / kTriangle ? count : 0;
}

std::array<Eigen::Vector3d, 3> corners_of(const std::string& bytes, std::size_t first, std::size_t triangle) {
  std::array<float, 9> numbers{};
  std::memcpy(numbers.data(), bytes.data() + first + kTriangle * triangle + kCorners, sizeof numbers);
  std::array<Eigen::Vector3d, 3> corners;
  // Adding 0 makes one of both zeros.
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] = {numbers[3 * k] + 0.0, numbers[3 * k + 1] + 0.0, numbers[3 * k + 2] + 0.0};
  return corners;
}

/// `count` triangles from the byte `first` on.
Mesh read_triangles_from(const std::string& bytes, std::size_t first, std::size_t count) {
  EqualVertices places;
  places.reserve(count / 2);  // as closed surfaces have
  Mesh mesh;
  mesh.triangles.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    if (t + kAhead < count)
      for (const Eigen::Vector3d& corner : corners_of(bytes, first, t + kAhead)) places.prefetch(corner);
    const auto corners = corners_of(bytes, first, t);
    Eigen::Vector3i triangle;
    for (int k = 0; k < 3; ++k)
      triangle[k] = static_cast<int>(places.add(corners[static_cast<std::size_t>(k)]));
    mesh.triangles.push_back(triangle);
  }
  mesh.vertices = places.take_places();
  return mesh;
}

std::string remark_on_rest(std::size_t bytes) {
  const std::string text = std::to_string(bytes) + " bytes after the last triangle ignored";
  if (bytes % kTriangle != 0) return text;
  const std::size_t triangles = bytes / kTriangle;
  return text + ": as many as " + std::to_string(triangles) +
         (triangles == 1 ? " triangle has" : " triangles have") +
         ", so the number in its header may be too small";
}

}  // namespace

bool is_binary_stl(const std::string& bytes) {
  return triangles_at(bytes, 0) > 0;
}

CadParts read_binary_stl(const std::string& bytes) {
  CadParts contents;
  std::size_t at = 0;
  for (std::size_t count = triangles_at(bytes, 0); count > 0; count = triangles_at(bytes, at)) {
    contents.parts.push_back({"part " + std::to_string(contents.parts.size() + 1),
                              read_triangles_from(bytes, at + kHeader, count)});
    at += kHeader + kTriangle * count;
  }
  if (at < bytes.size()) contents.remarks.push_back(remark_on_rest(bytes.size() - at));
  return contents;
}

}  // namespace diefill::geometry
