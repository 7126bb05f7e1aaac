#include "process/laboratory/bulk_density/bed_figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/observe/energy_balance.h"
#include "engine/observe/grain_contacts.h"

namespace diefill::process::laboratory {

namespace {

/// m^3 of a sphere at height `z` (m) below `height` (m): a spherical cap, pi h^2 (R - h / 3).
double volume_below(double z, double radius, double height) {
  const double depth = std::clamp(height - z + radius, 0.0, 2 * radius);
  return std::numbers::pi * depth * depth * (radius - depth / 3);
}

}  // namespace

double kinetic_per_sphere(const engine::Simulation& simulation) {
  double weight = 0;  // of all spheres, N
  for (std::size_t k = 0; k < simulation.grains().size(); ++k)
    weight += simulation.shape_of(k).mass * simulation.settings().gravity.norm();
  const auto count = static_cast<double>(simulation.grains().size());
  const auto& first = simulation.shape_of(0);
  const double mass = weight / (count * simulation.settings().gravity.norm());
  const double diameter = 2 * first.sphere_radius * std::cbrt(mass / first.mass);
  return engine::energy_of(simulation).kinetic() / (weight * diameter);
}

SphereBedFigures figures_of_bed(const engine::Simulation& simulation, const BedWindow& window) {
  SphereBedFigures figures;
  const auto& place = simulation.grains().position;
  const auto inside = [&](std::size_t k) { return place[k][2] > window.low && place[k][2] < window.high; };
  double mass = 0, counted = 0, touching = 0;
  for (std::size_t k = 0; k < place.size(); ++k) {
    const auto& shape = simulation.shape_of(k);
    const double radius = shape.sphere_radius;
    mass += shape.mass / shape.solid_volume *
            (volume_below(place[k][2], radius, window.high) - volume_below(place[k][2], radius, window.low));
    figures.height = std::max(figures.height, place[k][2] + radius);
    counted += inside(k) ? 1 : 0;
  }
  engine::visit_grain_contacts(simulation, [&](std::size_t i, std::size_t j, double) {
    touching += (inside(i) ? 1 : 0) + (inside(j) ? 1 : 0);
  });
  const auto& period = simulation.settings().period;
  figures.density = mass / (*period[0] * *period[1] * (window.high - window.low));
  figures.coordination = counted > 0 ? touching / counted : 0;
  figures.kinetic = kinetic_per_sphere(simulation);
  figures.simulated = simulation.time();
  figures.spheres = place.size();
  return figures;
}

}  // namespace diefill::process::laboratory
