// Powders of several kinds for tests: sizes and materials, laws between them, and clouds of them.
#pragma once

#include "tests/engine/engine_test_support.h"

namespace diefill::engine {

inline constexpr double kMixRadius = 2.5e-4, kMixDensity = 1000;  // m; kg/m^3

inline double mass_of_ball(double radius) {
  return kMixDensity * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

/// Particle types and the laws between them.
struct GrainMix {
  std::vector<ParticleType> kinds;
  std::vector<laws::MaterialPairLaw> laws;
  coarse_graining::ForceScaling scaling;

  operator ContactLaws() const { return {laws, scaling}; }  // NOLINT: short in tests
};

inline double critical_time_step(const GrainMix& mix, const std::vector<WallSurface>& walls, double speed) {
  return critical_time_step(moving_types(mix.kinds, mix.scaling), mix, walls, speed);
}
inline double critical_time_step_at_overlap(const GrainMix& mix, double overlap, double over_radius) {
  return critical_time_step_at_overlap(moving_types(mix.kinds, mix.scaling), mix, overlap, over_radius);
}

/// Rotating spheres of kMixRadius times each of `sizes`, by turns of material "iron" and "wax", with one law
/// between all but two: that of unlike materials, and that with walls ("steel").
inline GrainMix mix_of(const std::vector<double>& sizes, const laws::LawParameters& monodisperse,
                       const laws::LawParameters& unlike, const laws::LawParameters& walls) {
  GrainMix mix;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const double radius = kMixRadius * sizes[k];
    mix.kinds.push_back({model_b(radius, mass_of_ball(radius)), k % 2 == 0 ? "iron" : "wax"});
  }
  mix.laws = {{"iron", "iron", monodisperse},
              {"wax", "wax", monodisperse},
              {"wax", "iron", unlike},
              {"steel", "iron", walls},
              {"wax", "steel", walls}};
  return mix;
}

inline SimulationSettings settings_of(const GrainMix& mix, double time_step) {
  SimulationSettings settings;
  settings.types = mix.kinds;
  settings.contact = mix;
  settings.gravity.setZero();
  settings.time_step = time_step;
  return settings;
}

inline WallBodySpec steel_floor(double height = 0) {
  WallBodySpec body;
  body.name = "floor";
  body.material = "steel";
  body.planes = {{Eigen::Vector3d(0, 0, height), Eigen::Vector3d::UnitZ()}};
  return body;
}

/// Bierwisch's law with these parameters, for any pair.
inline laws::LawParameters bierwisch_parts(const ContactParameters& contact) {
  return laws::bierwisch_law(contact);
}

/// converging_cloud() with kinds drawn at random from the first `kinds`.
inline std::vector<NewGrain> mixed_cloud(const Eigen::Vector3i& counts, double spacing, double speed,
                                         std::size_t kinds, std::uint64_t seed) {
  auto cloud = converging_cloud(counts, spacing, speed, seed);
  std::mt19937_64 random(seed + 1);
  for (auto& grain : cloud) grain.kind = static_cast<TypeNumber>(random() % kinds);
  return cloud;
}

inline Eigen::Vector3d momentum_of_mix(const Simulation& simulation) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < simulation.grains().size(); ++k)
    sum += simulation.shape_of(k).mass * simulation.grains().velocity[k];
  return sum;
}

/// kg m^2/s about the origin.
inline Eigen::Vector3d angular_momentum_of_mix(const Simulation& simulation) {
  const Grains& grains = simulation.grains();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const GrainShape& shape = simulation.shape_of(k);
    sum += shape.mass * grains.position[k].cross(grains.velocity[k]);
    sum += rotation_matrix(grains.orientation_of(k)) * shape.inertia.cwiseProduct(grains.spin[k]);
  }
  return sum;
}

/// Steps on and returns the most pairs that touched at a time.
inline std::uint64_t most_touching(Simulation& simulation, int steps) {
  std::uint64_t most = 0;
  for (int k = 0; k < steps; ++k) {
    simulation.step();
    most = std::max(most, simulation.touching_pairs());
  }
  return most;
}

}  // namespace diefill::engine
