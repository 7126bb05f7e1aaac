// Separates solids that touch along edges.
#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>

#include "geometry/mesh/half_edges.h"
#include "geometry/mesh/mesh_stitch.h"
#include "geometry/mesh/topology.h"

namespace diefill::geometry {

namespace {

constexpr double kSamePlane = 1e-5;    // rad, between faces that lie on each other
constexpr std::size_t kMaxSides = 64;  // of one edge

/// One triangle at an edge: the angle about the edge at which it leaves it, rad.
struct Leaf {
  std::size_t triangle = 0;
  bool forward = false;
  double angle = 0;
};

/// Which triangles stay together.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::size_t> parent_;
};

std::vector<Leaf> leaves_of(const Mesh& mesh, const Topology& topology, std::size_t low,
                            std::span<const HalfEdge> sides) {
  const Eigen::Vector3d foot = mesh.vertices[low];
  const Eigen::Vector3d along =
      (mesh.vertices[static_cast<std::size_t>(sides.front().high())] - foot).normalized();
  const Eigen::Vector3d first = along.unitOrthogonal(), second = along.cross(first);
  std::vector<Leaf> leaves;
  for (const HalfEdge& side : sides) {
    const auto apex = static_cast<std::size_t>(topology.corner(mesh, side.triangle(), (side.side() + 2) % 3));
    const Eigen::Vector3d way = mesh.vertices[apex] - foot;
    leaves.push_back({side.triangle(), side.forward(), std::atan2(way.dot(second), way.dot(first))});
  }
  return leaves;
}

/// Solid lies below the angle of a triangle that runs forward along the edge, up to the next that runs
/// backward. False where that is not one each.
bool join_round_edge(const std::vector<Leaf>& leaves, Groups& groups) {
  std::vector<std::uint8_t> taken(leaves.size(), 0);
  std::size_t pairs = 0;
  for (const Leaf& one : leaves) {
    if (!one.forward) continue;
    std::optional<std::size_t> partner;
    double smallest = 10;
    for (std::size_t k = 0; k < leaves.size(); ++k) {
      if (leaves[k].forward || taken[k]) continue;
      double wedge = std::fmod(one.angle - leaves[k].angle + 4 * std::numbers::pi, 2 * std::numbers::pi);
      if (wedge < kSamePlane) wedge += 2 * std::numbers::pi;
      if (wedge >= smallest) continue;
      smallest = wedge;
      partner = k;
    }
    if (!partner) return false;
    taken[*partner] = 1;
    groups.join(one.triangle, leaves[*partner].triangle);
    ++pairs;
  }
  return 2 * pairs == leaves.size();
}

}  // namespace

std::vector<Mesh> shells_of_solids(const Mesh& mesh) {
  const Topology topology = find_topology(mesh);
  std::vector<std::uint8_t> flat(mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < flat.size(); ++t) flat[t] = is_degenerate(corners_of(mesh, t)) ? 1 : 0;
  Groups groups(mesh.triangles.size());
  bool apart = true;
  const HalfEdges edges(mesh, topology, [&](std::size_t t) { return !flat[t]; });
  edges.visit_edges([&](std::size_t low, std::span<const HalfEdge> sides) {
    apart =
        apart && sides.size() <= kMaxSides && join_round_edge(leaves_of(mesh, topology, low, sides), groups);
  });
  if (!apart) return {};
  std::map<std::size_t, Mesh> shells;
  std::map<std::pair<std::size_t, std::size_t>, int> number;
  for (std::size_t t = 0; t < flat.size(); ++t) {
    if (flat[t]) continue;
    const std::size_t group = groups.root(t);
    Mesh& shell = shells[group];
    Eigen::Vector3i triangle;
    for (int k = 0; k < 3; ++k) {
      const auto vertex = static_cast<std::size_t>(topology.corner(mesh, t, k));
      const auto [place, is_new] =
          number.try_emplace({group, vertex}, static_cast<int>(shell.vertices.size()));
      if (is_new) shell.vertices.push_back(mesh.vertices[vertex]);
      triangle[k] = place->second;
    }
    shell.triangles.push_back(triangle);
  }
  std::vector<Mesh> list;
  for (auto& [group, shell] : shells) list.push_back(std::move(shell));
  return list;
}

}  // namespace diefill::geometry
