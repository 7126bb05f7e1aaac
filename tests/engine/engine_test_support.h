// What the engine's tests share: the thesis' powders, encounters of two grains, clouds of grains and the
// quantities that must not change.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "engine/powder/rigid_motion.h"
#include "engine/simulation/simulation.h"
#include "tests/support/contact_access.h"

namespace diefill::engine {

enum class Model { a, b, c, d };

/// Grain shape of Bierwisch 2009, Table C.4.
inline GrainShape thesis_shape(Model model) {
  switch (model) {
    case Model::a:
      return model_a(1.5e-4, 7.63e-8);
    case Model::b:
      return model_b(1.5e-4, 7.63e-8);
    case Model::c:
      return model_c(8.9e-5, 7.63e-8);
    default:
      return model_d(7.84e-5, 7.63e-8);
  }
}

/// m, distance from a grain's centre to the tip of its arm along a body axis: half the grain size d.
inline double half_size(const GrainShape& shape) {
  return shape.bounding_radius();
}

/// The coefficients that the tables give over the sphere radius, and those that they give alone.
struct Powder {
  double damping_over_radius = 1e6;     ///< Pa s/m
  double tangential_over_radius = 1e6;  ///< Pa
  double friction = 0;
  double work_of_adhesion = 0;  ///< J/m^2
  double rolling_friction = 0;  ///< m
};

/// Grains of `model` in empty space: no gravity, no air, walls with mu_w = 0.15 and no cohesion (Table C.4).
inline SimulationSettings weightless(Model model, const Powder& powder, double time_step) {
  SimulationSettings settings;
  settings.types = {{thesis_shape(model)}};
  const double radius = settings.shape().sphere_radius;
  grain_contact(settings) = {1e7,
                             powder.damping_over_radius * radius,
                             powder.tangential_over_radius * radius,
                             powder.friction,
                             powder.work_of_adhesion,
                             model == Model::b ? powder.rolling_friction : 0};
  wall_contact(settings) = grain_contact(settings);
  wall_contact(settings)->friction = 0.15;
  wall_contact(settings)->work_of_adhesion = 0;
  settings.gravity.setZero();
  settings.time_step = time_step;
  return settings;
}

/// Place of the grain with this id: searches change the order.
inline std::size_t place_of(const Simulation& simulation, std::uint64_t id) {
  const auto& ids = simulation.grains().id;
  for (std::size_t k = 0; k < ids.size(); ++k)
    if (ids[k] == id) return k;
  throw std::out_of_range("no grain of this id");
}

inline Eigen::Vector3d position_of(const Simulation& simulation, std::uint64_t id) {
  return simulation.grains().position[place_of(simulation, id)];
}

inline Eigen::Vector3d velocity_of(const Simulation& simulation, std::uint64_t id) {
  return simulation.grains().velocity[place_of(simulation, id)];
}

inline void run_steps(Simulation& simulation, int steps) {
  for (int k = 0; k < steps; ++k) simulation.step();
}

/// Head-on encounter along x, each grain on an arm's tip, surfaces touching at the start.
struct HeadOn {
  double duration = 0;  ///< s, until the overlap is zero again; 0 if the grains stick
  double rebound = 0;   ///< m/s, speed of separation
  double deepest = 0;   ///< m, largest overlap
};

inline HeadOn collide_head_on(const SimulationSettings& settings, double speed) {
  Simulation simulation(settings, {});
  const double half = half_size(settings.shape());
  NewGrain left, right;
  left.position = {-half, 0, 0};
  left.velocity = {0.5 * speed, 0, 0};
  right.position = -left.position;
  right.velocity = -left.velocity;
  simulation.add_grains({left, right});
  double gap_before = 0;
  for (int step = 0; step < 200000; ++step) {
    simulation.step();
    const double gap = (position_of(simulation, 1) - position_of(simulation, 0)).x() - 2 * half;
    if (gap > 0) {
      const double part = gap_before / (gap_before - gap);
      return {simulation.time() - (1 - part) * settings.time_step,
              (velocity_of(simulation, 1) - velocity_of(simulation, 0)).x(),
              simulation.deepest_overlap_of_run()};
    }
    gap_before = gap;
  }
  return {0, 0, simulation.deepest_overlap_of_run()};
}

inline Quaternion random_orientation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Quaternion(normal(random), normal(random), normal(random), normal(random)).normalized();
}

