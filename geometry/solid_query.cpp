#include "geometry/solid_query.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>

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
  static constexpr std::uint32_t kNone = 0xffffffffU;
  using Three = std::array<std::uint32_t, 3>;

  // Millions of triangles: numbers in place of the normals that they lead to. By triangle of the tree:
  std::vector<std::uint32_t> mesh_triangle;    ///< index in the mesh
  std::vector<Three> across;                   ///< triangle of the tree across each edge, or kNone
  std::vector<Three> vertex;                   ///< place in vertex_normal of each corner, or kNone
  std::vector<Eigen::Vector3d> vertex_normal;  ///< pseudo-normals of corners
  TriangleTree tree;

  Implementation(const Mesh& mesh, const Topology& topology);
  void collect_pseudo_normals(const Mesh& mesh, const Topology& topology);
  void name_neighbours(const Mesh& mesh, const Topology& topology);
  Eigen::Vector3d normal_of(std::size_t triangle) const {
    return area_vector(tree.corners(triangle)).normalized();
  }
  Eigen::Vector3d pseudo_normal(std::size_t triangle, const TriangleFeature& feature) const;
  bool is_behind(std::size_t triangle, const TriangleFoot& foot, const Eigen::Vector3d& point) const;
};

SolidQuery::Implementation::Implementation(const Mesh& mesh, const Topology& topology)
    : tree(useful_triangles(mesh, topology)) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!topology.left_out[t]) mesh_triangle.push_back(static_cast<std::uint32_t>(t));
  collect_pseudo_normals(mesh, topology);
  name_neighbours(mesh, topology);
}

/// Angle-weighted pseudo-normals tell inside from outside at edges and corners (Baerentzen and Aanaes 2005).
/// They need a clean fan of triangles round the corner; elsewhere there is none and the winding number
/// decides.
void SolidQuery::Implementation::collect_pseudo_normals(const Mesh& mesh, const Topology& topology) {
  vertex_normal.assign(mesh.vertices.size(), Eigen::Vector3d::Zero());
  std::vector<int> triangles_at(mesh.vertices.size(), 0);
  for (std::size_t own = 0; own < mesh_triangle.size(); ++own) {
    const Eigen::Vector3d normal = normal_of(own);
    for (int k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(topology.corner(mesh, mesh_triangle[own], k));
      vertex_normal[v] += angle_at(tree.corners(own), k) * normal;
      ++triangles_at[v];
    }
  }
  // One clean fan has all triangles at its corner, so that each tells the same as the first.
  enum : std::uint8_t { kUnknown, kWhole, kBroken };
  std::vector<std::uint8_t> fan(mesh.vertices.size(), kUnknown);
  for (const std::uint32_t t : mesh_triangle) {
    vertex.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(topology.corner(mesh, t, k));
      if (fan[v] == kUnknown) fan[v] = fan_size(mesh, topology, t, k) == triangles_at[v] ? kWhole : kBroken;
      vertex.back()[static_cast<std::size_t>(k)] = fan[v] == kWhole ? static_cast<std::uint32_t>(v) : kNone;
    }
  }
}

void SolidQuery::Implementation::name_neighbours(const Mesh& mesh, const Topology& topology) {
  std::vector<std::uint32_t> of_mesh(mesh.triangles.size(), kNone);
  for (std::uint32_t own = 0; own < mesh_triangle.size(); ++own) of_mesh[mesh_triangle[own]] = own;
  for (const std::uint32_t t : mesh_triangle) {
    across.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t other = topology.neighbour[t][k];
      across.back()[k] = other == Topology::kNone ? kNone : of_mesh[static_cast<std::size_t>(other)];
    }
  }
}

/// Zero where the surface is not clean.
Eigen::Vector3d SolidQuery::Implementation::pseudo_normal(std::size_t triangle,
                                                          const TriangleFeature& feature) const {
  const auto slot = static_cast<std::size_t>(feature.index);
  switch (feature.kind) {
    case TriangleFeature::Kind::kEdge:
      if (across[triangle][slot] == kNone) return Eigen::Vector3d::Zero();
      return normal_of(triangle) + normal_of(across[triangle][slot]);
    case TriangleFeature::Kind::kCorner:
      if (vertex[triangle][slot] == kNone) return Eigen::Vector3d::Zero();
      return vertex_normal[vertex[triangle][slot]];
    default:
      return area_vector(tree.corners(triangle));
  }
}

bool SolidQuery::Implementation::is_behind(std::size_t triangle, const TriangleFoot& foot,
                                           const Eigen::Vector3d& point) const {
  const Eigen::Vector3d normal = pseudo_normal(triangle, foot.feature);
  if (normal.isZero(0)) return winding_number(tree.triangles(), point) > 0.5;
  return normal.dot(point - foot.point) < 0;
}

SolidQuery::SolidQuery(const Mesh& mesh)
    : implementation_(std::make_shared<const Implementation>(mesh, find_topology(mesh))) {}

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

const TriangleTree& SolidQuery::tree() const {
  return implementation_->tree;
}

double SolidQuery::signed_distance(const Eigen::Vector3d& point) const {
  const TriangleTree::Hit hit = implementation_->tree.nearest(point);
  const double distance = std::sqrt(hit.distance_squared);
  return implementation_->is_behind(hit.triangle, hit.foot, point) ? -distance : distance;
}

}  // namespace diefill::geometry
