// Drops a cloud of clumps of seven spheres on a floor and prints their coordination number: the mean number
// of other clumps that a clump touches. Powder: Bierwisch 2009, Table C.4, model D, d = 0.47 mm. SI units
// throughout.
#include <diefill/engine/laws/bierwisch_law.h>
#include <diefill/engine/observe/grain_contacts.h>
#include <diefill/engine/simulation/simulation.h>

#include <cstdio>
#include <random>
#include <set>
#include <utility>

using namespace diefill::engine;

namespace {

constexpr double kSpacing = 6e-4;  // m, between clumps at the start
constexpr int kAcross = 6, kHigh = 10;

SimulationSettings settings_of_powder() {
  SimulationSettings settings;
  settings.types = {{model_d(7.84e-5, 7.63e-8)}};  // m, kg
  const double radius = settings.shape().sphere_radius;
  ContactParameters contact;
  contact.reduced_modulus = 1e7;      // Pa
  contact.damping = 1e6 * radius;     // Pa s
  contact.tangential = 1e6 * radius;  // N/m
  contact.friction = 0.5;
  settings.contact = one_powder(laws::bierwisch_law(contact), laws::bierwisch_law(contact));
  settings.period = {kAcross * kSpacing, kAcross * kSpacing, std::nullopt};  // m: no side walls
  settings.time_step = 2e-6;                                                 // s
  return settings;
}

std::vector<NewGrain> cloud() {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<NewGrain> grains(kAcross * kAcross * kHigh);
  for (int k = 0; k < static_cast<int>(grains.size()); ++k) {
    const int x = k % kAcross, y = k / kAcross % kAcross, z = k / (kAcross * kAcross);
    grains[k].position = kSpacing * Eigen::Vector3d(x + 0.5 - kAcross / 2.0, y + 0.5 - kAcross / 2.0, z + 1);
    grains[k].orientation =
        Quaternion(normal(random), normal(random), normal(random), normal(random)).normalized();
  }
  return grains;
}

}  // namespace

int main() {
  WallBodySpec floor{.name = "floor", .planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}}};
  Simulation simulation(settings_of_powder(), {floor});
  simulation.add_grains(cloud());
  while (simulation.time() < 0.08) simulation.step();
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  visit_grain_contacts(simulation,
                       [&](std::size_t i, std::size_t j, double) { pairs.insert(std::minmax(i, j)); });
  std::printf("%zu clumps, coordination number %.2f\n", simulation.grains().size(),
              2.0 * static_cast<double>(pairs.size()) / static_cast<double>(simulation.grains().size()));
}
