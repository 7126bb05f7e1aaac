// How deep spheres have come to overlap: the first thing to look at when the method's range is in question.
#pragma once

#include <algorithm>

namespace diefill::engine {

/// Deepest overlaps (m), among grains and of grains with walls. A moving tool can pinch a grain against
/// another tool, so that the two are told apart.
struct DeepestOverlap {
  double grains = 0, walls = 0;
  double any() const { return std::max(grains, walls); }
  void include(const DeepestOverlap& other) {
    grains = std::max(grains, other.grains);
    walls = std::max(walls, other.walls);
  }
};

}  // namespace diefill::engine
