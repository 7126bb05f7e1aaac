#include "geometry/mesh/half_edges.h"

#include <algorithm>
#include <numeric>

#include "geometry/grids/all_cores.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kMaxTriangles = 700000000;  // sides are numbered with 32 bits

}  // namespace

HalfEdges::HalfEdges(const Mesh& mesh, const Topology& topology,
                     const std::function<bool(std::size_t)>& takes_part) {
  const std::size_t triangles = mesh.triangles.size();
  if (triangles > kMaxTriangles)
    throw MeshError("the mesh has " + std::to_string(triangles) + " triangles, allowed: up to " +
                    std::to_string(kMaxTriangles) + ": export it with a coarser tolerance");
  const auto ends = [&](std::size_t t, int k) {
    const std::int64_t from = topology.corner(mesh, t, k), to = topology.corner(mesh, t, (k + 1) % 3);
    return std::pair(from, to);
  };
  std::vector<std::uint8_t> taken(triangles);
  first_.assign(mesh.vertices.size() + 1, 0);
  in_parts_on_all_cores(triangles, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) taken[t] = takes_part(t);
  });
  for (std::size_t t = 0; t < triangles; ++t) {
    for (int k = 0; taken[t] && k < 3; ++k) {
      const auto [from, to] = ends(t, k);
      ++first_[static_cast<std::size_t>(std::min(from, to)) + 1];
    }
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  edges_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t t = 0; t < triangles; ++t)
    for (int k = 0; taken[t] && k < 3; ++k) {
      const auto [from, to] = ends(t, k);
      edges_[next[static_cast<std::size_t>(std::min(from, to))]++] =
          HalfEdge(static_cast<std::uint32_t>(std::max(from, to)), t, k, from < to);
    }
  in_parts_on_all_cores(mesh.vertices.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t low = begin; low < end; ++low)
      std::sort(edges_.begin() + first_[low], edges_.begin() + first_[low + 1]);
  });
}

}  // namespace diefill::geometry
