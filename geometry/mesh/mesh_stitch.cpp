#include "geometry/mesh/mesh_stitch.h"

#include <CGAL/box_intersection_d.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>

#include "geometry/grids/point_grid.h"
#include "geometry/mesh/half_edges.h"
#include "geometry/mesh/mesh_check.h"
#include "geometry/mesh/topology.h"

namespace diefill::geometry {

namespace {

constexpr int kMaxPasses = 8;  // each splits one side of a triangle; what is split has fewer sides left

using Box3 = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

/// An open edge in the sense of its triangle.
struct OpenEdge {
  std::size_t triangle = 0;
  int side = 0;
  Eigen::Vector3d from, to;
};

std::size_t vertex_of(const Mesh& mesh, const Topology& topology, std::size_t triangle, int k) {
  return static_cast<std::size_t>(topology.corner(mesh, triangle, k));
}

std::vector<OpenEdge> open_edges(const Mesh& mesh, const Topology& topology) {
  std::vector<OpenEdge> open;
  const HalfEdges edges(mesh, topology, [&](std::size_t t) { return !topology.left_out[t]; });
  edges.visit_edges([&](std::size_t, std::span<const HalfEdge> sides) {
    if (sides.size() != 1) return;
    const std::size_t t = sides.front().triangle();
    const int k = sides.front().side();
    open.push_back({t, k, mesh.vertices[vertex_of(mesh, topology, t, k)],
                    mesh.vertices[vertex_of(mesh, topology, t, (k + 1) % 3)]});
  });
  return open;
}

std::set<std::size_t> corners_of_edges(const Mesh& mesh, const Topology& topology,
                                       const std::vector<OpenEdge>& open) {
  std::set<std::size_t> corners;
  for (const OpenEdge& edge : open)
    for (const int k : {edge.side, (edge.side + 1) % 3})
      corners.insert(vertex_of(mesh, topology, edge.triangle, k));
  return corners;
}

Box3 box_round(const Eigen::Vector3d& one, const Eigen::Vector3d& other, double margin, std::size_t info) {
  const Eigen::Vector3d low = one.cwiseMin(other).array() - margin;
  const Eigen::Vector3d high = one.cwiseMax(other).array() + margin;
  const CGAL::Bbox_3 box(low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
  return {box, info};
}

/// A corner on an edge: how far along it, m, and which.
using OnEdge = std::pair<double, std::size_t>;

/// Corners within tolerance of the inside of each open edge, in order along it.
std::vector<std::vector<OnEdge>> corners_on(const Mesh& mesh, const Topology& topology,
                                            const std::vector<OpenEdge>& open, double tolerance) {
  std::vector<Box3> edges, corners;
  for (std::size_t e = 0; e < open.size(); ++e)
    edges.push_back(box_round(open[e].from, open[e].to, tolerance, e));
  for (const std::size_t vertex : corners_of_edges(mesh, topology, open))
    corners.push_back(box_round(mesh.vertices[vertex], mesh.vertices[vertex], 0, vertex));
  std::vector<std::vector<OnEdge>> on(open.size());
  CGAL::box_intersection_d(edges.begin(), edges.end(), corners.begin(), corners.end(),
                           [&](const Box3& edge, const Box3& corner) {
                             const OpenEdge& it = open[edge.info()];
                             const Eigen::Vector3d along = it.to - it.from;
                             const Eigen::Vector3d way = mesh.vertices[corner.info()] - it.from;
                             const double length = along.norm(), at = way.dot(along) / length;
                             if (at <= tolerance || at >= length - tolerance) return;
                             if ((way - at / length * along).norm() > tolerance) return;
                             on[edge.info()].emplace_back(at, corner.info());
                           });
  for (auto& list : on) std::sort(list.begin(), list.end());
  return on;
}

/// Exchanges the triangle for a fan whose spokes go from the corner opposite the edge.
void split(Mesh& mesh, const OpenEdge& edge, const std::vector<OnEdge>& on) {
  const Eigen::Vector3i old = mesh.triangles[edge.triangle];
  const int apex = old[(edge.side + 2) % 3], last = old[(edge.side + 1) % 3];
  int from = old[edge.side];
  for (std::size_t k = 0; k <= on.size(); ++k) {
    const int to = k < on.size() ? static_cast<int>(on[k].second) : last;
    if (k == 0)
      mesh.triangles[edge.triangle] = {from, to, apex};
    else
      mesh.triangles.emplace_back(from, to, apex);
    from = to;
  }
}

void keep_triangles(Mesh& mesh, const std::vector<std::uint8_t>& dropped) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!dropped[t]) mesh.triangles[kept++] = mesh.triangles[t];
  mesh.triangles.resize(kept);
}

}  // namespace

