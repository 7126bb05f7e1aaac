#include "tests/geometry/sample_meshes.h"

#include <cmath>
#include <map>
#include <numbers>

namespace diefill::geometry::sample {

namespace {

void add_quad(Mesh& mesh, int a, int b, int c, int d) {
  mesh.triangles.emplace_back(a, b, c);
  mesh.triangles.emplace_back(a, c, d);
}

std::vector<Eigen::Vector2d> circle(double radius, int facets) {
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < facets; ++i) {
    const double angle = 2 * std::numbers::pi * i / facets;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return corners;
}

}  // namespace

Mesh box(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(i & 1 ? upper.x() : lower.x(), i & 2 ? upper.y() : lower.y(),
                               i & 4 ? upper.z() : lower.z());
  add_quad(mesh, 0, 2, 3, 1);
  add_quad(mesh, 4, 5, 7, 6);
  add_quad(mesh, 0, 1, 5, 4);
  add_quad(mesh, 2, 6, 7, 3);
  add_quad(mesh, 0, 4, 6, 2);
  add_quad(mesh, 1, 3, 7, 5);
  return mesh;
}

Mesh prism(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& hub, double height) {
  Mesh mesh;
  const int n = static_cast<int>(polygon.size());
  for (const double z : {0.0, height}) {
    for (const Eigen::Vector2d& p : polygon) mesh.vertices.emplace_back(p.x(), p.y(), z);
  }
  mesh.vertices.emplace_back(hub.x(), hub.y(), 0);
  mesh.vertices.emplace_back(hub.x(), hub.y(), height);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    add_quad(mesh, i, next, n + next, n + i);
    mesh.triangles.emplace_back(2 * n, next, i);
    mesh.triangles.emplace_back(2 * n + 1, n + i, n + next);
  }
  return mesh;
}

Mesh cylinder(double radius, double height, int facets) {
  return prism(circle(radius, facets), Eigen::Vector2d::Zero(), height);
}

Mesh tube(double inner, double outer, double height, int facets) {
  Mesh mesh;
  const int n = facets;
  for (const double radius : {inner, outer})
    for (const double z : {0.0, height})
      for (const Eigen::Vector2d& p : circle(radius, n)) mesh.vertices.emplace_back(p.x(), p.y(), z);
  const auto at = [n](int ring, int i) { return ring * n + i % n; };
  for (int i = 0; i < n; ++i) {
    add_quad(mesh, at(0, i + 1), at(0, i), at(1, i), at(1, i + 1));
    add_quad(mesh, at(2, i), at(2, i + 1), at(3, i + 1), at(3, i));
    add_quad(mesh, at(0, i), at(0, i + 1), at(2, i + 1), at(2, i));
    add_quad(mesh, at(1, i + 1), at(1, i), at(3, i), at(3, i + 1));
  }
  return mesh;
}

Mesh sphere(double radius, int levels) {
  const double t = std::numbers::phi;
  Mesh mesh;
  mesh.vertices = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                   {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middle;
    const auto split = [&](int a, int b) {
      const auto [place, is_new] =
          middle.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(mesh.vertices.size()));
      if (is_new)
        mesh.vertices.push_back(mesh.vertices[static_cast<std::size_t>(a)].normalized() +
                                mesh.vertices[static_cast<std::size_t>(b)].normalized());
      return place->second;
    };
    std::vector<Eigen::Vector3i> finer;
    for (const Eigen::Vector3i& f : mesh.triangles) {
      const int ab = split(f[0], f[1]);
      const int bc = split(f[1], f[2]);
      const int ca = split(f[2], f[0]);
      finer.insert(finer.end(), {{f[0], ab, ca}, {f[1], bc, ab}, {f[2], ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  for (Eigen::Vector3d& v : mesh.vertices) v = radius * v.normalized();
  return mesh;
}

Mesh joined(const Mesh& one, const Mesh& other) {
  Mesh both = one;
  const int offset = static_cast<int>(one.vertices.size());
  both.vertices.insert(both.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Eigen::Vector3i& t : other.triangles) both.triangles.emplace_back(t.array() + offset);
  return both;
}

Mesh inside_out(const Mesh& mesh) {
  Mesh turned = mesh;
  for (Eigen::Vector3i& t : turned.triangles) std::swap(t[1], t[2]);
  return turned;
}

}  // namespace diefill::geometry::sample
