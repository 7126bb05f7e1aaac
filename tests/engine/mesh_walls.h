// Walls of triangles for tests: planes cut up in every bad way, boxes.
#pragma once

#include <random>

#include "tests/engine/engine_test_support.h"

namespace diefill::engine {

/// Two triangles of the rectangle a, b, c, d (counter-clockwise seen by the powder); `other`: cut along the
/// other diagonal.
inline void add_rectangle(WallBodySpec& body, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                          const Eigen::Vector3d& c, const Eigen::Vector3d& d, bool other = false) {
  if (other) {
    body.triangles.push_back({{b, c, d}});
    body.triangles.push_back({{b, d, a}});
    return;
  }
  body.triangles.push_back({{a, b, c}});
  body.triangles.push_back({{a, c, d}});
}

/// The plane z = 0, powder above, over +-`half` (m): for x > 0 a net of uneven triangles about `cell` (m)
/// wide, for x < 0 two large ones, whose edge the corners of the others lie on.
inline WallBodySpec tessellated_plane(double half, double cell) {
  WallBodySpec body;
  body.name = "tessellated";
  add_rectangle(body, {-half, -half, 0}, {0, -half, 0}, {0, half, 0}, {-half, half, 0});
  const int along = static_cast<int>(half / cell), across = 2 * along;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-0.35, 0.35);
  std::vector<Eigen::Vector3d> node;
  for (int y = 0; y <= across; ++y)
    for (int x = 0; x <= along; ++x) {
      const double shift_x = x > 0 && x < along ? uniform(random) : 0;
      const double shift_y = y > 0 && y < across ? uniform(random) : 0;
      node.emplace_back((x + shift_x) * half / along, (y + shift_y) * half / along - half, 0);
    }
  const auto at = [&](int x, int y) { return node[static_cast<std::size_t>(y * (along + 1) + x)]; };
  for (int y = 0; y < across; ++y)
    for (int x = 0; x < along; ++x)
      add_rectangle(body, at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1), (x + y) % 3 == 0);
  return body;
}

/// A box between two corners (m): a solid with powder round it, or a vessel with powder inside.
inline WallBodySpec triangle_box(const Eigen::Vector3d& low, const Eigen::Vector3d& high, bool vessel) {
  WallBodySpec body;
  body.name = vessel ? "vessel" : "box";
  const auto corner = [&](int k) {
    return Eigen::Vector3d(k & 1 ? high.x() : low.x(), k & 2 ? high.y() : low.y(),
                           k & 4 ? high.z() : low.z());
  };
  constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& face : kFaces)
    add_rectangle(body, corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3]));
  if (vessel)
    for (auto& triangle : body.triangles) std::swap(triangle.corner[1], triangle.corner[2]);
  return body;
}

}  // namespace diefill::engine
