#include "geometry/solid/solid_query.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/grids/all_cores.h"
#include "geometry/mesh/topology.h"
#include "geometry/mesh/triangle_tree.h"
#include "geometry/mesh/winding.h"

namespace diefill::geometry {

namespace {

double angle_at(const Corners& corners, int k) {
  const auto at = [&](int i) { return corners[static_cast<std::size_t>(i % 3)]; };
  const Eigen::Vector3d u = at(k + 1) - at(k);
  const Eigen::Vector3d v = at(k + 2) - at(k);
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// The triangles that count, by their number in the mesh.
std::vector<std::uint32_t> useful_triangles(const Topology& topology) {
  std::vector<std::uint32_t> useful;
  useful.reserve(topology.left_out.size());
  for (std::size_t t = 0; t < topology.left_out.size(); ++t)
    if (!topology.left_out[t]) useful.push_back(static_cast<std::uint32_t>(t));
  if (useful.empty())
    throw MeshError("the mesh has no triangle with an area: there is no surface to measure from");
  return useful;
}

}  // namespace

struct SolidQuery::Implementation {
  static constexpr std::uint32_t kNone = 0xffffffffU;
  using Three = std::array<std::uint32_t, 3>;

  Topology topology;
  // Millions of triangles: numbers in place of the normals that they lead to. By triangle of the tree:
  std::vector<std::uint32_t> mesh_triangle;  ///< index in the mesh
  std::vector<Three> across;                 ///< triangle of the tree across each edge, or kNone
  std::vector<Three> vertex;                 ///< vertex of the mesh at each corner
  std::vector<std::uint32_t> triangles_at;   ///< by vertex of the mesh: how many have a corner there
  TriangleTree tree;

  Implementation(const Mesh& mesh, Topology adjacency);
  void name_neighbours(const Mesh& mesh);
  Eigen::Vector3d normal_of(std::size_t triangle) const {
    return area_vector(tree.corners(triangle)).normalized();
  }
  std::vector<std::uint32_t> fan_round(std::size_t triangle, std::size_t corner) const;
  Eigen::Vector3d corner_normal(std::size_t triangle, std::size_t corner) const;
  Eigen::Vector3d pseudo_normal(std::size_t triangle, const TriangleFeature& feature) const;
  bool is_behind(std::size_t triangle, const TriangleFoot& foot, const Eigen::Vector3d& point) const;
  Known signed_by(const TriangleTree::Hit& hit, const Eigen::Vector3d& point) const;
};

SolidQuery::Implementation::Implementation(const Mesh& mesh, Topology adjacency)
    : topology(std::move(adjacency)),
      mesh_triangle(useful_triangles(topology)),
      across(mesh_triangle.size()),
      vertex(mesh_triangle.size()),
      triangles_at(mesh.vertices.size(), 0),
      tree(mesh_triangle.size(), [&](std::size_t own) { return corners_of(mesh, mesh_triangle[own]); }) {
  name_neighbours(mesh);
}

void SolidQuery::Implementation::name_neighbours(const Mesh& mesh) {
  std::vector<std::uint32_t> of_mesh(mesh.triangles.size(), kNone);
  for (std::uint32_t own = 0; own < mesh_triangle.size(); ++own) of_mesh[mesh_triangle[own]] = own;
  in_parts_on_all_cores(mesh_triangle.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t own = begin; own < end; ++own)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t t = mesh_triangle[own];
        const std::int64_t other = topology.neighbour[t][k];
        across[own][k] = other == Topology::kNone ? kNone : of_mesh[static_cast<std::size_t>(other)];
        vertex[own][k] = static_cast<std::uint32_t>(topology.corner(mesh, t, static_cast<int>(k)));
      }
  });
  for (const Three& corners : vertex)
    for (const std::uint32_t corner : corners) ++triangles_at[corner];
}

/// The triangles met when walking round a corner; empty where they are no clean fan of all that have a corner
/// there.
std::vector<std::uint32_t> SolidQuery::Implementation::fan_round(std::size_t triangle,
                                                                 std::size_t corner) const {
  const std::uint32_t centre = vertex[triangle][corner];
  std::vector<std::uint32_t> fan;
  auto current = static_cast<std::uint32_t>(triangle);
  do {
    fan.push_back(current);
    const Three& corners = vertex[current];
    const auto at =
        static_cast<std::size_t>(std::find(corners.begin(), corners.end(), centre) - corners.begin());
    current = across[current][at];
    if (current == kNone) return {};
  } while (current != triangle);
  if (fan.size() != triangles_at[centre]) return {};
  return fan;
}

/// Angle-weighted pseudo-normals distinguish inside from outside at edges and corners (Baerentzen and Aanaes
/// 2005). They need a clean fan of triangles around the corner; elsewhere the winding number decides. Few
/// questions end at a corner, so its normal is computed on request. Summed in the order of the triangles, it
/// does not depend on where the walk around the corner began.
Eigen::Vector3d SolidQuery::Implementation::corner_normal(std::size_t triangle, std::size_t corner) const {
  std::vector<std::uint32_t> fan = fan_round(triangle, corner);
  std::sort(fan.begin(), fan.end());
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (const std::uint32_t own : fan) {
    const Three& corners = vertex[own];
    const auto at = std::find(corners.begin(), corners.end(), vertex[triangle][corner]) - corners.begin();
    normal += angle_at(tree.corners(own), static_cast<int>(at)) * normal_of(own);
  }
  return normal;
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
      return corner_normal(triangle, slot);
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

SolidQuery::Known SolidQuery::Implementation::signed_by(const TriangleTree::Hit& hit,
                                                        const Eigen::Vector3d& point) const {
  return {{{hit.foot.point, std::sqrt(hit.distance_squared), mesh_triangle[hit.triangle]},
           is_behind(hit.triangle, hit.foot, point)},
          point,
          static_cast<std::uint32_t>(hit.triangle),
          hit.alone};
}

SolidQuery::SolidQuery(const Mesh& mesh) : SolidQuery(mesh, find_topology(mesh)) {}

SolidQuery::SolidQuery(const Mesh& mesh, Topology topology)
    : implementation_(std::make_shared<const Implementation>(mesh, std::move(topology))) {}

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
  return implementation_->signed_by(implementation_->tree.nearest(point), point);
}

SolidQuery::Known SolidQuery::signed_nearest(const Eigen::Vector3d& point, double guess) const {
  return implementation_->signed_by(implementation_->tree.nearest(point, guess), point);
}

SolidQuery::Known SolidQuery::signed_nearest(const Eigen::Vector3d& point, const Known& known) const {
  // No other triangle is nearly as near, so this margin makes none of them the nearest.
  constexpr double kRounding = 1e-11;
  if (!known.alone || (point - known.query_point).norm() > kRounding * known.distance)
    return signed_nearest(point, (point - known.point).norm());
  TriangleTree::Hit hit;
  hit.triangle = known.tree_triangle;
  hit.foot = closest_point(implementation_->tree.corners(hit.triangle), point);
  hit.distance_squared = (hit.foot.point - point).squaredNorm();
  return implementation_->signed_by(hit, point);
}

const Topology& SolidQuery::topology() const {
  return implementation_->topology;
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
