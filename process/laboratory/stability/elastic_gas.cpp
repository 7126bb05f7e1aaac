#include "process/laboratory/stability/elastic_gas.h"

#include <cmath>
#include <random>

#include "engine/observe/energy_balance.h"
#include "engine/simulation/simulation.h"

namespace diefill::process::laboratory {

namespace {

engine::Quaternion random_orientation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  engine::Quaternion q;
  for (Eigen::Index k = 0; k < 4; ++k) q[k] = normal(random);
  return q.normalized();
}

}  // namespace

ElasticGas elastic_gas(const engine::GrainShape& shape, const engine::ContactParameters& contact, int across,
                       double spacing, double speed) {
  ElasticGas gas;
  const double width = across * spacing;
  gas.settings.types = {{shape}};
  gas.settings.contact = bierwisch_contact(contact, contact);
  gas.settings.gravity.setZero();
  gas.settings.period = {width, width};
  gas.walls = {plates(-0.5 * width, 0.5 * width)};
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal(0, speed);
  const auto vector = [&] { return Eigen::Vector3d(normal(random), normal(random), normal(random)); };
  for (int z = 0; z < across; ++z)
    for (int y = 0; y < across; ++y)
      for (int x = 0; x < across; ++x) {
        engine::NewGrain grain;
        grain.position = spacing * (Eigen::Vector3d(x, y, z) + Eigen::Vector3d::Constant(0.5 - 0.5 * across));
        grain.velocity = vector();
        grain.orientation = random_orientation(random);
        if (shape.rotates) grain.angular_velocity = vector() / shape.bounding_radius();
        gas.grains.push_back(grain);
      }
  return gas;
}

double energy_growth(const ElasticGas& gas, double time_step, double duration) {
  engine::SimulationSettings settings = gas.settings;
  settings.time_step = time_step;
  engine::Simulation simulation(settings, gas.walls);
  simulation.add_grains(gas.grains);
  const double start = engine::energy_of(simulation).kinetic();
  return spurious_energy(simulation, std::lround(duration / time_step), start);
}

}  // namespace diefill::process::laboratory