inline Eigen::Vector3d random_vector(std::mt19937_64& random, double half_width) {
  std::uniform_real_distribution<double> uniform(-half_width, half_width);
  return {uniform(random), uniform(random), uniform(random)};
}

/// Grains on a cubic lattice of `counts` with `spacing` (m), centred on `centre`, at random orientations,
/// flying towards the centre at up to `speed` (m/s) with a random part.
inline std::vector<NewGrain> converging_cloud(const Eigen::Vector3i& counts, double spacing, double speed,
                                              std::uint64_t seed,
                                              const Eigen::Vector3d& centre = Eigen::Vector3d::Zero()) {
  std::mt19937_64 random(seed);
  std::vector<NewGrain> grains;
  const Eigen::Vector3d middle = 0.5 * (counts.cast<double>() - Eigen::Vector3d::Ones());
  for (int z = 0; z < counts[2]; ++z)
    for (int y = 0; y < counts[1]; ++y)
      for (int x = 0; x < counts[0]; ++x) {
        NewGrain grain;
        const Eigen::Vector3d place = (Eigen::Vector3d(x, y, z) - middle) * spacing;
        grain.position = centre + place + random_vector(random, 0.03 * spacing);
        grain.velocity = -speed * place / (spacing * middle.maxCoeff()) + random_vector(random, 0.3 * speed);
        grain.orientation = random_orientation(random);
        grain.angular_velocity = random_vector(random, speed / spacing);
        grains.push_back(grain);
      }
  return grains;
}

/// kg m/s
inline Eigen::Vector3d momentum(const Simulation& simulation) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& velocity : simulation.grains().velocity)
    sum += simulation.settings().shape().mass * velocity;
  return sum;
}

/// kg m^2/s about the origin, laboratory frame.
inline Eigen::Vector3d angular_momentum(const Simulation& simulation) {
  const auto& grains = simulation.grains();
  const auto& shape = simulation.settings().shape();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < grains.size(); ++k) {
    sum += shape.mass * grains.position[k].cross(grains.velocity[k]);
    sum += rotation_matrix(grains.orientation_of(k)) * shape.inertia.cwiseProduct(grains.spin[k]);
  }
  return sum;
}

/// A wall so large (R_w = 100 m) that a grain sees a plane z = 0; powder above.
inline WallBodySpec plane_wall(std::function<BodyMotion(double)> motion = {}) {
  WallBodySpec plane;
  plane.name = "plane";
  plane.sphere_radius = 100;
  plane.centres = {Eigen::Vector3d(0, 0, -plane.sphere_radius)};
  plane.motion = std::move(motion);
  return plane;
}

/// A level plate of wall spheres on a square grid of spacing 1.6 R_w, tops at z = 0 (Bierwisch 2009,
/// section 2.3).
inline WallBodySpec plate(double half_width, double sphere_radius,
                          std::function<BodyMotion(double)> motion = {}) {
  WallBodySpec body;
  body.name = "plate";
  body.sphere_radius = sphere_radius;
  const int count = static_cast<int>(std::ceil(half_width / (1.6 * sphere_radius)));
  for (int y = -count; y <= count; ++y)
    for (int x = -count; x <= count; ++x)
      body.centres.emplace_back(1.6 * sphere_radius * x, 1.6 * sphere_radius * y, -sphere_radius);
  body.motion = std::move(motion);
  return body;
}

}  // namespace diefill::engine
