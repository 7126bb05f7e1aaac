// A fixed set of points in the cells of a regular grid, for fast neighbour queries. Visits in a fixed order
// that depends on the points alone, so sums over neighbours are the same in every run.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

/// Points and, for each, the index of the point it is (an image of).
struct PointImages {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::uint32_t> source;
};

/// The points wrapped into the periodic box (centred on the origin, periodic along any of its axes) followed
/// by all their periodic images within `margin` (m) of that box. Throws std::invalid_argument for a period
/// that is not positive.
PointImages with_periodic_images(const std::vector<Eigen::Vector3d>& points,
                                 const std::array<std::optional<double>, 3>& period, double margin);

/// Finds points within a distance of a place. Queries may come from several threads at once.
class NeighbourGrid {
 public:
  /// `spacing` (m): edge of a grid cell, best about the query distance; made larger where cells would far
  /// outnumber points.
  NeighbourGrid(const std::vector<Eigen::Vector3d>& points, double spacing);

  /// Calls `visit(index, offset, squared_distance)` for every point within `radius` (m) of `centre`; `offset`
  /// runs from `centre` to the point.
  template <class Visit>
  void for_each_within(const Eigen::Vector3d& centre, double radius, Visit&& visit) const {
    if (points_.empty()) return;
    const Eigen::Array3i first = cell_of(centre.array() - radius), last = cell_of(centre.array() + radius);
    for (int k = first.z(); k <= last.z(); ++k) {
      for (int j = first.y(); j <= last.y(); ++j) {
        const std::size_t row = (static_cast<std::size_t>(k) * cells_.y() + j) * cells_.x();
        for (std::uint32_t n = start_[row + first.x()]; n < start_[row + last.x() + 1]; ++n) {
          const Eigen::Vector3d offset = points_[n] - centre;
          const double squared = offset.squaredNorm();
          if (squared <= radius * radius) visit(index_[n], offset, squared);
        }
      }
    }
  }

 private:
  Eigen::Array3i cell_of(const Eigen::Array3d& place) const {
    return ((place - lower_) / edge_).floor().max(0.0).min(cells_.cast<double>() - 1.0).cast<int>();
  }

  Eigen::Array3d lower_ = Eigen::Array3d::Zero();
  Eigen::Array3d edge_ = Eigen::Array3d::Ones();
  Eigen::Array3i cells_ = Eigen::Array3i::Ones();
  std::vector<std::uint32_t> start_;     ///< first entry of each cell, and one past the last
  std::vector<std::uint32_t> index_;     ///< index of the point, cell after cell
  std::vector<Eigen::Vector3d> points_;  ///< in the same order
};

}  // namespace diefill::geometry
