// Effective friction of a grain that slides over wall spheres: bumps slow it down in addition to Coulomb
// friction.
#include <cmath>
#include <numbers>

#include "engine/simulation/simulation.h"
#include "engine/simulation/standard_gravity.h"
#include "process/laboratory/walls/level_wall.h"
#include "process/laboratory/walls/registry.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;

constexpr double kFriction = 0.15;          // as the walls of scenes have by default
constexpr double kDampingOverRadius = 1e6;  // Pa s/m (Bierwisch 2009, Table C.4)
constexpr double kGravity = engine::kStandardGravity;

/// Speed lost over g t by a sphere that does not turn and slides from `speed` (m/s) to half of it along
/// `angle` (rad) to the rows: the coefficient of friction of a smooth wall.
double friction_felt(const engine::WallBodySpec& wall, double speed, double angle) {
  auto settings = single_sphere(kDampingOverRadius, kFriction);
  settings.gravity = {0, 0, -kGravity};
  engine::Simulation simulation(settings, {wall});
  engine::NewGrain grain;
  grain.position.z() = settings.shape().sphere_radius;
  grain.velocity = speed * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
  simulation.add_grains({grain});
  while (simulation.grains().velocity[0].head<2>().norm() > 0.5 * speed) simulation.step();
  return (speed - simulation.grains().velocity[0].head<2>().norm()) / (kGravity * simulation.time());
}

/// Its mean over directions.
double mean_friction(const SphereGrid& grid, double speed, int directions) {
  const double way = 0.75 * speed * speed / (kGravity * kFriction),
               broad = 4 * grid.spacing * grid.radius + 1e-3;
  double sum = 0;
  for (int k = 0; k < directions; ++k) {
    // From along the rows to along the diagonal, never exactly so.
    const double angle = 0.25 * std::numbers::pi * (k + 0.5) / directions;
    const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0);
    const auto wall = level_spheres(grid, way + broad, [&](const Eigen::Vector3d& centre) {
      const double lateral = centre.x() * along.y() - centre.y() * along.x();
      return centre.dot(along) > -broad && std::abs(lateral) < broad;
    });
    sum += friction_felt(wall, speed, angle) / directions;
  }
  return sum;
}

}  // namespace

void compare_sliding(const ExperimentOptions& options, results::ExperimentResult& result) {
  const int directions = options.quick ? 2 : 6;
  const auto spacings = linear_range(0.4, 2, options.quick ? 5 : 9);
  for (const double speed : {0.05, 0.2}) {
    char text[60];
    std::snprintf(text, sizeof text, "sliding_%.0f_mm_s", 1e3 * speed);
    results::ExperimentChart chart;
    chart.name = text;
    std::snprintf(text, sizeof text, "Effective friction on wall spheres from %.2g m/s", speed);
    chart.title = text;
    chart.subtitle = "Non-rotating sphere of R = 0.15 mm, wall friction 0.15, mean over directions";
    chart.note = "Speed lost over g t until half of it is left. Line without points: on the mesh itself.";
    chart.x = {.label = "Spacing of the wall spheres over their radius"};
    chart.y = {.label = "Effective coefficient of friction"};
    const double on_mesh = friction_felt(level_mesh(0.1), speed, 0.2);
    for (const double ratio : kRadiusRatios) {
      ExperimentSeries felt{.name = description(ratio), .x = {}, .y = {}};
      const double radius = ratio * single_sphere(0, 0).shape().sphere_radius;
      for (const double spacing : spacings) {
        felt.x.push_back(spacing);
        felt.y.push_back(mean_friction({radius, spacing}, speed, directions));
      }
      chart.series.push_back(felt);
      std::snprintf(text, sizeof text, "friction from %.2g m/s, spacing 1.6, ", speed);
      result.limits.push_back(
          {text + description(ratio), mean_friction({radius, 1.6}, speed, directions), on_mesh, "1", "mesh"});
    }
    chart.series.push_back({.name = "mesh",
                            .role = ExperimentSeries::Role::predicted,
                            .x = spacings,
                            .y = std::vector<double>(spacings.size(), on_mesh)});
    result.charts.push_back(chart);
  }
}

}  // namespace diefill::process::laboratory
