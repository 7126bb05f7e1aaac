#include "geometry/mesh_crossings.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <mutex>
#include <type_traits>

#include "geometry/topology.h"

namespace diefill::geometry {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using TriangleBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

constexpr double kShrink = 1e-5;
constexpr std::size_t kMostCrossings = 100000;  // piles of the same sheet have millions

struct Enough {};

Kernel::Triangle_3 shrunk_triangle(const Corners& corners) {
  const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
  const auto shrunk = [&](const Eigen::Vector3d& corner) {
    const Eigen::Vector3d p = corner + kShrink * (middle - corner);
    return Kernel::Point_3(p.x(), p.y(), p.z());
  };
  return {shrunk(corners[0]), shrunk(corners[1]), shrunk(corners[2])};
}

using Crossings = std::vector<std::pair<std::size_t, std::size_t>>;

/// Adds crossings in whatever order they are found.
class Collector {
 public:
  explicit Collector(const Mesh& mesh) : mesh_(mesh) {}

  /// Triangles are made when asked for: of ten million, they would take most of a gigabyte.
  Kernel::Triangle_3 triangle(std::size_t t) const { return shrunk_triangle(corners_of(mesh_, t)); }

  void look_at(std::size_t low, std::size_t high) {
    if (!CGAL::do_intersect(triangle(low), triangle(high))) return;
    const std::lock_guard lock(mutex_);
    if (crossings_.size() == kMostCrossings) throw Enough();
    crossings_.emplace_back(low, high);
  }

  Crossings crossings() && { return std::move(crossings_); }

 private:
  const Mesh& mesh_;
  std::mutex mutex_;
  Crossings crossings_;
};

/// All crossings on all cores, or on one the first that are found.
template <typename Concurrency>
Crossings search(const Mesh& mesh, const std::vector<std::uint8_t>& left_out) {
  Collector found(mesh);
  std::vector<TriangleBox> boxes;
  boxes.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!left_out[t]) boxes.emplace_back(found.triangle(t).bbox(), t);
  const auto look = [&](const TriangleBox& a, const TriangleBox& b) {
    found.look_at(std::min(a.info(), b.info()), std::max(a.info(), b.info()));
  };
  try {
    CGAL::box_self_intersection_d<Concurrency>(boxes.begin(), boxes.end(), look);
  } catch (const Enough&) {
    // Which ones are the first depends on the threads.
    if (std::is_same_v<Concurrency, CGAL::Parallel_tag>) return search<CGAL::Sequential_tag>(mesh, left_out);
  }
  return std::move(found).crossings();
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> find_crossings(const Mesh& mesh,
                                                                const std::vector<std::uint8_t>& left_out) {
  Crossings crossings = search<CGAL::Parallel_tag>(mesh, left_out);
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace diefill::geometry
