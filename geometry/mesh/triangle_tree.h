// A tree of bounding boxes that finds the triangle nearest to a point.
// CGAL's AABB_tree answers the same question but does not visit the nearer child first, which costs 5 to 60
// times the time for the long thin facets of tessellated cylinders.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/mesh/triangle.h"

namespace diefill::geometry {

/// Nearest-triangle search. Building costs O(n log n), a question about O(log n). Const questions are
/// thread-safe.
class TriangleTree {
 public:
  /// `corners_of(i)` are the corners (m) of triangle i below `count`; it is asked on all cores.
  TriangleTree(std::size_t count, const std::function<Corners(std::size_t)>& corners_of);

  /// The nearest triangle (index in the order given; where several are equally near, always the same one).
  struct Hit {
    std::size_t triangle = 0;
    TriangleFoot foot;
    double distance_squared = std::numeric_limits<double>::infinity();  ///< m^2
    bool alone = false;  ///< no other triangle is as near, nor would one be 1e-10 of the distance beside
  };
  Hit nearest(const Eigen::Vector3d& point) const;
  /// The same, faster where a triangle lies within `guess` (m) of the point or little farther.
  Hit nearest(const Eigen::Vector3d& point, double guess) const;
  /// The part of the tree that holds all triangles near a place: questions about places near each other
  /// mostly start there instead of at the root. One per thread.
  struct Region {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< m
    double radius = 0;                   ///< m, no triangle outside the part is nearer than this
    std::uint32_t first = 0, count = 0;  ///< as in Siblings
  };
  /// The same, fastest where `region` is that of a question about a near place; updates it otherwise.
  Hit nearest(const Eigen::Vector3d& point, double guess, Region& region) const;

  const Corners& corners(std::size_t triangle) const { return triangles_[triangle]; }
  std::span<const Corners> triangles() const { return {triangles_.get(), order_.size()}; }
  const Box& box() const { return box_; }

 private:
  /// Two nodes, with boxes in single precision that are rounded outwards: they fill one cache line, which
  /// takes most of a question's time, and are tested together.
  struct alignas(64) Siblings {
    using Two = Eigen::Array2f;
    std::array<Two, 3> lower, upper;  ///< by axis
    std::array<std::uint32_t, 2> first =
        {};  ///< leaf: first place in order_; otherwise: number of the children
    std::array<std::uint32_t, 2> count = {};  ///< triangles in a leaf, 0 for an inner node

    Siblings() {
      lower.fill(Two::Zero());
      upper.fill(Two::Zero());
    }
    void enclose(int side, const Box& box);
    /// m^2, to a point; 0 inside; never more than to what the nodes hold.
    Eigen::Array2d distances_squared(const Eigen::Vector3d& point) const;
  };
  class Builder;

  Region everywhere() const;
  /// The smallest that holds all triangles within `radius` (m).
  Region region_round(const Eigen::Vector3d& middle, double radius) const;
  /// The nearest triangle of a region if its distance squared is below `bound` (m^2); otherwise one at that
  /// distance.
  Hit nearer_than(double bound, const Eigen::Vector3d& point, const Region& region) const;

  std::unique_ptr<Corners[]> triangles_;  ///< memory that each core clears its part of
  std::vector<std::uint32_t> order_;
  std::vector<Siblings> nodes_;  ///< the root is one without a sibling
  Box box_;
};

}  // namespace diefill::geometry
