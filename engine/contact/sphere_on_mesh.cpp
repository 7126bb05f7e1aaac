#include "engine/contact/sphere_on_mesh.h"

namespace diefill::engine {

namespace {

/// Over the sphere's radius: places on a seam that differ by less are one. CAD in single precision leaves
/// gaps of a few 1e-9 m where a corner of one triangle lies on the edge of another.
constexpr double kSamePlace = 1e-5;
/// At an edge, the faces on both sides are equally near up to the larger of this share of the radius and so
/// many m: CAD leaves steps of some 1e-8 m between them, by which the one whose plane the centre has left may
/// be the nearer.
constexpr double kEquallyNear = 1e-4, kStepOfCad = 5e-8;
/// Over the radius, distance of a centre that has come behind the surface: it still has a side to be pushed
/// to.
constexpr double kBehind = 1e-9;
/// Cosine of 15 degrees: normals that differ by less belong to one smooth surface.
constexpr double kSmooth = 0.9659258262890683;

}  // namespace

bool same_direction(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double along = a.dot(b);
  return along > 0 && along * along > kSmooth * kSmooth * a.squaredNorm() * b.squaredNorm();
}

Eigen::Vector3d separation_from_triangle(const WallBody& body, std::uint32_t part,
                                         const Eigen::Vector3d& place, double radius) {
  const WallTriangle& triangle = body.triangles()[part];
  const Eigen::Vector3d& normal = body.triangle_normals()[part];
  const NearestPoint nearest = nearest_point(triangle, place);
  // Along the normal itself, so that all triangles of a plane give the same to rounding.
  const double height = normal.dot(place - triangle.corner[0]);
  if (height <= 0) return kBehind * radius * normal;
  return nearest.inside ? Eigen::Vector3d(height * normal) : Eigen::Vector3d(place - nearest.point);
}

SphereOnMesh::SphereOnMesh(MeshWorkspace& workspace, const WallBody& body, const Eigen::Vector3d& place,
                           double radius)
    : workspace_(workspace),
      body_(body),
      place_(place),
      radius_(radius),
      tolerance_(kSamePlace * radius),
      equally_near_(std::max(kEquallyNear * radius, kStepOfCad)) {
  workspace_.feet.clear();
}

void SphereOnMesh::add_triangle(std::uint32_t near, std::uint32_t part) {
  const NearestPoint nearest = nearest_point(body_.triangles()[part], place_);
  const Eigen::Vector3d way = place_ - nearest.point;
  if (way.squaredNorm() >= reach() * reach()) return;
  workspace_.feet.push_back({near, part, nearest, way.norm(), body_.triangle_normals()[part].dot(way)});
}

std::span<const TriangleTouch> SphereOnMesh::touches() {
  auto& [feet, kept, touches, now] = workspace_;
  touches.clear();
  deepest_ = 0;
  if (feet.empty()) return touches;
  const TriangleFoot& nearest =
      *std::min_element(feet.begin(), feet.end(), [](const TriangleFoot& a, const TriangleFoot& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.height > b.height;
      });
  if (nearest.distance >= radius_) return touches;
  if (is_behind(nearest)) {
    touches.push_back({nearest.near, plain(separation(nearest))});
    deepest_ = radius_ + nearest.distance;
    return touches;
  }
  keep_nearest();
  for (const TriangleFoot* foot : kept) {
    const Eigen::Vector3d way = separation(*foot);
    const bool known = std::any_of(touches.begin(), touches.end(), [&](const TriangleTouch& t) {
      return same_direction(eigen(t.separation), way);
    });
    if (!known) touches.push_back({foot->near, plain(way)});
  }
  if (!kept.empty()) deepest_ = radius_ - kept.front()->distance;
  return touches;
}

/// Feet where the surface is nearest of all round about, the deepest first.
void SphereOnMesh::keep_nearest() {
  auto& kept = workspace_.kept;
  kept.clear();
  for (const TriangleFoot& foot : workspace_.feet)
    if (foot.distance < radius_ && foot.height > 0 && (foot.point.inside || is_nearest_around(foot)))
      kept.push_back(&foot);
  std::sort(kept.begin(), kept.end(), [](const TriangleFoot* a, const TriangleFoot* b) {
    return a->distance != b->distance ? a->distance < b->distance : a->near < b->near;
  });
}

Eigen::Vector3d SphereOnMesh::separation(const TriangleFoot& foot) const {
  return separation_from_triangle(body_, foot.part, place_, radius_);
}

bool SphereOnMesh::at_same_place(const TriangleFoot& one, const TriangleFoot& other) const {
  return (one.point.point - other.point.point).squaredNorm() <= tolerance_ * tolerance_;
}

/// Whether the sphere's centre is on the wrong side of the surface there, which is nearest of all: no
/// triangle as near sees it from the front.
bool SphereOnMesh::is_behind(const TriangleFoot& nearest) const {
  return std::none_of(workspace_.feet.begin(), workspace_.feet.end(), [&](const TriangleFoot& other) {
    return other.height > 0 && other.distance <= nearest.distance + equally_near_;
  });
}

/// Whether the surface is nearest to the centre at this point of an edge or corner, and this triangle is
/// the one to say so: the first of those that see most of the centre.
bool SphereOnMesh::is_nearest_around(const TriangleFoot& foot) const {
  for (const TriangleFoot& other : workspace_.feet) {
    if (&other == &foot || !reaches(other.part, foot.point.point)) continue;
    if (!at_same_place(foot, other)) {
      // Two edges almost in one may have feet apart and yet be equally near: the nearer one counts.
      if (other.distance < foot.distance) return false;
      continue;
    }
    if (other.height > foot.height || (other.height == foot.height && other.near < foot.near)) return false;
  }
  return true;
}

bool SphereOnMesh::reaches(std::uint32_t part, const Eigen::Vector3d& point) const {
  const WallTriangle& triangle = body_.triangles()[part];
  if (std::abs(body_.triangle_normals()[part].dot(point - triangle.corner[0])) > tolerance_) return false;
  return (nearest_point(triangle, point).point - point).squaredNorm() <= tolerance_ * tolerance_;
}

}  // namespace diefill::engine
