// Vertices told apart by their place alone: triangle soups name every corner anew.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace diefill::geometry {

/// A growing set of places, each there once. Equal is what compares equal, so that both zeros are one; what
/// is not a number is equal to the same bits, of which damaged files may hold millions.
class EqualVertices {
 public:
  /// Number of the place, which is new if none was equal before.
  std::uint32_t add(const Eigen::Vector3d& place);
  /// Room for so many, so that the table need not grow on the way.
  void reserve(std::size_t count);
  /// Has memory brought that add() of the place will need soon.
  void expect(const Eigen::Vector3d& place) const;
  /// In the order in which they first came.
  const std::vector<Eigen::Vector3d>& places() const { return places_; }
  /// The same, leaving none behind.
  std::vector<Eigen::Vector3d> take_places();

 private:
  void resize(std::size_t size);

  std::vector<Eigen::Vector3d> places_;
  std::vector<std::uint32_t> table_;  ///< size a power of two
};

}  // namespace diefill::geometry
