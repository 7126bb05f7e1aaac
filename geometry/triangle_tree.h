// A tree of boxes round triangles that finds the triangle nearest to a point.
// CGAL's AABB_tree answers the same question; it does not look into the nearer child first, which costs 5 to
// 60 times the time for the long thin facets of tessellated cylinders.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/triangle.h"

namespace diefill::geometry {

/// Nearest-triangle search. Building costs O(n log n), a question about O(log n). Const questions are
/// thread-safe.
class TriangleTree {
 public:
  explicit TriangleTree(std::vector<Corners> triangles);

  /// The nearest triangle (index in the order given; where several are equally near, always the same one).
  struct Hit {
    std::size_t triangle = 0;
    TriangleFoot foot;
    double distance_squared = std::numeric_limits<double>::infinity();  ///< m^2
  };
  Hit nearest(const Eigen::Vector3d& point) const;
  /// The same, sooner where a triangle lies within `guess` (m) of the point or hardly farther.
  Hit nearest(const Eigen::Vector3d& point, double guess) const;

  const Corners& corners(std::size_t triangle) const { return triangles_[triangle]; }
  const std::vector<Corners>& triangles() const { return triangles_; }
  const Box& box() const { return box_; }

 private:
  /// Box in single precision, rounded outwards: two children fill one line of the cache, which most of a
  /// question's time goes into.
  struct Node {
    Eigen::Vector3f lower = Eigen::Vector3f::Zero(), upper = Eigen::Vector3f::Zero();
    std::uint32_t first =
        0;  ///< leaf: first place in order_; otherwise: the left child, the right one follows it
    std::uint32_t count = 0;  ///< triangles in a leaf, 0 for an inner node

    void enclose(const Box& box);
    /// m^2, to a point; 0 inside; never more than to what the node holds.
    double distance_squared(const Eigen::Vector3d& point) const {
      const Eigen::Vector3d below = lower.cast<double>() - point, above = point - upper.cast<double>();
      return below.cwiseMax(above).cwiseMax(0.0).squaredNorm();
    }
  };
  class Builder;

  /// The nearest triangle if its distance squared is below `bound` (m^2); otherwise one at that distance.
  Hit nearer_than(double bound, const Eigen::Vector3d& point) const;

  std::vector<Corners> triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
  Box box_;
};

}  // namespace diefill::geometry
