#include "process/laboratory/bulk_density/log_normal_bed.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "engine/coarse_graining/scaled_up_particle.h"
#include "engine/limits/time_step.h"
#include "engine/powder/size_classes.h"
#include "process/laboratory/bulk_density/sticky_spheres.h"

namespace diefill::process::laboratory {

namespace {

constexpr double kMeanDiameter = 1e-3, kWidth = 0.056, kHungWidth = 0.052;  // m, at scale 1
constexpr double kMassOfArea = 0.18 / (kWidth * kWidth);                    // kg/m^2
constexpr double kHungFrom = 0.025, kHungTo = 1.015, kSpeed = 0.2;          // m, m/s
constexpr double kFewest = 0.01, kMost = 0.999;                             // percentiles kept
constexpr std::size_t kClasses = 24;
constexpr double kFall = 0.6, kLongest = 1.5, kLook = 0.05;  // s
constexpr double kStill = 1e-6;                              // kinetic energy over m g d
constexpr double kImpact = 4.5;                              // m/s: falls of 1 m

/// At scale 1.
engine::SizeDistribution sizes_of(double variation) {
  if (variation == 0) return engine::SizeDistribution::single(kMeanDiameter);
  const double deviation = variation * kMeanDiameter;
  const auto whole = engine::SizeDistribution::log_normal_of_mean(kMeanDiameter, deviation);
  return engine::SizeDistribution::log_normal_of_mean(
      kMeanDiameter, deviation,
      {whole.quantile(kFewest, engine::SizeBasis::number), whole.quantile(kMost, engine::SizeBasis::number)});
}

engine::SimulationSettings settings_of(const LogNormalBed& bed,
                                       const std::vector<engine::CutClass>& classes) {
  engine::SimulationSettings settings;
  settings.types.clear();
  for (const auto& one : classes) settings.types.push_back({sticky_sphere(0.5 * one.diameter)});
  const auto law = sticky_law(bed.surface_energy, engine::laws::JkrLoad::corrected, {});
  settings.contact = engine::one_powder(law, law, engine::coarse_graining::scaled_up_particle(bed.scale));
  const double width = bed.share_of_width * bed.scale * kWidth;
  settings.period = {width, width};
  settings.time_step =
      engine::kDefaultTimeStepFraction *
      engine::critical_time_step(engine::moving_types(settings.types, settings.contact.scaling),
                                 settings.contact, {{}}, kImpact);
  return settings;
}

/// Sphere k of the list hangs at a random place free of all before it: the largest first, which finds room
/// most easily.
std::vector<engine::NewGrain> hung_spheres(const LogNormalBed& bed,
                                           const engine::SimulationSettings& settings,
                                           std::vector<std::uint16_t> kinds) {
  std::sort(kinds.begin(), kinds.end(), std::greater<>());
  const double period = *settings.period[0], half = 0.5 * bed.share_of_width * bed.scale * kHungWidth;
  std::mt19937_64 random(bed.seed);
  std::uniform_real_distribution<double> across(-half, half), up(kHungFrom, kHungTo);
  const auto radius = [&](std::uint16_t kind) { return settings.types[kind].shape.sphere_radius; };
  std::vector<engine::NewGrain> spheres;
  while (spheres.size() < kinds.size()) {
    engine::NewGrain sphere;
    sphere.kind = kinds[spheres.size()];
    sphere.velocity = {0, 0, -kSpeed};
    for (Eigen::Index axis : {0, 1}) sphere.position[axis] = across(random);
    sphere.position[2] = up(random);
    const auto in_the_way = [&](const engine::NewGrain& other) {
      Eigen::Vector3d between = sphere.position - other.position;
      for (Eigen::Index axis : {0, 1}) between[axis] -= period * std::round(between[axis] / period);
      return between.norm() < 1.001 * (radius(sphere.kind) + radius(other.kind));
    };
    const bool above_floor = sphere.position[2] > 1.001 * radius(sphere.kind);
    if (above_floor && std::none_of(spheres.begin(), spheres.end(), in_the_way)) spheres.push_back(sphere);
  }
  return spheres;
}

}  // namespace

LogNormalBedFigures settle_log_normal_bed(const LogNormalBed& bed) {
  const auto classes = engine::size_classes(sizes_of(bed.variation).scaled(bed.scale), kClasses);
  const auto settings = settings_of(bed, classes);
  double mean_mass = 0;
  for (std::size_t k = 0; k < classes.size(); ++k)
    mean_mass += classes[k].number_share * settings.types[k].shape.mass;
  const double area = *settings.period[0] * *settings.period[1];
  const auto count = static_cast<std::size_t>(std::lround(kMassOfArea * area / mean_mass));
  engine::Simulation simulation(settings, {plane_floor()});
  simulation.add_grains(hung_spheres(bed, settings, engine::drawn_classes(classes, count, bed.seed)));
  LogNormalBedFigures figures;
  while (simulation.time() < kLongest &&
         (simulation.time() < kFall || kinetic_per_sphere(simulation) > kStill)) {
    bed.tell(simulation.time() / kLongest);
    for (long k = std::lround(kLook / settings.time_step); k > 0; --k) {
      simulation.step();
      figures.sphere_steps += count;
    }
  }
  static_cast<SphereBedFigures&>(figures) = figures_of_bed(simulation);
  figures.smallest = classes.front().diameter;
  figures.largest = classes.back().diameter;
  return figures;
}

}  // namespace diefill::process::laboratory
