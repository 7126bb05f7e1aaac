// Spheres sorted into cubic cells, for finding pairs that are near.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/sphere_field.h"

namespace diefill::engine {

/// A grid of cells over spheres' centres, points (m) here. Points of a cell lie together, and cells along x
/// follow each other, so that a neighbourhood of 27 cells is nine runs.
class SphereCells {
 public:
  /// Sorts the centres of all spheres into cells of edge at least `cell` (m).
  void build(const SphereField& spheres, double cell);
  /// The same for some of them only, given by their numbers.
  void build(const SphereField& spheres, std::vector<std::uint32_t> members, double cell);

  /// Calls visit(index, position) for every point in the cells that the cube of half edge `reach` (m) about
  /// `point` meets, in a fixed order.
  template <class Visit>
  void visit_within(Vector3 point, double reach, const Visit& visit) const {
    const Eigen::Array3d from = (eigen(point) - lower_).array() - reach, to = from + 2 * reach;
    // Clamped before they become integers: a point may be far outside the cells of others.
    const Eigen::Array3d last = (cells_.array() - 1).cast<double>();
    const Eigen::Array3i low = (from / edge_).floor().max(0).min(last + 1).cast<int>();
    const Eigen::Array3i high = (to / edge_).floor().max(-1).min(last).cast<int>();
    if ((low > high).any()) return;
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1]; ++y) {
        const std::uint32_t end = first_[index_of(high[0], y, z) + 1];
        for (std::uint32_t k = first_[index_of(low[0], y, z)]; k < end; ++k) visit(index_[k], position_[k]);
      }
  }

 private:
  Eigen::Vector3i cell_of(Vector3 point) const {
    return ((eigen(point) - lower_) / edge_).array().floor().cast<int>();
  }
  std::size_t index_of(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(cells_[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(cells_[0]) +
           static_cast<std::size_t>(x);
  }

  Eigen::Vector3d lower_ = Eigen::Vector3d::Zero();
  Eigen::Vector3i cells_ = Eigen::Vector3i::Ones();
  double edge_ = 1;
  std::vector<std::uint32_t> first_, index_, cell_, members_;
  std::vector<Vector3> position_;
};

}  // namespace diefill::engine
