// The last few answers by place.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace diefill::geometry {

/// `Count`, a power of two, slots for cubes of space. Cubes in a row along an axis have different slots, so a
/// tour that returns beside its path finds their values still there; some cubes share a slot.
template <typename Item, std::size_t Count>
class SpatialCache {
 public:
  Item& at(const Eigen::Vector3i& cube) {
    // Odd factors: multiples of each visit all slots.
    const auto number = [&](int axis) { return static_cast<std::uint32_t>(cube[axis]); };
    return slots_[(number(0) * kAlongX + number(1) * kAlongY + number(2) * kAlongZ) % Count];
  }
  auto begin() { return slots_.begin(); }
  auto end() { return slots_.end(); }

 private:
  static constexpr std::uint32_t kAlongX = 1, kAlongY = 23, kAlongZ = 103;
  std::array<Item, Count> slots_;
};

}  // namespace diefill::geometry
