// Pairs, collisions and integrals that the tests of contact laws share.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/laws/law_parameters.h"
#include "tests/engine/reference/all_pairs.h"

namespace diefill::engine::laws {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

inline double sphere_mass(double radius, double density) {
  return density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}
/// Two spheres of one density in kg/m^3.
inline PairProperties spheres(double radius_i, double radius_j, double density = 1000) {
  return {radius_i, radius_j, sphere_mass(radius_i, density), sphere_mass(radius_j, density)};
}
inline PairProperties sphere_on_wall(double radius, double density = 1000) {
  return {radius, kInfinite, sphere_mass(radius, density), kInfinite};
}

/// Integral of f from a to b: composite Simpson after x = a + (b - a) t^4, which tames roots at a.
inline double integral(const std::function<double(double)>& f, double a, double b, int pieces = 2000) {
  const double step = 1.0 / pieces;
  double sum = 0;
  for (int k = 0; k <= pieces; ++k) {
    const double t = k * step, weight = k == 0 || k == pieces ? 1 : (k % 2 == 1 ? 4 : 2);
    sum += weight * f(a + (b - a) * t * t * t * t) * 4 * t * t * t * (b - a);
  }
  return sum * step / 3;
}

/// What came of two spheres shot at each other head-on.
struct PairCollision {
  double restitution = 0;  ///< separation over approach speed at the end of the contact
  double duration = 0;     ///< s
  double deepest = 0;      ///< m
  bool stuck = false;      ///< still touching after `limit` steps
};

/// Head-on collision at relative `speed` in m/s in steps of `time_step` in s, by the slow reference.
inline PairCollision collide(const LawParameters& parameters, const PairProperties& pair, double speed,
                             double time_step, int limit = 200000) {
  reference::AllPairs<GeneralLaw> pairs({.time_step = time_step},
                                        [&](const PairProperties& of) { return make_law(parameters, of); });
  const double distance = pair.radius_i + pair.radius_j;
  const double sum = pair.mass_i + pair.mass_j;
  pairs.balls.resize(2);
  pairs.balls[0] = {.radius = pair.radius_i, .mass = pair.mass_i, .position = {distance, 0, 0}};
  pairs.balls[0].velocity = {-speed * pair.mass_j / sum, 0, 0};
  pairs.balls[1] = {.radius = pair.radius_j, .mass = pair.mass_j};
  pairs.balls[1].velocity = {speed * pair.mass_i / sum, 0, 0};
  PairCollision outcome;
  for (int step = 0; step < limit; ++step) {
    pairs.step();
    const double overlap = pairs.overlap(0, 1);
    outcome.deepest = std::max(outcome.deepest, overlap);
    outcome.duration += time_step;
    const double separation = pairs.balls[0].velocity.x - pairs.balls[1].velocity.x;
    outcome.restitution = separation / speed;
    if (overlap <= 0 && separation > 0) return outcome;
  }
  outcome.stuck = true;
  return outcome;
}

}  // namespace diefill::engine::laws
