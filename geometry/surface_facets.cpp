#include "geometry/surface_facets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace diefill::geometry {

namespace {

/// Corners of one plane may be off it by this part of the mesh's diagonal (single precision has steps of
/// 6e-8).
constexpr double kPlaneTolerance = 3e-7;
/// Cosine of the largest angle between a plane and the normal of a triangle in it: thin slivers have loose
/// normals.
constexpr double kNormalTolerance = 0.98;

/// Collects one facet starting from its largest triangle.
class Flood {
 public:
  Flood(const Mesh& mesh, const Topology& topology, Facets& facets)
      : mesh_(mesh),
        topology_(topology),
        facets_(facets),
        tolerance_(kPlaneTolerance * mesh.bounding_box().size().norm()) {}

  void start(std::size_t seed) {
    const auto id = static_cast<std::int64_t>(facets_.list.size());
    const Corners corners = corners_of(mesh_, seed);
    Facet facet;
    facet.normal = area_vector(corners).normalized();
    facet.origin = corners[0];
    facets_.of_triangle[seed] = id;
    std::vector<std::size_t> waiting = {seed};
    while (!waiting.empty()) {
      const std::size_t triangle = waiting.back();
      waiting.pop_back();
      facet.triangles.push_back(triangle);
      facet.area += area_vector(corners_of(mesh_, triangle)).norm() / 2;
      for (const std::int64_t next : topology_.neighbour[triangle]) {
        if (next == Topology::kNone) continue;
        const auto index = static_cast<std::size_t>(next);
        if (facets_.of_triangle[index] != Topology::kNone || !lies_in(facet, index)) continue;
        facets_.of_triangle[index] = id;
        waiting.push_back(index);
      }
    }
    std::sort(facet.triangles.begin(), facet.triangles.end());
    facets_.list.push_back(std::move(facet));
  }

 private:
  bool lies_in(const Facet& facet, std::size_t triangle) const {
    const Corners corners = corners_of(mesh_, triangle);
    if (area_vector(corners).normalized().dot(facet.normal) < kNormalTolerance) return false;
    return std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector3d& corner) {
      return std::abs(facet.normal.dot(corner - facet.origin)) <= tolerance_;
    });
  }

  const Mesh& mesh_;
  const Topology& topology_;
  Facets& facets_;
  double tolerance_;
};

void add_border(const Mesh& mesh, const Topology& topology, Facets& facets, std::size_t facet_index) {
  Facet& facet = facets.list[facet_index];
  for (const std::size_t triangle : facet.triangles) {
    const Corners corners = corners_of(mesh, triangle);
    for (int k = 0; k < 3; ++k) {
      const auto slot = static_cast<std::size_t>(k);
      const std::int64_t across = topology.neighbour[triangle][slot];
      BorderEdge edge;
      edge.other =
          across == Topology::kNone ? Topology::kNone : facets.of_triangle[static_cast<std::size_t>(across)];
      if (edge.other == static_cast<std::int64_t>(facet_index)) continue;
      edge.from = corners[slot];
      edge.to = corners[(slot + 1) % 3];
      edge.from_vertex = topology.corner(mesh, triangle, k);
      edge.to_vertex = topology.corner(mesh, triangle, (k + 1) % 3);
      if (edge.other != Topology::kNone) {
        const Eigen::Vector3d& beyond = facets.list[static_cast<std::size_t>(edge.other)].normal;
        const Eigen::Vector3d turn = facet.normal.cross(beyond);
        edge.angle = std::atan2(turn.norm(), facet.normal.dot(beyond));
        edge.convex = turn.dot(edge.to - edge.from) > 0;
      }
      facet.border.push_back(edge);
    }
  }
}

}  // namespace

Facets find_facets(const Mesh& mesh, const Topology& topology) {
  Facets facets;
  facets.of_triangle.assign(mesh.triangles.size(), Topology::kNone);
  std::vector<std::size_t> order;
  std::vector<double> area(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    area[t] = area_vector(corners_of(mesh, t)).norm();
    if (!topology.left_out[t]) order.push_back(t);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return area[a] > area[b]; });
  Flood flood(mesh, topology, facets);
  for (const std::size_t triangle : order)
    if (facets.of_triangle[triangle] == Topology::kNone) flood.start(triangle);
  for (std::size_t f = 0; f < facets.list.size(); ++f) add_border(mesh, topology, facets, f);
  return facets;
}

double inset(const BorderEdge& edge, double depth) {
  constexpr double kSharpest = 3.0;  // rad; beyond, the line at depth R is farther away than is of use
  return edge.convex ? depth * std::tan(std::min(edge.angle, kSharpest) / 2) : 0;
}

}  // namespace diefill::geometry
