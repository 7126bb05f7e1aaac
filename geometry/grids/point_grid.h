// Points in a hashed grid of cubes, for queries of near points.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "geometry/grids/cell_index.h"

namespace diefill::geometry {

/// A growing set of points. Answers do not depend on the hash: ties go to the point inserted first.
class PointGrid {
 public:
  /// `cell` is the edge of a cube in m, best about the radius (m) of the queries.
  explicit PointGrid(double cell);

  /// Reserves room for that many points.
  void reserve(std::size_t count);
  /// Adds a point (m) and returns its index.
  std::size_t insert(const Eigen::Vector3d& point);

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  /// The nearest point within `radius` (m) of `place`, or kNone.
  std::size_t nearest_within(const Eigen::Vector3d& place, double radius) const;
  /// Some point within `radius` (m, not negative) of `place`, or kNone: costs less than the nearest one.
  std::size_t some_within(const Eigen::Vector3d& place, double radius) const;
  /// Whether there is one.
  bool any_within(const Eigen::Vector3d& place, double radius) const {
    return some_within(place, radius) != kNone;
  }

  /// Calls `visit(index)` for every point within `radius` of `place`, in an order that depends only on the
  /// insertions.
  template <typename Visit>
  void for_each_within(const Eigen::Vector3d& place, double radius, Visit visit) const {
    const double radius_squared = radius * radius;
    find_cell(place, radius, [&](const Eigen::Vector3i& cell) {
      return find_in_cell(cell, [&](std::size_t index) {
        if ((points_[index] - place).squaredNorm() <= radius_squared) visit(index);
        return false;
      });
    });
  }

  /// Calls `visit(index)` for every point no farther than `half_edge` (m) from `middle` along each axis.
  template <typename Visit>
  void for_each_in_cube(const Eigen::Vector3d& middle, double half_edge, Visit visit) const {
    find_cell(middle, half_edge, [&](const Eigen::Vector3i& cell) {
      return find_in_cell(cell, [&](std::size_t index) {
        if ((points_[index] - middle).cwiseAbs().maxCoeff() <= half_edge) visit(index);
        return false;
      });
    });
  }

  const std::vector<Eigen::Vector3d>& points() const { return points_; }

 private:
  static constexpr std::uint32_t kEnd = 0xffffffffU;

  /// Calls `found(cell)` for the cells within `radius` (m) of `place` until it says true; whether it did.
  template <typename Found>
  bool find_cell(const Eigen::Vector3d& place, double radius, Found found) const {
    const Eigen::Vector3i low = cell_of(place - Eigen::Vector3d::Constant(radius));
    const Eigen::Vector3i high = cell_of(place + Eigen::Vector3d::Constant(radius));
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x)
          if (found(Eigen::Vector3i(x, y, z))) return true;
    return false;
  }
  /// Calls `found(index)` for the points of a cell until it says true; whether it did.
  template <typename Found>
  bool find_in_cell(const Eigen::Vector3i& cell, Found found) const {
    for (std::uint32_t i = heads_[bucket(cell)]; i != kEnd; i = links_[i].next)
      if (links_[i].cell == cell && found(static_cast<std::size_t>(i))) return true;
    return false;
  }

  Eigen::Vector3i cell_of(const Eigen::Vector3d& place) const { return cube_of(place * inverse_cell_); }
  /// Blocks of cells are together in memory, as a question looks into neighbours.
  std::size_t bucket(const Eigen::Vector3i& cell) const {
    constexpr int kBits = 2;  // of a coordinate within a block
    constexpr int kWithin = (1 << kBits) - 1;
    const auto part = [](int coordinate, std::uint64_t factor) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(coordinate >> kBits)) * factor;
    };
    std::uint64_t hash = part(cell.x(), 0x9e3779b97f4a7c15U) ^ part(cell.y(), 0xc2b2ae3d27d4eb4fU) ^
                         part(cell.z(), 0x165667b19e3779f9U);
    hash ^= hash >> 32;
    const int within =
        (((cell.z() & kWithin) << kBits | (cell.y() & kWithin)) << kBits) | (cell.x() & kWithin);
    return (static_cast<std::size_t>(hash) << 3 * kBits | static_cast<std::size_t>(within)) &
           (heads_.size() - 1);
  }
  void resize(std::size_t buckets);

  double inverse_cell_;
  std::vector<Eigen::Vector3d> points_;
  struct Link {
    Eigen::Vector3i cell;
    std::uint32_t next;  ///< point of the same bucket
  };
  std::vector<Link> links_;           ///< of each point
  std::vector<std::uint32_t> heads_;  ///< size a power of two
};

}  // namespace diefill::geometry
