#include "geometry/mesh/mesh_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>

#include "geometry/grids/all_cores.h"
#include "geometry/mesh/half_edges.h"
#include "geometry/mesh/mesh_crossings.h"
#include "geometry/mesh/winding.h"

namespace diefill::geometry {

namespace {

/// How far, in square roots of a triangle's area, both sides of it are probed for inside and outside.
constexpr double kProbeDepth = 1e-4;
constexpr std::size_t kOfAPart = 16384;  // triangles whose solid angles one core sums
constexpr std::size_t kMaxMarks = 100;   // of one kind; more would cover the part on a picture

/// Connected pieces of surface.
class Pieces {
 public:
  explicit Pieces(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    const std::size_t root_a = root(a);
    const std::size_t root_b = root(b);
    parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
  }

 private:
  std::vector<std::size_t> parent_;
};

/// The check of one mesh, one kind of finding after another.
class Examination {
 public:
  explicit Examination(const Mesh& mesh) : mesh_(mesh) { findings_.triangles = mesh.triangles.size(); }
  ExaminedMesh run();

 private:
  /// Counts one finding and keeps the places of the first of its kind.
  void count(std::size_t& counter, const Eigen::Vector3d& place) {
    if (counter++ < kMaxMarks) places_[&counter].push_back(place);
  }
  Eigen::Vector3d middle(std::size_t triangle) const {
    const Corners c = corners_of(mesh_, triangle);
    return (c[0] + c[1] + c[2]) / 3;
  }
  bool every_corner_is_a_place();
  void find_degenerate_and_duplicate();
  void examine_edges();
  void examine_edge(std::size_t low, std::span<const HalfEdge> sides);
  void count_crossings(const std::vector<std::pair<std::size_t, std::size_t>>& crossings);
  double winding_about(const Eigen::Vector3d& point) const;
  void find_inward_shells();
  void list_places();

