#include "geometry/reach/moving_pair.h"

#include <algorithm>
#include <cmath>

#include "geometry/grids/point_grid.h"
#include "geometry/solid/surface_samples.h"

namespace diefill::geometry {

namespace {

constexpr double kWidestSpacing = 1e-3;  // m, of points on the surface
constexpr double kPointsAcross = 24;     // the extent of a small tool, at least
constexpr double kMaxPoints = 2e5;       // about so many on a surface

double surface_of(const Mesh& mesh) {
  double area = 0;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[static_cast<std::size_t>(triangle[0])];
    area += 0.5 * (mesh.vertices[static_cast<std::size_t>(triangle[1])] - a)
                      .cross(mesh.vertices[static_cast<std::size_t>(triangle[2])] - a)
                      .norm();
  }
  return area;
}

double spacing_of(const Mesh& mesh) {
  const double small = mesh.bounding_box().size().maxCoeff() / kPointsAcross;
  return std::max(std::min(kWidestSpacing, small), std::sqrt(surface_of(mesh) / kMaxPoints));
}

/// Points inside an edge, at most `spacing` apart.
template <class Add>
void sample_edge(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double spacing, const Add& add) {
  const int parts = static_cast<int>(std::ceil((to - from).norm() / spacing));
  for (int i = 1; i < parts; ++i) add(from + (to - from) * i / parts);
}

std::vector<Eigen::Vector3d> surface_points(const Mesh& mesh) {
  const double spacing = spacing_of(mesh);
  const bool thinned = static_cast<double>(mesh.vertices.size()) > kMaxPoints;
  PointGrid kept(0.5 * spacing);
  std::vector<Eigen::Vector3d> points;
  const auto add = [&](const Eigen::Vector3d& point) {
    if (thinned && kept.any_within(point, 0.5 * spacing)) return;
    if (thinned) kept.insert(point);
    points.push_back(point);
  };
  for (const auto& vertex : mesh.vertices) add(vertex);
  for (const auto& triangle : mesh.triangles) {
    Corners corners;
    for (int i = 0; i < 3; ++i)
      corners[static_cast<std::size_t>(i)] = mesh.vertices[static_cast<std::size_t>(triangle[i])];
    for (int i = 0; i < 3; ++i)
      if (triangle[i] < triangle[(i + 1) % 3])
        sample_edge(corners[static_cast<std::size_t>(i)], corners[static_cast<std::size_t>((i + 1) % 3)],
                    spacing, add);
    if (area_vector(corners).norm() > spacing * spacing)
      sample_triangle(corners, spacing, [&](const SurfaceSample& sample) { add(sample.point); });
  }
  return points;
}

SolidPose seen_from(const SolidPose& other, const SolidPose& own) {
  return {other.rotation.transpose() * own.rotation,
          other.rotation.transpose() * (own.translation - other.translation)};
}

Eigen::Vector3d corner_of(const Box& box, int corner) {
  return {(corner & 1) != 0 ? box.upper.x() : box.lower.x(),
          (corner & 2) != 0 ? box.upper.y() : box.lower.y(),
          (corner & 4) != 0 ? box.upper.z() : box.lower.z()};
}

/// m, farthest that a point of the box moves from one pose to the other.
double farthest_move(const Box& box, const SolidPose& from, const SolidPose& to) {
  double farthest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d point = corner_of(box, corner);
    farthest = std::max(farthest, (to.to_laboratory(point) - from.to_laboratory(point)).norm());
  }
  return farthest;
}

/// m, 0 inside.
double distance_to(const Box& box, const Eigen::Vector3d& point) {
  return (point - point.cwiseMax(box.lower).cwiseMin(box.upper)).norm();
}

bool apart(const Box& box, const SolidPose& pose, const Box& other) {
  Box posed;
  for (int corner = 0; corner < 8; ++corner) posed.include(pose.to_laboratory(corner_of(box, corner)));
  return (posed.lower.array() > other.upper.array()).any() ||
         (posed.upper.array() < other.lower.array()).any();
}

}  // namespace

double mean_thickness(const Mesh& mesh) {
  const double surface = surface_of(mesh);
  return surface > 0 ? 2 * std::abs(mesh.volume()) / surface : 0;
}

MovingPair::MovingPair(const Mesh& one, const SolidQuery& solid_of_one, const Mesh& other,
                       const SolidQuery& solid_of_other, double tolerance)
    : tolerance_(tolerance), sides_{side(one, solid_of_other), side(other, solid_of_one)} {}

MovingPair::Side MovingPair::side(const Mesh& mesh, const SolidQuery& into) {
  Side side;
  side.points = surface_points(mesh);
  side.free_until.assign(side.points.size(), 0);
  side.box = mesh.bounding_box();
  side.into = &into;
  return side;
}

std::optional<MovingPair::Cut> MovingPair::find_cut(const SolidPose& one, const SolidPose& other) {
  std::optional<Cut> deepest;
  find_cut_from(sides_[0], one, other, deepest);
  find_cut_from(sides_[1], other, one, deepest);
  return deepest;
}

void MovingPair::find_cut_from(Side& side, const SolidPose& own, const SolidPose& other,
                               std::optional<Cut>& deepest) const {
  const SolidPose seen = seen_from(other, own);
  if (side.last) side.travelled += farthest_move(side.box, *side.last, seen);
  side.last = seen;
  const Box& box = side.into->tree().box();
  if (apart(side.box, seen, box)) return;
  for (std::size_t k = 0; k < side.points.size(); ++k) {
    if (side.free_until[k] > side.travelled) continue;
    const Eigen::Vector3d point = seen.to_laboratory(side.points[k]);
    double distance = distance_to(box, point);
    if (distance <= 0) distance = side.into->signed_distance(point);
    side.free_until[k] = side.travelled + std::max(0.0, distance + tolerance_);
    if (-distance <= std::max(tolerance_, deepest ? deepest->depth : 0)) continue;
    deepest = Cut{-distance, other.to_laboratory(point)};
  }
}

}  // namespace diefill::geometry
