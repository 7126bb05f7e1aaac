#include "geometry/mesh/mesh_wrap.h"

#include <CGAL/alpha_wrap_3.h>

#include <algorithm>
#include <cmath>

#include "geometry/mesh/cgal_mesh.h"
#include "geometry/mesh/topology.h"
#include "geometry/mesh/triangle_tree.h"

namespace diefill::geometry {

namespace {

constexpr double kStandOff = 1.0 / 30;  // of the detail, as CGAL's manual recommends

double largest_one_way(const Mesh& from, const Mesh& to) {
  const TriangleTree tree(to.triangles.size(), [&](std::size_t t) { return corners_of(to, t); });
  double largest = 0;
  const auto include = [&](const Eigen::Vector3d& point) {
    largest = std::max(largest, tree.nearest(point).distance_squared);
  };
  for (std::size_t t = 0; t < from.triangles.size(); ++t) {
    const Corners corners = corners_of(from, t);
    for (const auto& corner : corners) include(corner);
    include((corners[0] + corners[1] + corners[2]) / 3);
  }
  return std::sqrt(largest);
}

}  // namespace

Mesh wrapped(const Mesh& mesh, double detail) {
  const cgal::Soup soup = cgal::soup_of(mesh);
  cgal::Surface surface;
  CGAL::alpha_wrap_3(soup.points, soup.triangles, detail, kStandOff * detail, surface);
  return cgal::mesh_of(surface);
}

double largest_distance(const Mesh& one, const Mesh& other) {
  return std::max(largest_one_way(one, other), largest_one_way(other, one));
}

}  // namespace diefill::geometry
