// Points near successive places, such as samples of a surface: the points around the last places are cached,
// so that few queries reach the grid.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/grids/point_grid.h"
#include "geometry/grids/spatial_cache.h"

namespace diefill::geometry {

/// The queries of a PointGrid, with the same answers, for one thread. The grid must outlive it and may
/// grow. Lengths in m.
class NearPoints {
 public:
  /// Answers are fast up to `radius`; beyond, the grid is queried. Points are cached for places in a cube of
  /// `edge`: a large one is filled rarely and holds many.
  NearPoints(const PointGrid& grid, double radius, double edge);

  /// See PointGrid::nearest_within().
  std::size_t nearest_within(const Eigen::Vector3d& place, double radius);
  /// See PointGrid::any_within().
  bool any_within(const Eigen::Vector3d& place, double radius);

  /// Calls `visit(index, distance_squared)` for every point within `radius` of `place`.
  template <typename Visit>
  void for_each_within(const Eigen::Vector3d& place, double radius, Visit visit) {
    if (radius > radius_) {
      grid_.for_each_within(place, radius, [&](std::size_t index) {
        visit(index, (grid_.points()[index] - place).squaredNorm());
      });
      return;
    }
    for (const Kept& kept : round(place).points) {
      const double distance_squared = (kept.point - place).squaredNorm();
      if (distance_squared <= radius * radius) visit(kept.index, distance_squared);
    }
  }

 private:
  struct Kept {
    Eigen::Vector3d point;
    std::size_t index;
  };
  /// All points so near a cube that a question from within may meet them.
  struct Cube {
    Eigen::Vector3i number = Eigen::Vector3i::Zero();
    bool filled = false;
    std::size_t last_found = 0;  ///< place in `points` of the last answer of any_within()
    std::vector<Kept> points;
  };

  Cube& round(const Eigen::Vector3d& place);
  void fill(Cube& cube) const;

  const PointGrid& grid_;
  double radius_, edge_;
  SpatialCache<Cube, 256> cubes_;
  std::size_t seen_ = 0;  ///< points of the grid when cubes were filled
};

}  // namespace diefill::geometry
