#include "process/laboratory/settled_bed.h"

#include <algorithm>
#include <cmath>

#include "engine/observe/energy_balance.h"
#include "process/laboratory/bed_contacts.h"
#include "process/laboratory/endless_ground.h"
#include "process/laboratory/layer_profile.h"
#include "process/measure/measure.h"
#include "process/powder/material.h"
#include "process/run/fill_run.h"
#include "process/run/powder_state.h"
#include "process/setup/impact_speed.h"
#include "process/setup/pour.h"
#include "process/tooling/rest.h"

namespace diefill::process::laboratory {

namespace {

Scene scene_of(const BedSpec& spec, const engine::GrainShape& shape) {
  Scene scene;
  scene.seed = spec.seed;
  scene.powder = spec.powder;
  scene.numerics.time_step = spec.time_step;
  scene.numerics.time_step_fraction = spec.time_step_fraction;
  scene.numerics.lever_arm = spec.lever_arm;
  scene.numerics.tangential_spring = spec.spring;
  if (!spec.side_walls) scene.numerics.period[0] = spec.width;
  scene.numerics.period[1] = spec.depth;
  scene.pour.lower = {-0.5 * spec.width, -0.5 * spec.depth, 0};
  scene.pour.upper = {0.5 * spec.width, 0.5 * spec.depth, spec.fill_height};
  scene.pour.fill_height = spec.fill_height;
  scene.pour.solid_fraction = spec.expected_fraction;
  scene.pour.lattice_constant = spec.lattice_constant;
  if (spec.lattice_constant == 0 && spec.lattice_fraction > 0)
    scene.pour.lattice_constant =
        std::max(1.2, std::cbrt(shape.solid_volume / spec.lattice_fraction) / spec.powder.grain_diameter);
  return scene;
}

/// Ground of wall spheres about as far apart as asked for that repeats with the periods.
engine::WallBodySpec ground(const BedSpec& spec, double margin) {
  engine::WallBodySpec body;
  body.name = "ground";
  body.sphere_radius = spec.wall_sphere_radius;
  const double z = spec.ground_at_surface ? -spec.wall_sphere_radius : 0;
  const auto rows = [&](double length) {
    return std::ceil(length / (spec.ground_spacing * spec.wall_sphere_radius));
  };
  const double dx = spec.width / rows(spec.width), dy = spec.depth / rows(spec.depth);
  const int nx = static_cast<int>(std::ceil((0.5 * spec.width + margin) / dx));
  const int ny = static_cast<int>(std::ceil((0.5 * spec.depth + margin) / dy));
  for (int i = -nx; i <= nx; ++i)
    for (int j = -ny; j <= ny; ++j) body.centres.emplace_back(i * dx, j * dy, z);
  return body;
}

/// The same ground as two triangles.
engine::WallBodySpec mesh_ground(const BedSpec& spec, double margin) {
  engine::WallBodySpec body;
  body.name = "ground";
  const double x = 0.5 * spec.width + margin, y = 0.5 * spec.depth + margin;
  const double z = spec.ground_at_surface ? 0 : spec.wall_sphere_radius;
  const Eigen::Vector3d low(-x, -y, z), high(x, y, z);
  body.triangles.push_back({{low, Eigen::Vector3d(x, -y, z), high}});
  body.triangles.push_back({{low, high, Eigen::Vector3d(-x, y, z)}});
  return body;
}

/// The shoe's two walls across x, their surfaces `spec.width` apart and as high as the loose powder,
/// repeating along y.
engine::WallBodySpec side_walls(const BedSpec& spec, double height, double margin) {
  engine::WallBodySpec body;
  body.name = "side walls";
  body.sphere_radius = spec.wall_sphere_radius;
  const double spacing = 1.6 * spec.wall_sphere_radius;
  const double dy = spec.depth / std::ceil(spec.depth / spacing);
  const int ny = static_cast<int>(std::ceil((0.5 * spec.depth + margin) / dy));
  const double x = 0.5 * spec.width + spec.wall_sphere_radius;
  for (double z = 0; z < height; z += spacing)
    for (int j = -ny; j <= ny; ++j)
      for (const double side : {-x, x}) body.centres.emplace_back(side, j * dy, z);
  return body;
}

results::ToolState wall_state(const engine::WallBodySpec& body) {
  results::ToolState tool;
  tool.name = body.name;
  tool.role = "plate";
  tool.wall_sphere_centres = body.centres;
  tool.wall_sphere_radius = body.sphere_radius;
  return tool;
}

void fraction_figures(const BedSpec& spec, const engine::Simulation& simulation,
                      const std::vector<engine::WallBodySpec>& walls, BedFigures& figures) {
  const auto powder = powder_state(simulation, simulation.settings().shape(), spec.powder.grain_diameter);
  std::vector<results::ToolState> tools;
  for (const auto& wall : walls) tools.push_back(wall_state(wall));
  const auto fraction = measure_solid_fraction(powder, tools, {});
  figures.bulk_fraction = bulk_solid_fraction(powder, fraction);
  double top = 0, sum = 0, count = 0;
  for (const auto& position : powder.position) top = std::max(top, position[2]);
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    if (fraction.open[k] || powder.position[k][2] > top - 2 * powder.grain_diameter) continue;
    sum += fraction.solid_fraction[k];
    ++count;
  }
  figures.arithmetic_fraction = count > 0 ? sum / count : 0;
  const LayerProfile profile = layer_profile(powder, spec.width * spec.depth);
  const NearGround near = near_ground(profile, figures.bulk_fraction);
  figures.height = profile.height;
  figures.fraction = profile.share;
  figures.lowest_fraction_near_ground = near.lowest_share;
  figures.bulk_reached_at = near.bulk_reached_at;
}

}  // namespace

BedFigures settle_bed(const BedSpec& spec) {
  Scene probe;
  probe.powder = spec.powder;
  const Scene scene = scene_of(spec, mean_grain(probe));
  const double d = spec.powder.grain_diameter;
  const double poured = pour_height(scene, engine_settings(scene, 1.0));
  auto settings = engine_settings(scene, expected_impact_speed(scene, poured));
  const auto& shape = settings.shape();
  settings.threads = spec.threads;
  std::vector<engine::WallBodySpec> walls = {ground(spec, 2 * d)};
  if (spec.side_walls) walls.push_back(side_walls(spec, poured + d, 2 * d));
  auto met = walls;
  if (spec.mesh_ground) met.front() = mesh_ground(spec, 4 * d);
  engine::Simulation simulation(settings, met);
  simulation.add_grains(pour(scene, settings, endless_ground(scene)));

  RestWatch rest;
  engine::ValidityMonitor monitor;
  constexpr double kLongest = 5;  // s
  do {
    for (int n = 0; n < 50; ++n) simulation.step();
    monitor.check(simulation);
  } while (!rest.at_rest(simulation, d) && simulation.time() < kLongest);

  BedFigures figures;
  figures.grains = simulation.grains().size();
  figures.simulated = simulation.time();
  figures.sphere_steps = simulation.steps() * figures.grains * shape.spheres();
  figures.energy_balance_error = engine::energy_balance_error(simulation);
  fraction_figures(spec, simulation, walls, figures);
  contact_figures(simulation, d, figures);
  return figures;
}

}  // namespace diefill::process::laboratory
