// How deep spheres have come to overlap: the first thing to look at when the method's range is in question.
#pragma once

#include <algorithm>

namespace diefill::engine {

/// Deepest overlaps (m), among grains and of grains with walls. A moving tool can pinch a grain against
/// another tool, so that the two are counted separately. What is deep for a small grain is not for a large
/// one: the deepest in terms of sphere radii are kept apart.
struct DeepestOverlap {
  double grains = 0, walls = 0;
  double grains_over_radius = 0, walls_over_radius = 0;  ///< over the radius of the smaller sphere of grains
  double any() const { return std::max(grains, walls); }
  double any_over_radius() const { return std::max(grains_over_radius, walls_over_radius); }
  void include(const DeepestOverlap& other) {
    grains = std::max(grains, other.grains);
    walls = std::max(walls, other.walls);
    grains_over_radius = std::max(grains_over_radius, other.grains_over_radius);
    walls_over_radius = std::max(walls_over_radius, other.walls_over_radius);
  }
};

}  // namespace diefill::engine
