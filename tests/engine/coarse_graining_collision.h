// Binary collisions of two model D grains at several grain sizes (Bierwisch 2009, section 3.1, Fig. 3.1,
// Table C.1): curves that collapse when, and only when, the material is scaled with the grain.
#pragma once

#include <algorithm>
#include <vector>

#include "engine/coarse_graining/bierwisch.h"
#include "engine/observe/energy_balance.h"
#include "tests/engine/contact_energy.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {

/// How two grains meet: arm tip to arm tip; one turned by 45 degrees about y; at random orientations with an
/// impact parameter of one sphere radius.
enum class PairCollision { tip_to_tip, turned, oblique };

/// One collision; entry k of each array belongs to step k. All dimensionless but the energy density (J/m^3).
struct CollisionCurve {
  std::vector<double> time_over_size;     ///< t / d in s/m
  std::vector<double> energy_density;     ///< energy in contacts over the grain volume
  std::vector<double> overlap_over_size;  ///< deepest h over d
};

/// The material of Table C.1 at d = 0.47 mm.
inline coarse_graining::Material table_c1() {
  coarse_graining::Material material;
  material.sphere_radius = 7.84e-5;
  material.grain_mass = 7.6e-8;
  material.reduced_modulus = 1e7;
  material.damping = 1e5 * material.sphere_radius;
  material.tangential = 1e6 * material.sphere_radius;
  material.work_of_adhesion = 128 * material.sphere_radius;
  material.friction = 1;
  return material;
}

/// The two grains at relative speed 0.2 m/s along x, surfaces at least 0.01 d apart.
inline std::vector<NewGrain> two_grains(PairCollision encounter, double radius) {
  const double size = 6 * radius, speed = 0.2;
  NewGrain left, right;
  left.velocity = {0.5 * speed, 0, 0};
  right.velocity = -left.velocity;
  double apart = 1.01 * size;
  if (encounter == PairCollision::turned) {
    // The tip of the one goes between two arms of the other, which reach sqrt(2) R along x; just off the
    // middle, so that contacts slide.
    right.orientation = {std::cos(std::numbers::pi / 8), 0, std::sin(std::numbers::pi / 8), 0};
    apart = (3 + std::sqrt(2.0) + 1) * radius + 0.01 * size;
    left.position.z() = 0.2 * radius;
  }
  if (encounter == PairCollision::oblique) {
    std::mt19937_64 random(1);
    left.orientation = random_orientation(random);
    right.orientation = random_orientation(random);
    left.position.y() = radius;
  }
  left.position.x() = -0.5 * apart;
  right.position.x() = 0.5 * apart;
  return {left, right};
}

/// Runs one encounter without gravity and air; 2.5e-7 s a step at d = 0.47 mm, in proportion to d elsewhere.
inline CollisionCurve collide(const coarse_graining::Material& material, PairCollision encounter,
                              LeverArm arm, int steps) {
  const double radius = material.sphere_radius, size = 6 * radius;
  SimulationSettings settings;
  settings.types = {{model_d(radius, material.grain_mass)}};
  grain_contact(settings) = {material.reduced_modulus, material.damping,          material.tangential,
                             material.friction,        material.work_of_adhesion, material.rolling_friction};
  settings.lever_arm = arm;
  settings.gravity.setZero();
  settings.time_step = 2.5e-7 * radius / table_c1().sphere_radius;
  Simulation simulation(settings, {});
  simulation.add_grains(two_grains(encounter, radius));
  CollisionCurve curve;
  for (int k = 0; k < steps; ++k) {
    simulation.step();
    curve.time_over_size.push_back(simulation.time() / size);
    curve.energy_density.push_back((energy_of(simulation).contacts + tangential_energy(simulation)) /
                                   settings.shape().solid_volume);
    curve.overlap_over_size.push_back(simulation.deepest_overlap() / size);
  }
  return curve;
}

/// Largest difference of two curves over the largest value of the first.
inline double difference_over_peak(const std::vector<double>& first, const std::vector<double>& second) {
  double peak = 0, difference = 0;
  for (std::size_t k = 0; k < first.size(); ++k) {
    peak = std::max(peak, std::abs(first[k]));
    difference = std::max(difference, std::abs(first[k] - second[k]));
  }
  return difference / peak;
}

}  // namespace diefill::engine
