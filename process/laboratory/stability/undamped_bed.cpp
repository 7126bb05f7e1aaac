#include "process/laboratory/stability/undamped_bed.h"

#include <cmath>
#include <random>

#include "engine/limits/time_step.h"
#include "engine/observe/energy_balance.h"
#include "engine/simulation/simulation.h"
#include "process/laboratory/stability/contact_network.h"

namespace diefill::process::laboratory {

namespace {

/// The grains as they are now, to be put into another simulation.
std::vector<engine::NewGrain> grains_of(const engine::Simulation& simulation) {
  const auto& state = simulation.grains();
  std::vector<engine::NewGrain> grains(state.size());
  for (std::size_t k = 0; k < state.size(); ++k) {
    grains[k].position = state.position[k];
    grains[k].orientation = state.orientation_of(k);
  }
  return grains;
}

std::vector<engine::NewGrain> loose_layers(double spacing, int across, int layers) {
  std::vector<engine::NewGrain> grains;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int z = 0; z < layers; ++z)
    for (int y = 0; y < across; ++y)
      for (int x = 0; x < across; ++x) {
        engine::NewGrain grain;
        grain.position = spacing * Eigen::Vector3d(x + 0.5 - 0.5 * across, y + 0.5 - 0.5 * across, z + 0.6);
        grain.velocity = 0.03 * Eigen::Vector3d(uniform(random), uniform(random), uniform(random));
        grain.orientation =
            engine::Quaternion(1, uniform(random), uniform(random), uniform(random)).normalized();
        grains.push_back(grain);
      }
  return grains;
}

}  // namespace

UndampedBed undamped_bed(const engine::GrainShape& shape, double friction, int across, int layers) {
  const double spacing = 2.05 * shape.bounding_radius();
  engine::ContactParameters contact = elastic_contact();
  contact.friction = friction;
  contact.tangential = 1e6 * shape.sphere_radius;
  UndampedBed pile;
  pile.contact = contact;
  pile.settings.types = {{shape}};
  pile.settings.contact = bierwisch_contact(contact, contact);
  pile.settings.period = {across * spacing, across * spacing};

  engine::SimulationSettings damped = pile.settings;
  engine::ContactParameters damped_contact = contact;
  damped_contact.damping = 1e6 * shape.sphere_radius;
  damped.contact = bierwisch_contact(damped_contact, damped_contact);
  damped.time_step = engine::kDefaultTimeStepFraction *
                     engine::critical_time_step(shape, engine::laws::bierwisch_law(contact), 0.5);
  engine::Simulation simulation(damped, {floor_plate()});
  simulation.add_grains(loose_layers(spacing, across, layers));
  constexpr double kSettling = 0.12;  // s
  const auto steps = static_cast<long>(kSettling / damped.time_step);
  for (long k = 0; k < steps; ++k) simulation.step();
  pile.grains = grains_of(simulation);
  pile.eigenfrequency = largest_eigenfrequency(simulation);
  return pile;
}

double bed_energy_growth(const UndampedBed& pile, double time_step, long steps) {
  engine::SimulationSettings settings = pile.settings;
  settings.time_step = time_step;
  engine::Simulation simulation(settings, {floor_plate()});
  auto grains = pile.grains;
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, 1e-3);
  for (auto& grain : grains) grain.velocity = {normal(random), normal(random), normal(random)};
  simulation.add_grains(grains);
  const auto energy = engine::energy_of(simulation);
  return spurious_energy(simulation, steps, energy.kinetic() + energy.contacts);
}

}  // namespace diefill::process::laboratory
