#include "process/laboratory/settled_bed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "process/laboratory/bed_contacts.h"
#include "process/measure/measure.h"
#include "process/run/fill_run.h"
#include "process/run/material.h"
#include "process/run/pour.h"
#include "process/run/rest.h"

namespace diefill::process::laboratory {

namespace {

Scene scene_of(const BedSpec& spec, const engine::GrainShape& shape) {
  Scene scene;
  scene.seed = spec.seed;
  scene.powder = spec.powder;
  scene.numerics.time_step_fraction = spec.time_step_fraction;
  scene.numerics.lever_arm = spec.lever_arm;
  scene.numerics.tangential_spring = spec.spring;
  scene.numerics.period = {spec.width, spec.depth};
  scene.pour.lower = {-0.5 * spec.width, -0.5 * spec.depth, 0};
  scene.pour.upper = {0.5 * spec.width, 0.5 * spec.depth, spec.fill_height};
  scene.pour.fill_height = spec.fill_height;
  scene.pour.solid_fraction = spec.expected_fraction;
  if (spec.lattice_fraction > 0)
    scene.pour.lattice_constant =
        std::max(1.2, std::cbrt(shape.solid_volume / spec.lattice_fraction) / spec.powder.grain_diameter);
  return scene;
}

/// Ground of wall spheres about 1.6 R_w apart that repeats with the periods.
engine::WallBodySpec ground(const BedSpec& spec, double margin) {
  engine::WallBodySpec body;
  body.name = "ground";
  body.sphere_radius = spec.wall_sphere_radius;
  const double z = spec.ground_at_surface ? -spec.wall_sphere_radius : 0;
  const auto rows = [&](double length) { return std::ceil(length / (1.6 * spec.wall_sphere_radius)); };
  const double dx = spec.width / rows(spec.width), dy = spec.depth / rows(spec.depth);
  const int nx = static_cast<int>(std::ceil((0.5 * spec.width + margin) / dx));
  const int ny = static_cast<int>(std::ceil((0.5 * spec.depth + margin) / dy));
  for (int i = -nx; i <= nx; ++i)
    for (int j = -ny; j <= ny; ++j) body.centres.emplace_back(i * dx, j * dy, z);
  return body;
}

/// No tool in the way, and ground wherever powder falls.
Tooling endless_ground(const Scene& scene) {
  Tooling tooling;
  tooling.standing.include(scene.pour.lower - Eigen::Vector3d::Ones());
  tooling.standing.include(scene.pour.upper + Eigen::Vector3d::Ones());
  return tooling;
}

results::PowderState powder_state(const engine::Simulation& simulation, double grain_diameter) {
  const auto& shape = simulation.settings().shape;
  results::PowderState powder;
  powder.grain_diameter = grain_diameter;
  powder.sphere_radius = shape.sphere_radius;
  powder.grain_mass = shape.mass;
  powder.grain_solid_volume = shape.solid_volume;
  powder.sphere_offsets = shape.sphere_offsets;
  powder.id = simulation.grains().id;
  powder.position = simulation.grains().position;
  powder.orientation = simulation.grains().orientation;
  powder.velocity = simulation.grains().velocity;
  powder.angular_velocity.assign(powder.id.size(), Eigen::Vector3d::Zero());
  return powder;
}

results::ToolState ground_state(const engine::WallBodySpec& body) {
  results::ToolState tool;
  tool.name = body.name;
  tool.role = "plate";
  tool.wall_sphere_centres = body.centres;
  tool.wall_sphere_radius = body.sphere_radius;
  return tool;
}

/// Averages the grains' fractions in layers of d / 10 with Eq. 2.27 along z, sigma = d / 8.
void layer_profile(const results::PowderState& powder, const results::GrainSolidFraction& fraction,
                   BedFigures& figures) {
  const double d = powder.grain_diameter, sigma = d / 8, step = d / 10;
  double top = 0;
  for (const auto& position : powder.position) top = std::max(top, position[2]);
  for (double z = 0; z < top - 2 * d; z += step) {
    double weight = 0, sum = 0;
    for (std::size_t k = 0; k < powder.position.size(); ++k) {
      if (fraction.open[k]) continue;
      const double away = (powder.position[k][2] - z) / sigma;
      if (std::abs(away) > 4) continue;
      const double w = std::exp(-0.5 * away * away);
      weight += w;
      sum += w * fraction.solid_fraction[k];
    }
    if (weight < 1e-3) continue;
    figures.height.push_back(z / d);
    figures.fraction.push_back(sum / weight);
  }
}

void ground_figures(BedFigures& figures) {
  figures.lowest_fraction_near_ground = 1;
  figures.bulk_reached_at = 0;
  for (std::size_t k = 0; k < figures.height.size(); ++k) {
    if (figures.height[k] > 2) break;
    figures.lowest_fraction_near_ground = std::min(figures.lowest_fraction_near_ground, figures.fraction[k]);
    if (figures.fraction[k] < 0.95 * figures.bulk_fraction) figures.bulk_reached_at = figures.height[k];
  }
}

void fraction_figures(const BedSpec& spec, const engine::Simulation& simulation,
                      const engine::WallBodySpec& body, BedFigures& figures) {
  const auto powder = powder_state(simulation, spec.powder.grain_diameter);
  const auto fraction =
      measure_solid_fraction(powder, {ground_state(body)}, {}, simulation.settings().period);
  figures.bulk_fraction = bulk_solid_fraction(powder, fraction);
  double top = 0, sum = 0, count = 0;
  for (const auto& position : powder.position) top = std::max(top, position[2]);
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    if (fraction.open[k] || powder.position[k][2] > top - 2 * powder.grain_diameter) continue;
    sum += fraction.solid_fraction[k];
    ++count;
  }
  figures.arithmetic_fraction = count > 0 ? sum / count : 0;
  layer_profile(powder, fraction, figures);
  ground_figures(figures);
}

}  // namespace

BedFigures settle_bed(const BedSpec& spec) {
  Scene probe;
  probe.powder = spec.powder;
  const Scene scene = scene_of(spec, engine_settings(probe, 1.0).shape);
  const double d = spec.powder.grain_diameter;
  const auto shape = engine_settings(scene, 1.0).shape;
  auto settings = engine_settings(scene, expected_impact_speed(scene, pour_height(scene, shape)));
  settings.threads = spec.threads;
  const auto body = ground(spec, 2 * d);
  engine::Simulation simulation(settings, {body});
  simulation.add_grains(pour(scene, shape, endless_ground(scene)));

  RestWatch rest;
  engine::Health health;
  constexpr double kLongest = 5;  // s
  do {
    for (int n = 0; n < 50; ++n) simulation.step();
    health.check(simulation);
  } while (!rest.at_rest(simulation, d) && simulation.time() < kLongest);

  BedFigures figures;
  figures.grains = simulation.grains().size();
  figures.simulated = simulation.time();
  figures.sphere_steps = simulation.steps() * figures.grains * shape.spheres();
  figures.energy_balance_error = simulation.energy_balance_error();
  fraction_figures(spec, simulation, body, figures);
  contact_figures(simulation, d, figures);
  return figures;
}

}  // namespace diefill::process::laboratory
