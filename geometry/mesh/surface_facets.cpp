#include "geometry/mesh/surface_facets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/grids/all_cores.h"

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
  Flood(const Mesh& mesh, const Topology& topology)
      : mesh_(mesh),
        topology_(topology),
        of_triangle_(mesh.triangles.size(), kNoFacet),
        tolerance_(kPlaneTolerance * mesh.bounding_box().size().norm()) {}

  /// Does nothing where the seed is in a facet already.
  void start(std::size_t seed) {
    if (of_triangle_[seed] != kNoFacet) return;
    const auto id = static_cast<std::int32_t>(facets_.size());
    const Corners corners = corners_of(mesh_, seed);
    Facet facet;
    facet.normal = area_vector(corners).normalized();
    facet.offset = facet.normal.dot(corners[0]);
    of_triangle_[seed] = id;
    waiting_.assign(1, static_cast<std::uint32_t>(seed));
    while (!waiting_.empty()) {
      const std::uint32_t triangle = waiting_.back();
      waiting_.pop_back();
      facet.triangles.push_back(triangle);
      facet.area += area_vector(corners_of(mesh_, triangle)).norm() / 2;
      for (const std::int64_t next : topology_.neighbour[triangle]) {
        if (next == Topology::kNone) continue;
        const auto index = static_cast<std::size_t>(next);
        if (of_triangle_[index] != kNoFacet || !lies_in(facet.normal, corners[0], index)) continue;
        of_triangle_[index] = id;
        waiting_.push_back(static_cast<std::uint32_t>(index));
      }
    }
    std::sort(facet.triangles.begin(), facet.triangles.end());
    facets_.push_back(std::move(facet));
  }

  Facets take_facets() { return std::move(facets_); }
  const std::vector<std::int32_t>& of_triangle() const { return of_triangle_; }

 private:
  bool lies_in(const Eigen::Vector3d& normal, const Eigen::Vector3d& origin, std::size_t triangle) const {
    const Corners corners = corners_of(mesh_, triangle);
    if (area_vector(corners).normalized().dot(normal) < kNormalTolerance) return false;
    return std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector3d& corner) {
      return std::abs(normal.dot(corner - origin)) <= tolerance_;
    });
  }

  const Mesh& mesh_;
  const Topology& topology_;
  Facets facets_;
  std::vector<std::int32_t> of_triangle_;
  std::vector<std::uint32_t> waiting_;
  double tolerance_;
};

/// The border of one facet: the sides of its triangles beyond which another begins.
std::vector<BorderEdge> border_of(std::size_t facet_index, const Facets& facets, const Mesh& mesh,
                                  const Topology& topology, const std::vector<std::int32_t>& of_triangle) {
  const Facet& facet = facets[facet_index];
  const auto corner = [&](std::size_t triangle, int k) {
    return &mesh.vertices[static_cast<std::size_t>(topology.corner(mesh, triangle, k))];
  };
  std::vector<BorderEdge> border;
  for (const std::size_t triangle : facet.triangles)
    for (int k = 0; k < 3; ++k) {
      const std::int64_t across = topology.neighbour[triangle][static_cast<std::size_t>(k)];
      BorderEdge edge;
      edge.other = across == Topology::kNone ? kNoFacet : of_triangle[static_cast<std::size_t>(across)];
      if (edge.other == static_cast<std::int32_t>(facet_index)) continue;
      edge.from_corner = corner(triangle, k);
      edge.to_corner = corner(triangle, (k + 1) % 3);
      if (edge.other != kNoFacet) {
        const Eigen::Vector3d& beyond = facets[static_cast<std::size_t>(edge.other)].normal;
        const Eigen::Vector3d turn = facet.normal.cross(beyond);
        edge.angle = std::atan2(turn.norm(), facet.normal.dot(beyond));
        edge.convex = turn.dot(edge.to() - edge.from()) > 0;
      }
      border.push_back(edge);
    }
  return border;
}

/// The useful triangles, largest first. Those about as large, within a factor of two, stay in the order of
/// the mesh, in which neighbours mostly follow each other: a tour of millions of facets is then one through
/// memory too.
std::vector<std::uint32_t> by_area(const Mesh& mesh, const Topology& topology) {
  std::vector<int> magnitude(mesh.triangles.size());
  std::vector<std::uint32_t> order;
  for (std::size_t t = 0; t < magnitude.size(); ++t) {
    if (topology.left_out[t]) continue;
    magnitude[t] = std::ilogb(area_vector(corners_of(mesh, t)).norm());
    order.push_back(static_cast<std::uint32_t>(t));
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return magnitude[a] > magnitude[b]; });
  return order;
}

}  // namespace

Facets find_facets(const Mesh& mesh, const Topology& topology) {
  Flood flood(mesh, topology);
  for (const std::uint32_t triangle : by_area(mesh, topology)) flood.start(triangle);
  const std::vector<std::int32_t>& of_triangle = flood.of_triangle();
  Facets facets = flood.take_facets();
  on_all_cores(facets.size(),
               [&](std::size_t f) { facets[f].border = border_of(f, facets, mesh, topology, of_triangle); });
  return facets;
}

double inset(const BorderEdge& edge, double depth) {
  constexpr double kSharpest = 3.0;  // rad; beyond, the line at depth R is farther away than is of use
  return edge.convex ? depth * std::tan(std::min(edge.angle, kSharpest) / 2) : 0;
}

}  // namespace diefill::geometry
