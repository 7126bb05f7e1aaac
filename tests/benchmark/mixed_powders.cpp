// What several sizes and several powders cost over one powder of one size: settled beds of each, timed in
// turns in one run, as processor time per sphere and step and per touching pair. Quote ratios: machines are
// noisy.
//   ninja mixed_powders && bin/mixed_powders [REPEATS] [STEPS] [SPHERES]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "engine/laws/bierwisch_law.h"
#include "engine/observe/powder_figures.h"
#include "engine/powder/size_classes.h"
#include "engine/simulation/simulation.h"

namespace diefill::engine {
namespace {

constexpr double kRadius = 1.5e-4, kClumpRadius = 7.84e-5, kDensity = 5400;  // m, m, kg/m^3
constexpr int kMinFalls = 6, kFall = 5000;                                   // steps of 2e-6 s

/// Grains of a bed: their types, and how many of a hundred are of each.
struct Powder {
  std::string name;
  std::vector<ParticleType> types;
  std::vector<double> shares;  ///< of all grains
};

/// A grain whose size is `scale` times the usual one.
GrainShape grain(bool clumps, double scale) {
  const double radius = scale * (clumps ? kClumpRadius : kRadius);
  const double sphere = kDensity * 4.0 / 3.0 * M_PI * radius * radius * radius;
  return clumps ? model_d(radius, 7 * sphere) : model_b(radius, sphere);
}

std::vector<Powder> powders(bool clumps) {
  const auto of_sizes = [&](const std::string& name, const SizeDistribution& sizes) {
    Powder powder{name, {}, {}};
    for (const CutClass& one : size_classes(sizes, 8)) {
      powder.types.push_back({grain(clumps, one.diameter)});
      powder.shares.push_back(one.number_share);
    }
    return powder;
  };
  // Of the same mean mass as the one size: small ones of d, large ones of 2 d, as much mass of each.
  const double small = std::cbrt(1 / (8.0 / 9 + 8 * 1.0 / 9));
  return {
      {"one", {{grain(clumps, 1)}}, {1}},
      of_sizes("two sizes", SizeDistribution::discrete({{small, 0.5}, {2 * small, 0.5}}, SizeBasis::mass)),
      of_sizes("log-normal", SizeDistribution::log_normal(1, 0.3, SizeBasis::mass, {0.5, 2})),
      {"two powders", {{grain(clumps, 1)}, {grain(clumps, 1), "other"}}, {0.5, 0.5}},
  };
}

/// The tuned law, or one composed of parts: Hertz and Mindlin with restitution.
laws::LawParameters law_of(bool composed, bool clumps, double friction) {
  const double radius = clumps ? kClumpRadius : kRadius;
  if (!composed)
    return laws::bierwisch_law({.damping = 1e6 * radius, .tangential = 1e6 * radius, .friction = friction});
  laws::LawParameters law{.normal = laws::HertzMindlinNormal::Parameters{.modulus = 1e7}};
  law.damping = laws::RestitutionDamping::Parameters{.restitution = 0.5, .modulus = 1e7};
  law.friction =
      laws::MindlinFriction::Parameters{.shear_modulus = 2e6, .friction = friction, .restitution = 0.5};
  return law;
}

ContactLaws contact_of(bool composed, bool clumps) {
  ContactLaws contact;
  for (const auto& [a, b, friction] : {std::tuple{"powder", "powder", 0.5},
                                       {"powder", "walls", 0.5},
                                       {"other", "other", 0.3},
                                       {"powder", "other", 0.4},
                                       {"other", "walls", 0.3}})
    contact.pairs.push_back({a, b, law_of(composed, clumps, friction)});
  return contact;
}

/// A bed of the powder on a plane, periodic sideways, fallen together under the tuned law.
std::unique_ptr<Simulation> bed_of(const Powder& powder, bool clumps, std::size_t spheres) {
  SimulationSettings settings;
  settings.types = powder.types;
  settings.contact = contact_of(false, clumps);
  settings.time_step = 2e-6;
  double largest = 0;
  for (const auto& type : powder.types) largest = std::max(largest, type.shape.bounding_radius());
  const auto grains = static_cast<double>(spheres) / (clumps ? 7 : 1);
  const int across = std::max(4, static_cast<int>(std::lround(std::cbrt(grains))));
  const double constant = 2.1 * largest;
  settings.period = {across * constant, across * constant};
  WallBodySpec floor;
  floor.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  auto simulation = std::make_unique<Simulation>(settings, std::vector<WallBodySpec>{floor});
  std::vector<CutClass> classes;
  for (std::size_t k = 0; k < powder.shares.size(); ++k)
    classes.push_back({static_cast<double>(k), powder.shares[k]});
  const auto count = static_cast<std::size_t>(grains);
  const auto kinds = drawn_classes(classes, count, 1);
  std::vector<NewGrain> added;
  for (std::size_t n = 0; n < count; ++n) {
    const int i = static_cast<int>(n) % across, j = static_cast<int>(n) / across % across,
              k = static_cast<int>(n) / (across * across);
    NewGrain one;
    one.kind = kinds[n];
    one.position = constant * Eigen::Vector3d(i + 0.5 - 0.5 * across, j + 0.5 - 0.5 * across, k + 0.5);
    one.orientation = Quaternion(1, 0.3 * i, 0.2 * j, 0.1 * k).normalized();
    one.velocity = 0.02 * Eigen::Vector3d(std::sin(3.0 * i + 5.0 * k), std::sin(7.0 * j + 2.0 * k), 0);
    added.push_back(one);
  }
  simulation->add_grains(added);
  // Until contacts do not become more: large grains leave small ones far to fall.
  std::uint64_t before = 0;
  for (int fall = 0; fall < kMinFalls || simulation->touching_pairs() > before + before / 50; ++fall) {
    before = simulation->touching_pairs();
    for (int k = 0; k < kFall; ++k) simulation->step();
  }
  return simulation;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// ns of processor time of a step, over `per`.
double timed(Simulation& simulation, int steps, double per) {
  const std::clock_t began = std::clock();
  for (int k = 0; k < steps; ++k) simulation.step();
  return 1e9 * static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC / (per * steps);
}

void race(bool clumps, bool composed, int repeats, int steps,
          const std::vector<std::unique_ptr<Simulation>>& beds) {
  const auto all = powders(clumps);
  std::vector<std::vector<double>> per_sphere(beds.size()), per_contact(beds.size()),
      sphere_ratio(beds.size()), contact_ratio(beds.size());
  for (const auto& bed : beds) {
    bed->set_contact(contact_of(composed, clumps));
    for (int k = 0; k < 100; ++k) bed->step();
  }
  const auto spheres = [&](std::size_t b) { return static_cast<double>(sphere_count(*beds[b])); };
  for (int k = 0; k < repeats; ++k)
    for (std::size_t b = 0; b < beds.size(); ++b) {
      per_sphere[b].push_back(timed(*beds[b], steps, spheres(b)));
      per_contact[b].push_back(per_sphere[b].back() * spheres(b) /
                               static_cast<double>(beds[b]->touching_pairs()));
      sphere_ratio[b].push_back(per_sphere[b].back() / per_sphere[0][per_sphere[b].size() - 1]);
      contact_ratio[b].push_back(per_contact[b].back() / per_contact[0][per_contact[b].size() - 1]);
    }
  for (std::size_t b = 0; b < beds.size(); ++b)
    std::printf("%s,%s,%s,%.0f,%.3f,%.1f,%.1f,%.3f,%.3f\n", clumps ? "clumps" : "spheres",
                composed ? "hertz-mindlin" : "bierwisch", all[b].name.c_str(), spheres(b),
                static_cast<double>(beds[b]->touching_pairs()) / spheres(b), median(per_sphere[b]),
                median(per_contact[b]), median(sphere_ratio[b]), median(contact_ratio[b]));
  std::fflush(stdout);
}

void race_all(int repeats, int steps, std::size_t count) {
  std::puts(
      "grains,law,powder,spheres,touching_pairs_per_sphere,ns_per_sphere_step,ns_per_contact,"
      "over_one_per_sphere_step,over_one_per_contact");
  for (const bool clumps : {false, true}) {
    std::vector<std::unique_ptr<Simulation>> beds;
    for (const Powder& powder : powders(clumps)) beds.push_back(bed_of(powder, clumps, count));
    for (const bool composed : {false, true}) race(clumps, composed, repeats, steps, beds);
  }
}

}  // namespace
}  // namespace diefill::engine

int main(int count, char** words) {
  const auto number = [&](int place, int usual) { return count > place ? std::atoi(words[place]) : usual; };
  diefill::engine::race_all(number(1, 7), number(2, 200), static_cast<std::size_t>(number(3, 8000)));
}