  const Mesh& mesh_;
  MeshFindings findings_;
  std::map<const std::size_t*, std::vector<Eigen::Vector3d>> places_;  ///< by counter; only ever looked up
  Topology topology_;
  std::vector<std::uint8_t> duplicate_;
  std::vector<std::size_t> piece_;  ///< of a triangle: the first triangle of its shell
};

bool Examination::every_corner_is_a_place() {
  const auto count_of_vertices = static_cast<int>(mesh_.vertices.size());
  for (const Eigen::Vector3i& triangle : mesh_.triangles) {
    const bool exist = triangle.minCoeff() >= 0 && triangle.maxCoeff() < count_of_vertices;
    const bool finite = exist && mesh_.vertices[static_cast<std::size_t>(triangle[0])].allFinite() &&
                        mesh_.vertices[static_cast<std::size_t>(triangle[1])].allFinite() &&
                        mesh_.vertices[static_cast<std::size_t>(triangle[2])].allFinite();
    if (!finite) count(findings_.not_finite, Eigen::Vector3d::Zero());
  }
  return findings_.not_finite == 0;
}

void Examination::find_degenerate_and_duplicate() {
  duplicate_.assign(mesh_.triangles.size(), 0);
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (is_degenerate(corners_of(mesh_, t)))
      count(findings_.degenerate_triangles, middle(t));
    else if (topology_.left_out[t]) {
      duplicate_[t] = 1;
      count(findings_.duplicate_triangles, middle(t));
    }
  }
}

/// Triangles without area but with three different corners close the surface between split and unsplit edges,
/// so they take part here.
void Examination::examine_edges() {
  Pieces pieces(mesh_.triangles.size());
  const HalfEdges edges(mesh_, topology_, [&](std::size_t t) {
    const std::int64_t corner[3] = {topology_.corner(mesh_, t, 0), topology_.corner(mesh_, t, 1),
                                    topology_.corner(mesh_, t, 2)};
    return !duplicate_[t] && corner[0] != corner[1] && corner[1] != corner[2] && corner[2] != corner[0];
  });
  edges.visit_edges([&](std::size_t low, std::span<const HalfEdge> sides) {
    for (const HalfEdge& side : sides.subspan(1)) pieces.join(sides.front().triangle(), side.triangle());
    examine_edge(low, sides);
  });
  findings_.consistently_oriented = findings_.badly_oriented_edges == 0 && findings_.non_manifold_edges == 0;
  piece_.resize(mesh_.triangles.size());
  for (std::size_t t = 0; t < piece_.size(); ++t) piece_[t] = pieces.root(t);
}

void Examination::examine_edge(std::size_t low, std::span<const HalfEdge> sides) {
  const Eigen::Vector3d place =
      (mesh_.vertices[low] + mesh_.vertices[static_cast<std::size_t>(sides.front().high())]) / 2;
  if (sides.size() == 1) count(findings_.open_edges, place);
  if (sides.size() > 2) count(findings_.non_manifold_edges, place);
  if (sides.size() == 2 && sides[0].forward() == sides[1].forward())
    count(findings_.badly_oriented_edges, place);
}

void Examination::count_crossings(const std::vector<std::pair<std::size_t, std::size_t>>& crossings) {
  const auto box_of = [&](std::size_t triangle) {
    Box box;
    for (const Eigen::Vector3d& corner : corners_of(mesh_, triangle)) box.include(corner);
    return box;
  };
  for (const auto& [one, other] : crossings) {
    const Box a = box_of(one);
    const Box b = box_of(other);
    count(findings_.self_intersections, (a.lower.cwiseMax(b.lower) + a.upper.cwiseMin(b.upper)) / 2);
  }
}

/// Winding number of the useful triangles, summed part by part: the same on any number of cores.
double Examination::winding_about(const Eigen::Vector3d& point) const {
  std::vector<double> angles(mesh_.triangles.size() / kOfAPart + 1, 0);
  on_all_cores(angles.size(), [&](std::size_t part) {
    const std::size_t end = std::min(mesh_.triangles.size(), (part + 1) * kOfAPart);
    for (std::size_t t = part * kOfAPart; t < end; ++t)
      if (!topology_.left_out[t]) angles[part] += solid_angle(corners_of(mesh_, t), point);
  });
  return std::accumulate(angles.begin(), angles.end(), 0.0) / (4 * std::numbers::pi);
}

/// A shell faces outward when there is no solid before its largest triangle and solid behind it: this also
/// holds for the walls of closed cavities inside a solid. Open or contradictory surfaces enclose nothing, so
/// nothing is reported.
void Examination::find_inward_shells() {
  std::map<std::size_t, std::size_t> largest;  // of a shell: its largest triangle
  const auto area = [&](std::size_t t) { return area_vector(corners_of(mesh_, t)).norm(); };
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (topology_.left_out[t]) continue;
    const auto [shell, is_new] = largest.try_emplace(piece_[t], t);
    if (!is_new && area(t) > area(shell->second)) shell->second = t;
  }
  findings_.shells = largest.size();
  if (findings_.open_edges > 0 || !findings_.consistently_oriented) return;
  for (const auto& [shell, triangle] : largest) {
    const Eigen::Vector3d normal = area_vector(corners_of(mesh_, triangle)).normalized();
    const Eigen::Vector3d step = kProbeDepth * std::sqrt(area(triangle)) * normal;
    const double before = winding_about(middle(triangle) + step);
    const double behind = winding_about(middle(triangle) - step);
    if (std::abs(before) > 0.5 || behind < 0.5) count(findings_.inward_shells, middle(triangle));
  }
  findings_.outward = !largest.empty() && findings_.inward_shells == 0;
}

void Examination::list_places() {
  const std::pair<const std::size_t*, const char*> kinds[] = {
      {&findings_.not_finite, "invalid corner"},
      {&findings_.open_edges, "open edge"},
      {&findings_.non_manifold_edges, "edge of more than two triangles"},
      {&findings_.self_intersections, "crossing"},
      {&findings_.badly_oriented_edges, "turned over"},
      {&findings_.inward_shells, "inside out"},
      {&findings_.degenerate_triangles, "without area"},
      {&findings_.duplicate_triangles, "twice"}};
  for (const auto& [counter, kind] : kinds) {
    if (*counter == 0) continue;
    const auto& places = places_.at(counter);
    findings_.places.push_back(places.front());
    for (const auto& place : places) findings_.marks.push_back({kind, place});
  }
}

ExaminedMesh Examination::run() {
  const bool joined = every_corner_is_a_place();
  if (joined) {
    topology_ = find_topology(mesh_);
    std::vector<std::pair<std::size_t, std::size_t>> crossings;
    side_by_side([&] { crossings = find_crossings(mesh_, topology_.left_out); },
                 [&] {
                   find_degenerate_and_duplicate();
                   examine_edges();
                   find_inward_shells();
                 });
    count_crossings(crossings);
    findings_.volume = mesh_.volume();
  }
  list_places();
  if (findings_.triangles == 0) findings_.places.push_back(Eigen::Vector3d::Zero());
  return {findings_, joined ? std::optional(std::move(topology_)) : std::nullopt};
}

}  // namespace

MeshFindings check_mesh(const Mesh& mesh) {
  return examine_mesh(mesh).findings;
}

ExaminedMesh examine_mesh(const Mesh& mesh) {
  return Examination(mesh).run();
}

}  // namespace diefill::geometry
