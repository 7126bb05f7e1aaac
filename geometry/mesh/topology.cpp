#include "geometry/mesh/topology.h"

#include <algorithm>
#include <numeric>

#include "geometry/grids/all_cores.h"
#include "geometry/mesh/equal_vertices.h"
#include "geometry/mesh/half_edges.h"

namespace diefill::geometry {

namespace {

/// For each vertex the first one at the same place.
std::vector<std::int64_t> join_equal_vertices(const std::vector<Eigen::Vector3d>& vertices) {
  EqualVertices places;
  places.reserve(vertices.size());
  std::vector<std::int64_t> first(vertices.size()), first_of_place;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::uint32_t place = places.add(vertices[i]);
    if (place == first_of_place.size()) first_of_place.push_back(static_cast<std::int64_t>(i));
    first[i] = first_of_place[place];
  }
  return first;
}

std::array<std::int64_t, 3> sorted_corners(const Mesh& mesh, const Topology& topology, std::size_t t) {
  std::array<std::int64_t, 3> corners = {topology.corner(mesh, t, 0), topology.corner(mesh, t, 1),
                                         topology.corner(mesh, t, 2)};
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Marks degenerate triangles and all but the first of triangles with the same three corners.
void leave_out_useless(const Mesh& mesh, Topology& topology) {
  const std::size_t triangles = mesh.triangles.size();
  // By their lowest corner, so that copies lie together and little has to be sorted.
  std::vector<std::uint32_t> first(mesh.vertices.size() + 1, 0), order(triangles);
  std::vector<std::uint32_t> lowest(triangles);
  in_parts_on_all_cores(triangles, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      lowest[t] = static_cast<std::uint32_t>(sorted_corners(mesh, topology, t)[0]);
      topology.left_out[t] = is_degenerate(corners_of(mesh, t)) ? 1 : 0;
    }
  });
  for (const std::uint32_t low : lowest) ++first[low + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t t = 0; t < triangles; ++t) order[next[lowest[t]]++] = static_cast<std::uint32_t>(t);
  in_parts_on_all_cores(mesh.vertices.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<std::pair<std::array<std::int64_t, 3>, std::uint32_t>> keys;
    for (std::size_t low = begin; low < end; ++low) {
      keys.clear();
      for (std::uint32_t k = first[low]; k < first[low + 1]; ++k)
        keys.emplace_back(sorted_corners(mesh, topology, order[k]), order[k]);
      std::sort(keys.begin(), keys.end());
      for (std::size_t i = 1; i < keys.size(); ++i)
        if (keys[i].first == keys[i - 1].first) topology.left_out[keys[i].second] = 1;
    }
  });
}

}  // namespace

Corners corners_of(const Mesh& mesh, std::size_t triangle) {
  const Eigen::Vector3i& t = mesh.triangles[triangle];
  return {mesh.vertices[static_cast<std::size_t>(t[0])], mesh.vertices[static_cast<std::size_t>(t[1])],
          mesh.vertices[static_cast<std::size_t>(t[2])]};
}

Topology find_topology(const Mesh& mesh) {
  Topology topology;
  topology.vertex = join_equal_vertices(mesh.vertices);
  topology.neighbour.assign(mesh.triangles.size(), {Topology::kNone, Topology::kNone, Topology::kNone});
  topology.left_out.assign(mesh.triangles.size(), 0);
  leave_out_useless(mesh, topology);
  const HalfEdges edges(mesh, topology, [&](std::size_t t) { return !topology.left_out[t]; });
  const auto join = [&](std::size_t, std::span<const HalfEdge> sides) {
    if (sides.size() != 2 || sides[0].forward() == sides[1].forward()) return;
    const auto neighbour = [&](const HalfEdge& side) -> std::int64_t& {
      return topology.neighbour[side.triangle()][static_cast<std::size_t>(side.side())];
    };
    neighbour(sides[0]) = static_cast<std::int64_t>(sides[1].triangle());
    neighbour(sides[1]) = static_cast<std::int64_t>(sides[0].triangle());
  };
  in_parts_on_all_cores(mesh.vertices.size(), [&](std::size_t begin, std::size_t end) {
    edges.visit_edges_from(begin, end, join);
  });
  return topology;
}

}  // namespace diefill::geometry
