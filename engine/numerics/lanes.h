// Short arrays for vector instructions: one entry (lane) per contact or grain.
#pragma once

#include <cstddef>

#include "engine/numerics/vector3.h"

namespace diefill::engine {

/// Lanes of the widest vectors; loops run over whole multiples of it.
inline constexpr std::size_t kLaneGroup = 8;

/// `count` rounded up to whole groups.
constexpr std::size_t whole_groups(std::size_t count) {
  return (count + kLaneGroup - 1) / kLaneGroup * kLaneGroup;
}

/// One number per lane.
template <std::size_t kCount>
struct alignas(64) Lanes {
  // One group more than used: arrays at a distance of a power of two
  // would evict each other from the cache.
  double value[kCount + kLaneGroup];
  double& operator[](std::size_t lane) { return value[lane]; }
  double operator[](std::size_t lane) const { return value[lane]; }
};

/// One vector a lane.
template <std::size_t kCount>
struct VectorLanes {
  Lanes<kCount> x, y, z;
  Vector3 operator[](std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
  void set(std::size_t lane, Vector3 v) {
    x[lane] = v.x;
    y[lane] = v.y;
    z[lane] = v.z;
  }
};

/// A sum over many lanes, the same for all instruction sets.
class LaneSum {
 public:
  /// Adds the first `count` lanes.
  template <std::size_t kCount>
  void add(const Lanes<kCount>& lanes, std::size_t count) {
    std::size_t k = 0;
    for (; k + kLaneGroup <= count; k += kLaneGroup)
      for (std::size_t lane = 0; lane < kLaneGroup; ++lane) part_[lane] += lanes[k + lane];
    for (std::size_t lane = 0; k + lane < count; ++lane) part_[lane] += lanes[k + lane];
  }
  double total() const {
    double sum = 0;
    for (const double part : part_) sum += part;
    return sum;
  }

 private:
  double part_[kLaneGroup] = {};
};

/// The largest of many lanes, at least 0.
class LaneMax {
 public:
  /// Includes the first `count` lanes.
  template <std::size_t kCount>
  void add(const Lanes<kCount>& lanes, std::size_t count) {
    std::size_t k = 0;
    for (; k + kLaneGroup <= count; k += kLaneGroup)
      for (std::size_t lane = 0; lane < kLaneGroup; ++lane)
        part_[lane] = lanes[k + lane] > part_[lane] ? lanes[k + lane] : part_[lane];
    for (std::size_t lane = 0; k + lane < count; ++lane)
      part_[lane] = lanes[k + lane] > part_[lane] ? lanes[k + lane] : part_[lane];
  }
  double max() const {
    double most = 0;
    for (const double part : part_) most = part > most ? part : most;
    return most;
  }

 private:
  double part_[kLaneGroup] = {};
};

}  // namespace diefill::engine
