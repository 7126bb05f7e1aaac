#include "geometry/topology.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace diefill::geometry {

namespace {

std::vector<std::int64_t> join_equal_vertices(const std::vector<Eigen::Vector3d>& vertices) {
  std::vector<std::size_t> order(vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) {
    return std::tuple(vertices[i].x(), vertices[i].y(), vertices[i].z(), i);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<std::int64_t> first(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : static_cast<std::int64_t>(order[i]);
  }
  return first;
}

/// Marks degenerate triangles and all but the first of triangles with the same three corners.
void leave_out_useless(const Mesh& mesh, Topology& topology) {
  std::vector<std::pair<std::array<std::int64_t, 3>, std::size_t>> keys(mesh.triangles.size());
  for (std::size_t t = 0; t < keys.size(); ++t) {
    std::array<std::int64_t, 3> key = {topology.corner(mesh, t, 0), topology.corner(mesh, t, 1),
                                       topology.corner(mesh, t, 2)};
    std::sort(key.begin(), key.end());
    keys[t] = {key, t};
    topology.left_out[t] = is_degenerate(corners_of(mesh, t)) ? 1 : 0;
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (keys[i].first == keys[i - 1].first) topology.left_out[keys[i].second] = 1;
}

struct HalfEdge {
  std::int64_t low, high;
  std::size_t triangle;
  int edge;
  bool forward;  ///< runs from low to high
  bool operator<(const HalfEdge& other) const {
    return std::tie(low, high, triangle, edge) < std::tie(other.low, other.high, other.triangle, other.edge);
  }
};

std::vector<HalfEdge> sorted_half_edges(const Mesh& mesh, const Topology& topology) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (topology.left_out[t]) continue;
    for (int k = 0; k < 3; ++k) {
      const std::int64_t from = topology.corner(mesh, t, k);
      const std::int64_t to = topology.corner(mesh, t, (k + 1) % 3);
      edges.push_back({std::min(from, to), std::max(from, to), t, k, from < to});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

int fan_size(const Mesh& mesh, const Topology& topology, std::size_t triangle, int k) {
  const std::int64_t centre = topology.corner(mesh, triangle, k);
  std::size_t current = triangle;
  int count = 0;
  do {
    int at = 0;
    while (topology.corner(mesh, current, at) != centre) ++at;
    const std::int64_t next = topology.neighbour[current][static_cast<std::size_t>(at)];
    if (next == Topology::kNone) return 0;
    current = static_cast<std::size_t>(next);
    ++count;
  } while (current != triangle);
  return count;
}

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
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh, topology);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    if (end - i == 2 && edges[i].forward != edges[i + 1].forward) {
      const HalfEdge& one = edges[i];
      const HalfEdge& other = edges[i + 1];
      topology.neighbour[one.triangle][static_cast<std::size_t>(one.edge)] =
          static_cast<std::int64_t>(other.triangle);
      topology.neighbour[other.triangle][static_cast<std::size_t>(other.edge)] =
          static_cast<std::int64_t>(one.triangle);
    }
    i = end;
  }
  return topology;
}

}  // namespace diefill::geometry
