#include "geometry/mesh/mesh_crossings.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cstdint>

#include "geometry/grids/all_cores.h"
#include "geometry/mesh/topology.h"

namespace diefill::geometry {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using TriangleBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

constexpr double kShrink = 1e-5;
constexpr std::size_t kMaxCrossings = 100000;  // piles of the same sheet have millions
constexpr std::size_t kTrianglesOfASlab = 50000, kSampled = 50;

using Crossings = std::vector<std::pair<std::size_t, std::size_t>>;

struct Enough {};

Kernel::Triangle_3 shrunk_triangle(const Corners& corners) {
  const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
  const auto shrunk = [&](const Eigen::Vector3d& corner) {
    const Eigen::Vector3d p = corner + kShrink * (middle - corner);
    return Kernel::Point_3(p.x(), p.y(), p.z());
  };
  return {shrunk(corners[0]), shrunk(corners[1]), shrunk(corners[2])};
}

/// The triangles of a mesh in slabs across its longest side, each small enough to be searched quickly, side
/// by side with others. A triangle is in every slab that it reaches into.
class Slabs {
 public:
  Slabs(const Mesh& mesh, const std::vector<std::uint8_t>& left_out) : mesh_(mesh) {
    mesh.bounding_box().size().maxCoeff(&axis_);
    // One triangle in fifty is enough to place the slabs.
    std::vector<double> begins;
    for (std::size_t t = 0; t < mesh.triangles.size(); t += kSampled)
      if (!left_out[t]) begins.push_back(range(t).first);
    std::sort(begins.begin(), begins.end());
    constexpr std::size_t kStep = kTrianglesOfASlab / kSampled;
    for (std::size_t k = kStep; k < begins.size(); k += kStep) borders_.push_back(begins[k]);
    triangles_.resize(borders_.size() + 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (left_out[t]) continue;
      const auto [low, high] = range(t);
      for (std::size_t slab = slab_of(low); slab <= slab_of(high); ++slab)
        triangles_[slab].push_back(static_cast<std::uint32_t>(t));
    }
  }

  std::size_t size() const { return triangles_.size(); }

  /// Pairs that cross and begin to lie side by side in this slab, so that no other slab has them too.
  Crossings search(std::size_t slab) const {
    std::vector<TriangleBox> boxes;
    boxes.reserve(triangles_[slab].size());
    for (const std::uint32_t t : triangles_[slab]) boxes.emplace_back(triangle(t).bbox(), t);
    Crossings crossings;
    const auto check_pair = [&](const TriangleBox& a, const TriangleBox& b) {
      const int axis = static_cast<int>(axis_);
      if (slab_of(std::max(a.min_coord(axis), b.min_coord(axis))) != slab) return;
      const std::size_t low = std::min(a.info(), b.info()), high = std::max(a.info(), b.info());
      if (CGAL::do_intersect(triangle(low), triangle(high))) crossings.emplace_back(low, high);
      if (crossings.size() == kMaxCrossings) throw Enough();
    };
    try {
      CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), check_pair);
    } catch (const Enough&) {
    }
    return crossings;
  }

 private:
  /// Triangles are made on request: ten million would take most of a gigabyte.
  Kernel::Triangle_3 triangle(std::size_t t) const { return shrunk_triangle(corners_of(mesh_, t)); }
  std::pair<double, double> range(std::size_t t) const {
    const CGAL::Bbox_3 box = triangle(t).bbox();
    return {box.min(static_cast<int>(axis_)), box.max(static_cast<int>(axis_))};
  }
  std::size_t slab_of(double place) const {
    return static_cast<std::size_t>(std::upper_bound(borders_.begin(), borders_.end(), place) -
                                    borders_.begin());
  }

  const Mesh& mesh_;
  Eigen::Index axis_ = 0;
  std::vector<double> borders_;  ///< m, where each slab but the first begins
  std::vector<std::vector<std::uint32_t>> triangles_;
};

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> find_crossings(const Mesh& mesh,
                                                                const std::vector<std::uint8_t>& left_out) {
  const Slabs slabs(mesh, left_out);
  std::vector<Crossings> found(slabs.size());
  on_all_cores(slabs.size(), [&](std::size_t slab) { found[slab] = slabs.search(slab); });
  Crossings crossings;
  for (const Crossings& some : found) {
    const std::size_t room = std::min(some.size(), kMaxCrossings - crossings.size());
    crossings.insert(crossings.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(room));
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace diefill::geometry
