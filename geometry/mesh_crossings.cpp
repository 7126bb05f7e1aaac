#include "geometry/mesh_crossings.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>

#include "geometry/topology.h"

namespace diefill::geometry {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using TriangleBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

constexpr double kShrink = 1e-5;
constexpr std::size_t kMostCrossings = 100000;  // piles of the same sheet have millions

struct Enough {};

Kernel::Triangle_3 shrunk_triangle(const Corners& corners) {
  const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
  const auto shrunk = [&](const Eigen::Vector3d& corner) {
    const Eigen::Vector3d p = corner + kShrink * (middle - corner);
    return Kernel::Point_3(p.x(), p.y(), p.z());
  };
  return {shrunk(corners[0]), shrunk(corners[1]), shrunk(corners[2])};
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> find_crossings(const Mesh& mesh,
                                                                const std::vector<std::uint8_t>& left_out) {
  // Triangles are made when asked for: of ten million, they would take most of a gigabyte.
  const auto triangle = [&](std::size_t t) { return shrunk_triangle(corners_of(mesh, t)); };
  std::vector<TriangleBox> boxes;
  boxes.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (left_out[t]) continue;
    boxes.emplace_back(triangle(t).bbox(), t);
  }
  std::vector<std::pair<std::size_t, std::size_t>> crossings;
  const auto look = [&](const TriangleBox& a, const TriangleBox& b) {
    const std::size_t low = std::min(a.info(), b.info());
    const std::size_t high = std::max(a.info(), b.info());
    if (CGAL::do_intersect(triangle(low), triangle(high))) crossings.emplace_back(low, high);
    if (crossings.size() == kMostCrossings) throw Enough();
  };
  try {
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), look);
  } catch (const Enough&) {
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace diefill::geometry