WeldedCorners weld_loose_corners(Mesh& mesh, double tolerance) {
  const Topology topology = find_topology(mesh);
  PointGrid kept(2 * tolerance);
  WeldedCorners welded;
  std::map<std::size_t, Eigen::Vector3d> moved;
  for (const std::size_t vertex : corners_of_edges(mesh, topology, open_edges(mesh, topology))) {
    const Eigen::Vector3d place = mesh.vertices[vertex];
    const std::size_t same = kept.nearest_within(place, tolerance);
    if (same == PointGrid::kNone) {
      kept.insert(place);
      continue;
    }
    welded.farthest = std::max(welded.farthest, (kept.points()[same] - place).norm());
    moved[vertex] = kept.points()[same];
    ++welded.count;
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const auto found = moved.find(static_cast<std::size_t>(topology.vertex[v]));
    if (found != moved.end()) mesh.vertices[v] = found->second;
  }
  return welded;
}

std::size_t split_edges_at_corners(Mesh& mesh, double tolerance) {
  std::size_t count = 0;
  const std::size_t most = 4 * mesh.triangles.size() + 1000;
  for (int pass = 0; pass < kMaxPasses && mesh.triangles.size() < most; ++pass) {
    const Topology topology = find_topology(mesh);
    const std::vector<OpenEdge> open = open_edges(mesh, topology);
    const auto on = corners_on(mesh, topology, open, tolerance);
    std::set<std::size_t> touched;
    for (std::size_t e = 0; e < open.size(); ++e)
      if (!on[e].empty() && touched.insert(open[e].triangle).second) split(mesh, open[e], on[e]);
    if (touched.empty()) break;
    count += touched.size();
  }
  return count;
}

std::size_t drop_triangles_without_area(Mesh& mesh) {
  const std::size_t before = mesh.triangles.size();
  std::vector<std::uint8_t> dropped(before, 0);
  for (std::size_t t = 0; t < before; ++t) dropped[t] = is_degenerate(corners_of(mesh, t)) ? 1 : 0;
  keep_triangles(mesh, dropped);
  return before - mesh.triangles.size();
}

std::size_t drop_copies_of_triangles(Mesh& mesh) {
  const std::size_t before = mesh.triangles.size();
  std::vector<std::uint8_t> dropped = find_topology(mesh).left_out;
  for (std::size_t t = 0; t < before; ++t)
    if (is_degenerate(corners_of(mesh, t))) dropped[t] = 0;  // which may close the surface
  keep_triangles(mesh, dropped);
  return before - mesh.triangles.size();
}

std::size_t drop_opposite_pairs(Mesh& mesh) {
  const Topology topology = find_topology(mesh);
  std::map<std::array<std::size_t, 3>, std::vector<std::pair<std::size_t, bool>>> groups;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::size_t, 3> c = {vertex_of(mesh, topology, t, 0), vertex_of(mesh, topology, t, 1),
                                    vertex_of(mesh, topology, t, 2)};
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    const bool forward = c[1] < c[2];
    if (!forward) std::swap(c[1], c[2]);
    groups[c].emplace_back(t, forward);
  }
  std::vector<std::uint8_t> dropped(mesh.triangles.size(), 0);
  std::size_t pairs = 0;
  for (const auto& [corners, members] : groups) {
    const auto forward =
        std::count_if(members.begin(), members.end(), [](const auto& m) { return m.second; });
    if (2 * static_cast<std::size_t>(forward) != members.size()) continue;
    for (const auto& member : members) dropped[member.first] = 1;
    pairs += members.size() / 2;
  }
  if (pairs == 0) return 0;
  Mesh rest = mesh;
  keep_triangles(rest, dropped);
  const MeshFindings before = check_mesh(mesh), after = check_mesh(rest);
  const bool better = !rest.triangles.empty() && after.open_edges <= before.open_edges &&
                      after.non_manifold_edges < before.non_manifold_edges;
  if (!better) return 0;
  mesh = std::move(rest);
  return pairs;
}

}  // namespace diefill::geometry
