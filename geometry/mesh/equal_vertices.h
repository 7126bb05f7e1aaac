// Vertices identified by position alone: triangle soups repeat every corner.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace diefill::geometry {

/// A growing set of distinct points. Points are equal if they compare equal, so both zeros are one; NaNs are
/// equal if their bits are, because damaged files may hold millions.
class EqualVertices {
 public:
  /// Number of the point, which is new if none was equal before.
  std::uint32_t add(const Eigen::Vector3d& place);
  /// Reserves room for that many.
  void reserve(std::size_t count);
  /// Prefetches the memory that add() of the point will need.
  void prefetch(const Eigen::Vector3d& place) const;
  /// In order of first appearance.
  const std::vector<Eigen::Vector3d>& places() const { return places_; }
  /// The same, moved out.
  std::vector<Eigen::Vector3d> take_places();

 private:
  void resize(std::size_t size);

  std::vector<Eigen::Vector3d> places_;
  std::vector<std::uint32_t> table_;  ///< size a power of two
};

}  // namespace diefill::geometry
