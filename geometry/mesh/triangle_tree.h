// The triangle nearest to a point, found in Embree's hierarchy of boxes. Embree works in single precision:
// boxes are rounded outwards and the search reaches a little too far, so that it only proposes triangles;
// which is the nearest is decided here in double precision.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <span>

#include "geometry/mesh/mesh.h"
#include "geometry/mesh/triangle.h"

namespace diefill::geometry {

/// Nearest-triangle search. Building costs O(n log n), a query about O(log n). Queries are thread-safe.
class TriangleTree {
 public:
  /// `corners_of(i)` are the corners (m) of triangle i below `count`; it is called on all cores. Throws
  /// std::runtime_error where Embree cannot build.
  TriangleTree(std::size_t count, const std::function<Corners(std::size_t)>& corners_of);
  ~TriangleTree();
  TriangleTree(const TriangleTree&) = delete;
  TriangleTree& operator=(const TriangleTree&) = delete;

  /// The nearest triangle (index in the order given; where several are equally near, the first of them).
  struct Hit {
    std::size_t triangle = 0;
    TriangleFoot foot;
    double distance_squared = std::numeric_limits<double>::infinity();  ///< m^2
    bool alone = false;  ///< no other triangle is as near, nor would one be 1e-10 of the distance beside
  };
  Hit nearest(const Eigen::Vector3d& point) const;
  /// The same, faster where a triangle lies within `guess` (m) of the point or little farther.
  Hit nearest(const Eigen::Vector3d& point, double guess) const;

  const Corners& corners(std::size_t triangle) const { return triangles_[triangle]; }
  std::span<const Corners> triangles() const { return {triangles_.get(), count_}; }
  const Box& box() const { return box_; }

 private:
  class Scene;

  std::size_t count_;
  std::unique_ptr<Corners[]> triangles_;  ///< memory that each core clears its part of
  Box box_;
  std::unique_ptr<const Scene> scene_;
};

}  // namespace diefill::geometry
