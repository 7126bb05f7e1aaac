#include "geometry/solid_query.h"

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/topology.h"
#include "geometry/triangle_tree.h"
#include "geometry/winding.h"

namespace diefill::geometry {

namespace {

double angle_at(const Corners& corners, int k) {
  const auto at = [&](int i) { return corners[static_cast<std::size_t>(i % 3)]; };
  const Eigen::Vector3d u = at(k + 1) - at(k);
  const Eigen::Vector3d v = at(k + 2) - at(k);
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

std::vector<Corners> useful_triangles(const Mesh& mesh, const Topology& topology) {
  std::vector<Corners> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!topology.left_out[t]) triangles.push_back(corners_of(mesh, t));
  if (triangles.empty())
    throw MeshError("the mesh has no triangle with an area: there is no surface to measure from");
  return triangles;
}

}  // namespace

struct SolidQuery::Implementation {
  std::vector<std::size_t> mesh_triangle;                     ///< index in the mesh of a triangle in the tree
  std::vector<std::array<Eigen::Vector3d, 3>> edge_normal;    ///< pseudo-normals; zero where not clean
  std::vector<std::array<Eigen::Vector3d, 3>> corner_normal;  ///< pseudo-normals; zero where not clean
  TriangleTree tree;

  Implementation(const Mesh& mesh, const Topology& topology);
  void collect_pseudo_normals(const Mesh& mesh, const Topology& topology);
  bool is_behind(std::size_t triangle, const TriangleFoot& foot, const Eigen::Vector3d& point) const;
};

SolidQuery::Implementation::Implementation(const Mesh& mesh, const Topology& topology)
    : tree(useful_triangles(mesh, topology)) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!topology.left_out[t]) mesh_triangle.push_back(t);
  collect_pseudo_normals(mesh, topology);
}

/// Angle-weighted pseudo-normals tell inside from outside at edges and corners (Baerentzen and Aanaes 2005).
/// They need a clean fan of triangles round the corner; elsewhere they stay zero and the winding number
/// decides.
void SolidQuery::Implementation::collect_pseudo_normals(const Mesh& mesh, const Topology& topology) {
  const std::size_t count = mesh.triangles.size();
  std::vector<Eigen::Vector3d> normal(count, Eigen::Vector3d::Zero());
  std::vector<Eigen::Vector3d> at_vertex(mesh.vertices.size(), Eigen::Vector3d::Zero());
  std::vector<int> triangles_at(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < count; ++t) {
    if (topology.left_out[t]) continue;
    const Corners c = corners_of(mesh, t);
    normal[t] = area_vector(c).normalized();
    for (int k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(topology.corner(mesh, t, k));
      at_vertex[v] += angle_at(c, k) * normal[t];
      ++triangles_at[v];
    }
  }
  for (const std::size_t t : mesh_triangle) {
    edge_normal.emplace_back();
    corner_normal.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const auto slot = static_cast<std::size_t>(k);
      const std::int64_t across = topology.neighbour[t][slot];
      edge_normal.back()[slot] = Eigen::Vector3d::Zero();
      if (across != Topology::kNone)
        edge_normal.back()[slot] = normal[t] + normal[static_cast<std::size_t>(across)];
      const auto v = static_cast<std::size_t>(topology.corner(mesh, t, k));
      const bool whole_fan = fan_size(mesh, topology, t, k) == triangles_at[v];
      corner_normal.back()[slot] = whole_fan ? at_vertex[v] : Eigen::Vector3d(Eigen::Vector3d::Zero());
    }
  }
}

bool SolidQuery::Implementation::is_behind(std::size_t triangle, const TriangleFoot& foot,
                                           const Eigen::Vector3d& point) const {
  const auto slot = static_cast<std::size_t>(foot.feature.index);
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  switch (foot.feature.kind) {
    case TriangleFeature::Kind::kFace:
      normal = area_vector(tree.corners(triangle));
      break;
    case TriangleFeature::Kind::kEdge:
      normal = edge_normal[triangle][slot];
      break;
    case TriangleFeature::Kind::kCorner:
      normal = corner_normal[triangle][slot];
      break;
  }
  if (normal.isZero(0)) return winding_number(tree.triangles(), point) > 0.5;
  return normal.dot(point - foot.point) < 0;
}

SolidQuery::SolidQuery(const Mesh& mesh)
    : implementation_(std::make_unique<Implementation>(mesh, find_topology(mesh))) {}
SolidQuery::~SolidQuery() = default;
SolidQuery::SolidQuery(SolidQuery&&) noexcept = default;
SolidQuery& SolidQuery::operator=(SolidQuery&&) noexcept = default;

SolidQuery::Nearest SolidQuery::nearest(const Eigen::Vector3d& point) const {
  const TriangleTree::Hit hit = implementation_->tree.nearest(point);
  return {hit.foot.point, std::sqrt(hit.distance_squared), implementation_->mesh_triangle[hit.triangle]};
}

bool SolidQuery::inside(const Eigen::Vector3d& point) const {
  if (!implementation_->tree.box().contains(point)) return false;
  const TriangleTree::Hit hit = implementation_->tree.nearest(point);
  return implementation_->is_behind(hit.triangle, hit.foot, point);
}

SolidQuery::SignedNearest SolidQuery::signed_nearest(const Eigen::Vector3d& point) const {
  const TriangleTree::Hit hit = implementation_->tree.nearest(point);
  return {{hit.foot.point, std::sqrt(hit.distance_squared), implementation_->mesh_triangle[hit.triangle]},
          implementation_->is_behind(hit.triangle, hit.foot, point)};
}

double SolidQuery::signed_distance(const Eigen::Vector3d& point) const {
  const TriangleTree::Hit hit = implementation_->tree.nearest(point);
  const double distance = std::sqrt(hit.distance_squared);
  return implementation_->is_behind(hit.triangle, hit.foot, point) ? -distance : distance;
}

}  // namespace diefill::geometry
