#include "geometry/read_binary_stl.h"

#include <array>
#include <cstdint>
#include <cstring>

#include "geometry/equal_vertices.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kHeader = 84;    // 80 bytes of text and the number of triangles
constexpr std::size_t kTriangle = 50;  // a normal, three corners, 2 bytes of attributes
constexpr std::size_t kCorners = 12;   // where they begin
constexpr std::size_t kAhead = 8;      // triangles; memory takes as long to come as these do

std::size_t triangles_in(const std::string& bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeader - sizeof count, sizeof count);
  return count;
}

std::array<Eigen::Vector3d, 3> corners_of(const std::string& bytes, std::size_t triangle) {
  std::array<float, 9> numbers{};
  std::memcpy(numbers.data(), bytes.data() + kHeader + kTriangle * triangle + kCorners, sizeof numbers);
  std::array<Eigen::Vector3d, 3> corners;
  // Adding 0 makes one of both zeros.
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] = {numbers[3 * k] + 0.0, numbers[3 * k + 1] + 0.0, numbers[3 * k + 2] + 0.0};
  return corners;
}

}  // namespace

bool is_binary_stl(const std::string& bytes) {
  return bytes.size() > kHeader && bytes.size() == kHeader + kTriangle * triangles_in(bytes);
}

CadParts read_binary_stl(const std::string& bytes) {
  const std::size_t count = triangles_in(bytes);
  EqualVertices places;
  places.reserve(count / 2);  // as closed surfaces have
  Mesh mesh;
  mesh.triangles.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    if (t + kAhead < count)
      for (const Eigen::Vector3d& corner : corners_of(bytes, t + kAhead)) places.expect(corner);
    const auto corners = corners_of(bytes, t);
    Eigen::Vector3i triangle;
    for (int k = 0; k < 3; ++k)
      triangle[k] = static_cast<int>(places.add(corners[static_cast<std::size_t>(k)]));
    mesh.triangles.push_back(triangle);
  }
  mesh.vertices = places.take_places();
  CadParts contents;
  contents.parts.push_back({"part 1", std::move(mesh)});
  return contents;
}

}  // namespace diefill::geometry
