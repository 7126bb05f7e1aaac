// How cost depends on size: a sphere-step costs more in a large bed, whose grains do not fit the processor's
// caches, and in a very small one, which gives threads little work to share. How much more differs from
// machine to machine.
#pragma once

#include <vector>

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::process::plan {

/// Times of the same bed once and several times side by side.
struct SizeCost {
  struct Point {
    double spheres = 0;
    double seconds_per_sphere_step = 0;  ///< without searches for near pairs
    double search_seconds = 0;           ///< of one search, a sphere
  };
  std::vector<Point> points;  ///< fewest spheres first

  /// Cost of a sphere and step in a bed of `spheres` over that in one of `from`: linear in the logarithm of
  /// the number between points, that of the nearest point beyond them; 1 where nothing was measured.
  double factor(double spheres, double from) const;
  /// The same of a search for near pairs.
  double search_factor(double spheres, double from) const;

 private:
  double factor_of(double Point::*cost, double spheres, double from) const;
};

/// Steps copies of the bed side by side, without tools, in steps so short that contacts stay what they are,
/// on as many threads as the bed's. A million spheres at most, some seconds.
SizeCost measure_size_cost(const engine::Simulation& bed);

}  // namespace diefill::process::plan
