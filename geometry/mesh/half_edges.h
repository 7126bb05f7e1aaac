// The sides of all triangles of a mesh by edge: the basis of every query about neighbours, holes and
// shells. Made for ten million triangles: no global sort, eight bytes per side.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/mesh/topology.h"

namespace diefill::geometry {

/// One side of a triangle: from corner `side()` to the next.
class HalfEdge {
 public:
  HalfEdge() = default;
  HalfEdge(std::uint32_t high, std::size_t triangle, int side, bool forward)
      : high_(high),
        packed_(static_cast<std::uint32_t>(2 * (3 * triangle + static_cast<std::size_t>(side)) + forward)) {}

  std::int64_t high() const { return high_; }
  std::size_t triangle() const { return packed_ / 6; }
  int side() const { return static_cast<int>(packed_ / 2 % 3); }
  /// Runs from the vertex of lower number to the other.
  bool forward() const { return packed_ & 1U; }
  bool operator<(const HalfEdge& other) const {
    return high_ != other.high_ ? high_ < other.high_ : packed_ < other.packed_;
  }

 private:
  std::uint32_t high_ = 0, packed_ = 0;
};

/// Half edges by their edge.
class HalfEdges {
 public:
  /// Of the triangles for which `takes_part(triangle)` is true; several threads call it at once. Throws
  /// MeshError beyond 700 million triangles.
  HalfEdges(const Mesh& mesh, const Topology& topology, const std::function<bool(std::size_t)>& takes_part);

  /// Calls visit(low, sides) for every edge, in rising order of its two vertices (Topology::vertex): the
  /// lower one, and the half edges on it in rising order of triangle and side.
  template <class Visit>
  void visit_edges(const Visit& visit) const {
    visit_edges_from(0, first_.size() - 1, visit);
  }
  /// The same for edges whose lower vertex is one from `low` to below `end_of_low`.
  template <class Visit>
  void visit_edges_from(std::size_t low, std::size_t end_of_low, const Visit& visit) const {
    for (; low < end_of_low; ++low)
      for (std::uint32_t begin = first_[low]; begin < first_[low + 1];) {
        std::uint32_t end = begin + 1;
        while (end < first_[low + 1] && edges_[end].high() == edges_[begin].high()) ++end;
        visit(low, std::span(edges_).subspan(begin, end - begin));
        begin = end;
      }
  }

 private:
  std::vector<std::uint32_t> first_;  ///< first half edge of a lower vertex
  std::vector<HalfEdge> edges_;
};

}  // namespace diefill::geometry
