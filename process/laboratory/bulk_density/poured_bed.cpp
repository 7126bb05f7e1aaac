#include "process/laboratory/bulk_density/poured_bed.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "engine/coarse_graining/scaled_up_particle.h"
#include "engine/limits/time_step.h"

namespace diefill::process::laboratory {

namespace {

constexpr double kSurfaceEnergy = 0.2;                  // J/m^2
constexpr double kDiameter = 5e-4, kMass = 16.8e-3;     // m, kg
constexpr double kWidth = 0.021, kPouredWidth = 0.020;  // m
constexpr double kPouredFrom = 0.240, kPouredTo = 0.330, kPouredSpeed = 0.2;
constexpr double kBatchEvery = 0.05, kRest = 2.0;  // s
constexpr double kStill = 1e-6;                    // kinetic energy over m g d
constexpr double kImpact = 2.4;                    // m/s: falls of 0.3 m

engine::SimulationSettings settings_of(const PouredBed& bed) {
  const double radius = 0.5 * kDiameter * bed.scale;
  engine::SimulationSettings settings;
  settings.types = {{sticky_sphere(radius)}};
  const auto law = sticky_law(kSurfaceEnergy, bed.load, bed.rolling);
  const auto scaling = engine::coarse_graining::scaled_up_particle(bed.scale);
  settings.contact = engine::one_powder(law, law, scaling);
  settings.period = {kWidth, kWidth};
  settings.time_step = engine::kDefaultTimeStepFraction *
                       engine::critical_time_step(engine::moving_types(settings.types, scaling),
                                                  settings.contact, {{}}, kImpact);
  return settings;
}

/// `count` spheres at random free places of the region above the bed.
void pour_batch(engine::Simulation& simulation, std::size_t count, std::mt19937_64& random) {
  const double diameter = 2 * simulation.settings().shape().sphere_radius;
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

}  // namespace

PouredBedFigures pour_bed(const PouredBed& bed) {
  const auto settings = settings_of(bed);
  engine::Simulation simulation(settings, {plane_floor()});
  const auto wanted = static_cast<std::size_t>(std::lround(kMass / settings.shape().mass));
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
    bed.tell(simulation.time() / (bed.pouring_time + kRest));
  }
  // The last batch falls 0.3 m, which takes a quarter of a second.
  for (double rest = 0; rest < kRest && (rest < 0.3 || kinetic_per_sphere(simulation) > kStill);
       rest += kBatchEvery) {
    run(steps_a_batch);
    bed.tell((bed.pouring_time + rest) / (bed.pouring_time + kRest));
  }
  static_cast<SphereBedFigures&>(figures) = figures_of_bed(simulation);
  return figures;
}

}  // namespace diefill::process::laboratory
