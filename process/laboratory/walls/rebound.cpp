// How a sphere rebounds from a wall of spheres: the speed left after damping and the direction, compared with
// the surface itself.
#include <cmath>
#include <numbers>

#include "engine/simulation/simulation.h"
#include "process/laboratory/walls/level_wall.h"
#include "process/laboratory/walls/registry.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;

constexpr double kSpeed = 0.5;              // m/s
constexpr double kDampingOverRadius = 1e6;  // Pa s/m (Bierwisch 2009, Table C.4)

/// Velocity (m/s) of a sphere that has come off the wall; it is aimed at `aim` (m) on z = 0.
Eigen::Vector3d bounced(const engine::SimulationSettings& settings, const engine::WallBodySpec& wall,
                        const Eigen::Vector3d& aim, const Eigen::Vector3d& velocity) {
  engine::Simulation simulation(settings, {wall});
  const double radius = settings.shape().sphere_radius;
  engine::NewGrain grain;
  // So that the sphere's foot is at `aim` when it touches the plane.
  grain.position = aim + Eigen::Vector3d(0, 0, radius) + 0.05 * radius / velocity.z() * velocity;
  grain.position.z() = 1.05 * radius;
  grain.velocity = velocity;
  simulation.add_grains({grain});
  constexpr int kLongest = 20000;
  bool touched = false;
  for (int k = 0; k < kLongest; ++k) {
    simulation.step();
    touched = touched || simulation.touching_pairs() > 0;
    const auto& grains = simulation.grains();
    if (touched && simulation.touching_pairs() == 0 && grains.velocity[0].z() > 0 &&
        grains.position[0].z() > 0.9 * radius)
      break;
  }
  return simulation.grains().velocity[0];
}

/// Rebounds from places spread evenly over a cell of the grid.
struct Rebounds {
  double speed = 0;      ///< mean, over the speed of impact
  double deviation = 0;  ///< degrees, root mean square, from the direction on a smooth wall
};

Rebounds on_spheres(const SphereGrid& grid, double angle, double damping, int places) {
  const auto settings = single_sphere(damping, 0);
  const double radius = settings.shape().sphere_radius, step = grid.spacing * grid.radius;
  const auto wall = level_spheres(grid, 2.5 * radius + 3 * step);
  const Eigen::Vector3d along(std::cos(0.3), std::sin(0.3), 0);  // not along a row
  const Eigen::Vector3d velocity =
      kSpeed * (std::sin(angle) * along - std::cos(angle) * Eigen::Vector3d::UnitZ());
  Rebounds rebounds;
  for (int y = 0; y < places; ++y)
    for (int x = 0; x < places; ++x) {
      const Eigen::Vector3d aim = step / places * Eigen::Vector3d(x + 0.5, y + 0.5, 0);
      const Eigen::Vector3d off = bounced(settings, wall, aim, velocity);
      const Eigen::Vector3d mirrored(velocity.x(), velocity.y(), -velocity.z());
      const double turned = std::atan2(off.cross(mirrored).norm(), off.dot(mirrored));
      rebounds.speed += off.norm() / kSpeed / (places * places);
      rebounds.deviation += turned * turned / (places * places);
    }
  rebounds.deviation = std::sqrt(rebounds.deviation) * 180 / std::numbers::pi;
  return rebounds;
}

/// Of a straight impact, over the speed of impact. `contact_radius`: m, of the wall in R_eff.
double speed_on_mesh(double contact_radius) {
  const auto settings = single_sphere(kDampingOverRadius, 0);
  auto wall = level_mesh(1e-3);
  wall.contact_radius = contact_radius;
  return bounced(settings, wall, {1e-5, 2e-5, 0}, {0, 0, -kSpeed}).norm() / kSpeed;
}

results::ExperimentChart chart_of(const std::string& name, const std::string& title, const std::string& y) {
  results::ExperimentChart chart;
  chart.name = name;
  chart.title = title;
  chart.subtitle = "Sphere of R = 0.15 mm and 7.63e-8 kg at 0.5 m/s, mean over places of impact";
  chart.x = {.label = "Spacing of the wall spheres over their radius"};
  chart.y = {.label = y, .lower = 0};
  return chart;
}

ExperimentSeries level_line(const std::string& name, const std::vector<double>& x, double y) {
  return {
      .name = name, .role = ExperimentSeries::Role::predicted, .x = x, .y = std::vector<double>(x.size(), y)};
}

}  // namespace

void compare_rebound(const ExperimentOptions& options, results::ExperimentResult& result) {
  constexpr double kSlanted = std::numbers::pi / 4;
  const int places = options.quick ? 3 : 8;
  const auto spacings = linear_range(0.4, 2, options.quick ? 5 : 9);
  auto turned = chart_of("rebound_direction", "Rebounds from wall spheres deviate from the mirror direction",
                         "Deviation, root mean square [degrees]");
  turned.note = "Undamped, without friction, at 45 degrees. On the mesh itself the deviation is 0.";
  auto slowed = chart_of("rebound_speed", "Rebounds from wall spheres differ in speed",
                         "Speed of rebound over speed of impact");
  slowed.note = "Straight impact, damping 1e6 Pa s/m over R. Lines without points: on the mesh itself.";
  for (const double ratio : kRadiusRatios) {
    ExperimentSeries direction{.name = description(ratio), .x = {}, .y = {}}, speed = direction;
    for (const double spacing : spacings) {
      const SphereGrid grid{ratio * single_sphere(0, 0).shape().sphere_radius, spacing};
      direction.x.push_back(spacing);
      direction.y.push_back(on_spheres(grid, kSlanted, 0, places).deviation);
      speed.x.push_back(spacing);
      speed.y.push_back(on_spheres(grid, 0, kDampingOverRadius, places).speed);
    }
    turned.series.push_back(direction);
    slowed.series.push_back(speed);
    const SphereGrid usual{ratio * single_sphere(0, 0).shape().sphere_radius, 1.6};
    result.limits.push_back({"direction at 45 degrees, rms deviation, spacing 1.6, " + description(ratio),
                             on_spheres(usual, kSlanted, 0, places).deviation, 0, "degrees", "mesh"});
    result.limits.push_back({"straight rebound, speed, spacing 1.6, " + description(ratio),
                             on_spheres(usual, 0, kDampingOverRadius, places).speed,
                             speed_on_mesh(std::numeric_limits<double>::infinity()), "1", "mesh, flat"});
  }
  slowed.series.push_back(
      level_line("mesh, flat", spacings, speed_on_mesh(std::numeric_limits<double>::infinity())));
  slowed.series.push_back(level_line("mesh, R_eff of R_w = R", spacings,
                                     speed_on_mesh(single_sphere(0, 0).shape().sphere_radius)));
  result.charts.push_back(turned);
  result.charts.push_back(slowed);
}

}  // namespace diefill::process::laboratory
