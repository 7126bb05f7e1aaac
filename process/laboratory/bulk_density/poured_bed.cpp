#include "process/laboratory/bulk_density/poured_bed.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "engine/coarse_graining/scaled_up_particle.h"
#include "engine/general_time_step.h"
#include "engine/grain_contacts.h"
#include "engine/time_step.h"

namespace diefill::process::laboratory {

namespace {

namespace laws = engine::laws;

constexpr double kYoung = 1e7, kPoisson = 0.3, kRestitution = 0.1, kFriction = 0.3, kSurfaceEnergy = 0.2;
constexpr double kDiameter = 5e-4, kDensity = 1000, kMass = 16.8e-3;  // m, kg/m^3, kg
constexpr double kWidth = 0.021, kPouredWidth = 0.020;                // m
constexpr double kPouredFrom = 0.240, kPouredTo = 0.330, kPouredSpeed = 0.2;
constexpr double kLow = 0.020, kHigh = 0.060;      // m, where density is measured
constexpr double kBatchEvery = 0.05, kRest = 2.0;  // s
constexpr double kStill = 1e-6;                    // kinetic energy over m g d
constexpr double kImpact = 2.4;                    // m/s: falls of 0.3 m

double volume_of(double radius) {
  return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

engine::SimulationSettings settings_of(const PouredBed& bed) {
  const double radius = 0.5 * kDiameter * bed.scale;
  engine::SimulationSettings settings;
  settings.shape = engine::model_b(radius, kDensity * volume_of(radius));
  laws::LawParameters law;
  law.normal = laws::JkrNormal::Parameters{poured_modulus(), kSurfaceEnergy, bed.load};
  law.damping = laws::RestitutionDamping::Parameters{kRestitution, poured_modulus()};
  law.friction = laws::MindlinFriction::Parameters{
      .shear_modulus = poured_shear_modulus(), .friction = kFriction, .restitution = kRestitution};
  law.rolling = bed.rolling;
  law.load_rule = laws::LoadRule::without;
  laws::require_sensible(law);
  const auto scaling = engine::coarse_graining::scaled_up_particle(bed.scale);
  settings.general_contact = engine::GeneralContact{law, law, scaling};
  settings.period = {kWidth, kWidth};
  settings.threads = bed.threads;
  engine::GrainShape as_simulated = settings.shape;
  as_simulated.inertia /= scaling.torque_factor();
  settings.time_step = engine::kDefaultTimeStepFraction *
                       engine::critical_time_step(as_simulated, *settings.general_contact, kImpact);
  return settings;
}

engine::WallBodySpec plane_floor() {
  engine::WallBodySpec floor;
  floor.name = "floor";
  floor.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  return floor;
}

/// `count` spheres at random free places of the region above the bed.
void pour_batch(engine::Simulation& simulation, std::size_t count, std::mt19937_64& random) {
  const double diameter = 2 * simulation.settings().shape.sphere_radius;
  std::vector<Eigen::Vector3d> taken;
  for (const auto& place : simulation.grains().position)
    if (place[2] > kPouredFrom - diameter) taken.push_back(place);
  std::uniform_real_distribution<double> across(-0.5 * kPouredWidth, 0.5 * kPouredWidth),
      up(kPouredFrom, kPouredTo);
  std::vector<engine::NewGrain> batch;
  while (batch.size() < count) {
    const double x = across(random), y = across(random), z = up(random);
    const Eigen::Vector3d place(x, y, z);
    const auto in_the_way = [&](const Eigen::Vector3d& other) {
      Eigen::Vector3d between = place - other;
      for (Eigen::Index axis : {0, 1}) between[axis] -= kWidth * std::round(between[axis] / kWidth);
      return between.norm() < 1.001 * diameter;
    };
    if (std::any_of(taken.begin(), taken.end(), in_the_way)) continue;
    taken.push_back(place);
    engine::NewGrain grain;
    grain.position = place;
    grain.velocity = {0, 0, -kPouredSpeed};
    batch.push_back(grain);
  }
  simulation.add_grains(batch);
}

double kinetic_per_grain(const engine::Simulation& simulation) {
  const auto& settings = simulation.settings();
  const double unit = settings.shape.mass * settings.gravity.norm() * 2 * settings.shape.sphere_radius;
  return simulation.energy().kinetic() / (unit * static_cast<double>(simulation.grains().size()));
}

/// m^3 of a sphere at height `z` below `height`.
double volume_below(double z, double radius, double height) {
  const double depth = std::clamp(height - z + radius, 0.0, 2 * radius);
  return std::numbers::pi * depth * depth * (radius - depth / 3);
}

void measure(const engine::Simulation& simulation, PouredBedFigures& figures) {
  const double radius = simulation.settings().shape.sphere_radius;
  const auto& place = simulation.grains().position;
  const auto inside = [&](std::size_t k) { return place[k][2] > kLow && place[k][2] < kHigh; };
  double volume = 0, counted = 0, touching = 0;
  for (std::size_t k = 0; k < place.size(); ++k) {
    volume += volume_below(place[k][2], radius, kHigh) - volume_below(place[k][2], radius, kLow);
    figures.height = std::max(figures.height, place[k][2] + radius);
    counted += inside(k) ? 1 : 0;
  }
  engine::visit_grain_contacts(simulation, [&](std::size_t i, std::size_t j, double) {
    touching += (inside(i) ? 1 : 0) + (inside(j) ? 1 : 0);
  });
  figures.density = kDensity * volume / (kWidth * kWidth * (kHigh - kLow));
  figures.coordination = counted > 0 ? touching / counted : 0;
  figures.kinetic = kinetic_per_grain(simulation);
  figures.simulated = simulation.time();
  figures.spheres = place.size();
}

}  // namespace

double poured_modulus() {
  return laws::contact_modulus(kYoung, kPoisson, kYoung, kPoisson);
}

double poured_shear_modulus() {
  return laws::contact_shear_modulus(kYoung, kPoisson, kYoung, kPoisson);
}

PouredBedFigures pour_bed(const PouredBed& bed) {
  const auto settings = settings_of(bed);
  engine::Simulation simulation(settings, {plane_floor()});
  const auto wanted = static_cast<std::size_t>(std::lround(kMass / settings.shape.mass));
  const auto batches = std::max(1L, std::lround(bed.pouring_time / kBatchEvery));
  const long steps_a_batch = std::lround(kBatchEvery / settings.time_step);
  std::mt19937_64 random(bed.seed);
  PouredBedFigures figures;
  const auto run = [&](long steps) {
    for (long k = 0; k < steps; ++k) simulation.step();
    figures.sphere_steps += static_cast<std::uint64_t>(steps) * simulation.grains().size();
  };
  for (long batch = 1; batch <= batches; ++batch) {
    const std::size_t due = wanted * static_cast<std::size_t>(batch) / static_cast<std::size_t>(batches);
    pour_batch(simulation, due - simulation.grains().size(), random);
    run(steps_a_batch);
  }
  // The last batch falls 0.3 m, which takes a quarter of a second.
  for (double rest = 0; rest < kRest && (rest < 0.3 || kinetic_per_grain(simulation) > kStill);
       rest += kBatchEvery)
    run(steps_a_batch);
  measure(simulation, figures);
  return figures;
}

}  // namespace diefill::process::laboratory
