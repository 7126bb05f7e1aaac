// What a wall of spheres holds: the speed at which a grain is pushed through, against spacing, size and
// angle; and how rough such a wall is.
#include <cmath>
#include <numbers>

#include "engine/limits/time_step.h"
#include "engine/limits/validity_monitor.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/standard_gravity.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

/// A square grid of spheres with their centres on z = 0, and what flies at its middle.
struct Target {
  engine::GrainShape shape;
  double wall_radius = 1.5e-4;  // m, R_w
  double spacing = 1.6;         // over R_w
  double angle = 0;             // rad, of the flight against the wall's normal
  bool wall_moves = false;      // in place of the grain
};

engine::WallBodySpec grid(const Target& target) {
  engine::WallBodySpec body;
  body.name = "grid";
  body.sphere_radius = target.wall_radius;
  const double step = target.spacing * target.wall_radius;
  const double reach = 2 * target.shape.bounding_radius() + 3 * target.wall_radius;
  const int count = static_cast<int>(std::ceil(reach * (1 + std::tan(target.angle)) / step)) + 1;
  for (int y = -count; y < count; ++y)
    for (int x = -count; x < count; ++x) body.centres.emplace_back((x + 0.5) * step, (y + 0.5) * step, 0);
  return body;
}

/// m/s, speed with which a grain overcomes the elastic energy along the straight way through the middle of
/// four wall spheres: m v^2 / 2 = max_z sum 2/5 k h^(5/2).
double speed_of_barrier(const Target& target) {
  const double radius = target.shape.sphere_radius, wall = target.wall_radius;
  const double spring =
      2.0 / 3.0 * elastic_contact().reduced_modulus * std::sqrt(engine::effective_radius(radius, wall));
  const auto centres = grid(target).centres;
  double barrier = 0;
  for (double z = -wall; z < target.shape.bounding_radius() + wall; z += 0.02 * radius) {
    double energy = 0;
    for (const auto& offset : target.shape.sphere_offsets)
      for (const auto& centre : centres) {
        const double overlap = radius + wall - (offset + Eigen::Vector3d(0, 0, z) - centre).norm();
        if (overlap > 0) energy += 0.4 * spring * std::pow(overlap, 2.5);
      }
    barrier = std::max(barrier, energy);
  }
  return std::sqrt(2 * barrier / target.shape.mass);
}

struct Impact {
  bool held = true;
  double deepest = 0;  // m
};

Impact fly_at(const Target& target, double speed) {
  const double size = target.shape.bounding_radius();
  engine::SimulationSettings settings;
  settings.types = {{target.shape}};
  settings.contact = bierwisch_contact(elastic_contact(), elastic_contact());
  settings.gravity.setZero();
  settings.time_step = std::min(
      0.01 * target.shape.sphere_radius / speed,
      0.1 * engine::critical_time_step(target.shape, engine::laws::bierwisch_law(elastic_contact()), speed));
  auto wall = grid(target);
  if (target.wall_moves)
    wall.motion = [speed](double time) {
      engine::BodyMotion motion;
      motion.translation.z() = speed * time;
      motion.velocity.z() = speed;
      return motion;
    };
  engine::Simulation simulation(settings, {wall});
  engine::NewGrain grain;
  const double height = size + 1.05 * target.wall_radius;
  grain.position = {-height * std::tan(target.angle), 0, height};
  if (!target.wall_moves)
    grain.velocity = {speed * std::sin(target.angle), 0, -speed * std::cos(target.angle)};
  simulation.add_grains({grain});
  const auto place = [&] {
    return simulation.grains().position[0].z() - simulation.body_motion(0).translation.z();
  };
  const auto steps = static_cast<long>(20 * height / (speed * std::cos(target.angle) * settings.time_step));
  for (long k = 0; k < steps && place() > -size - target.wall_radius && place() < 1.1 * height; ++k)
    simulation.step();
  return {place() > 0, simulation.deepest_overlap_of_run()};
}

double speed_that_passes(const Target& target) {
  return largest_that_holds(0.01, 300, 0.02, [&](double speed) { return fly_at(target, speed).held; });
}

/// A speed at the lower end of the search means no resistance: no point is drawn.
double drawn(double speed) {
  return speed > 0.0101 ? speed : std::nan("");
}

/// Speeds that push the grain of `base` through, over spacings: found, and by the elastic energy.
void add_push_through(const std::string& name, const Target& base, int spacings,
                      results::ExperimentChart& chart) {
  ExperimentSeries measured{.name = name, .x = {}, .y = {}};
  ExperimentSeries predicted{
      .name = "energy: " + name, .role = Role::predicted, .x = {}, .y = {}, .in_legend = false};
  for (const double spacing : linear_range(0.4, 2.2, spacings)) {
    Target target = base;
    target.spacing = spacing;
    measured.x.push_back(spacing);
    measured.y.push_back(drawn(speed_that_passes(target)));
    predicted.x.push_back(spacing);
    predicted.y.push_back(drawn(speed_of_barrier(target)));
  }
  chart.series.push_back(measured);
  chart.series.push_back(predicted);
}

/// The speed at which the run of a sphere against a wall of equal spheres stops by itself.
results::ExperimentLimit noticed_limit(const engine::GrainShape& sphere) {
  const Target standard{.shape = sphere, .wall_radius = sphere.sphere_radius};
  const double forbidden = engine::ValidityLimits{}.largest_wall_overlap * sphere.sphere_radius;
  const double noticed = largest_that_holds(
      0.01, 300, 0.02, [&](double speed) { return fly_at(standard, speed).deepest < forbidden; });
  return {"speed at which the validity monitor stops the run (300: at none tried), spacing 1.6 R_w, R_w = R",
          noticed, std::nan(""), "m/s", "ValidityLimits::largest_wall_overlap"};
}

void push_through(const ExperimentOptions& options, results::ExperimentResult& result) {
  results::ExperimentChart chart;
  chart.name = "wall_push_through";
  chart.title = "Impact speed that pushes a grain through a wall of spheres";
  chart.subtitle = "7.63e-8 kg, E = 1e7 Pa, at the middle of four wall spheres, undamped";
  chart.note =
      "Lines without points: elastic energy along the straight path. Curves end where the grain fits through "
      "the hole.";
  chart.x = {.label = "Spacing of the wall spheres over their radius"};
  chart.y = {.label = "Speed [m/s]", .logarithmic = true};
  const auto sphere = thesis_grain(ThesisGrain::sphere), clump = thesis_grain(ThesisGrain::d);
  const double fine = sphere.sphere_radius;
  const std::vector<std::pair<std::string, Target>> cases = {
      {"sphere, R_w = R", {.shape = sphere, .wall_radius = fine}},
      {"wall that moves, R_w = R", {.shape = sphere, .wall_radius = fine, .wall_moves = true}},
      {"sphere, R_w = R / 4", {.shape = sphere, .wall_radius = 0.25 * fine}},
      {"sphere, R_w = 3 R", {.shape = sphere, .wall_radius = 3 * fine}},
      {"model D on an arm, R_w = 1.91 R", {.shape = clump, .wall_radius = 1.5e-4}}};
  for (const auto& [name, base] : cases) {
    add_push_through(name, base, options.quick ? 10 : 19, chart);
    Target standard = base;
    standard.spacing = 1.6;
    result.limits.push_back({"push-through, spacing 1.6 R_w, " + name, speed_that_passes(standard),
                             speed_of_barrier(standard), "m/s", "elastic energy on the way through"});
  }
  result.limits.push_back(noticed_limit(sphere));
  result.charts.push_back(chart);
}

void strike_at_angles(const ExperimentOptions& options, results::ExperimentResult& result) {
  results::ExperimentChart chart;
  chart.name = "wall_angle";
  chart.title = "Push-through speed over the angle of impact";
  chart.subtitle = "Sphere of 7.63e-8 kg, R_w = R, E = 1e7 Pa, aimed at the middle of four wall spheres";
  chart.note = "Lines without points: the normal part of the speed counts, v / cos(angle).";
  chart.x = {.label = "Angle to the normal of the wall [degrees]"};
  chart.y = {.label = "Speed [m/s]", .logarithmic = true};
  for (const double spacing : {1.0, 1.6, 2.0}) {
    const std::string name = "spacing " + std::to_string(spacing).substr(0, 3) + " R_w";
    ExperimentSeries measured{.name = name, .x = {}, .y = {}};
    ExperimentSeries predicted{
        .name = "v / cos, " + name, .role = Role::predicted, .x = {}, .y = {}, .in_legend = false};
    for (const double degrees : linear_range(0, 70, options.quick ? 6 : 15)) {
      Target target{.shape = thesis_grain(ThesisGrain::sphere), .spacing = spacing};
      const double straight = speed_of_barrier(target);
      target.angle = degrees * std::numbers::pi / 180;
      measured.x.push_back(degrees);
      measured.y.push_back(drawn(speed_that_passes(target)));
      predicted.x.push_back(degrees);
      predicted.y.push_back(straight / std::cos(target.angle));
    }
    chart.series.push_back(measured);
    chart.series.push_back(predicted);
  }
  result.charts.push_back(chart);
}

/// Whether a sphere that does not turn stays in its hollow when gravity is tilted by `angle` (rad).
bool stays(const Target& target, double friction, double angle) {
  const double radius = target.shape.sphere_radius, reach = radius + target.wall_radius;
  const double step = target.spacing * target.wall_radius;
  engine::SimulationSettings settings;
  settings.types = {{target.shape}};
  engine::ContactParameters contact = elastic_contact();
  contact.damping = contact.tangential = 1e6 * radius;
  contact.friction = friction;
  settings.contact = bierwisch_contact(contact, contact);
  settings.gravity = engine::kStandardGravity * Eigen::Vector3d(std::sin(angle), 0, -std::cos(angle));
  settings.time_step =
      engine::kDefaultTimeStepFraction *
      engine::critical_time_step(target.shape, engine::laws::bierwisch_law(elastic_contact()), 0.5);
  engine::Simulation simulation(settings, {grid(target)});
  engine::NewGrain grain;
  grain.position.z() = std::sqrt(reach * reach - 0.5 * step * step);
  simulation.add_grains({grain});
  constexpr double kWatched = 0.05;  // s
  while (simulation.time() < kWatched) {
    simulation.step();
    if (simulation.grains().position[0].x() > 0.75 * step) return false;
  }
  return true;
}

/// The tilt at which it slides over the saddle between two wall spheres: tan = s R_w / 2 over the height, and
/// the friction of a wedge.
double tilt_of_geometry(const Target& target, double friction) {
  const double reach = target.shape.sphere_radius + target.wall_radius;
  const double half = 0.5 * target.spacing * target.wall_radius;
  const double slope = std::atan(half / std::sqrt(reach * reach - 2 * half * half));
  return slope + std::atan(friction / std::sqrt(1 - half * half / (reach * reach)));
}

void tilt(const ExperimentOptions& options, results::ExperimentResult& result) {
  constexpr double kDegree = std::numbers::pi / 180;
  results::ExperimentChart chart;
  chart.name = "wall_roughness";
  chart.title = "Roughness of a wall of spheres";
  chart.subtitle = "Tilt at which a non-rotating sphere leaves its hollow along a row, R_w = R";
  chart.note = "Lines without points: saddle between two wall spheres, with the friction of a wedge.";
  chart.x = {.label = "Spacing of the wall spheres over their radius"};
  chart.y = {.label = "Tilt [degrees]"};
  for (const double friction : {0.0, 0.15}) {
    const std::string name = friction > 0 ? "wall friction 0.15" : "no wall friction";
    ExperimentSeries measured{.name = name, .x = {}, .y = {}};
    ExperimentSeries predicted{
        .name = "geometry, " + name, .role = Role::predicted, .x = {}, .y = {}, .in_legend = false};
    for (const double spacing : linear_range(0.4, 2.2, options.quick ? 7 : 13)) {
      Target target{.shape = thesis_grain(ThesisGrain::sphere), .spacing = spacing};
      measured.x.push_back(spacing);
      predicted.x.push_back(spacing);
      predicted.y.push_back(tilt_of_geometry(target, friction) / kDegree);
      measured.y.push_back(largest_that_holds(0.2 * kDegree, 85 * kDegree, 0.01,
                                              [&](double angle) { return stays(target, friction, angle); }) /
                           kDegree);
    }
    chart.series.push_back(measured);
    chart.series.push_back(predicted);
  }
  Target standard{.shape = thesis_grain(ThesisGrain::sphere)};
  result.limits.push_back({"tilt that moves a sphere, spacing 1.6 R_w, R_w = R, wall friction 0.15",
                           largest_that_holds(0.2 * kDegree, 85 * kDegree, 0.01,
                                              [&](double angle) { return stays(standard, 0.15, angle); }) /
                               kDegree,
                           tilt_of_geometry(standard, 0.15) / kDegree, "degrees",
                           "saddle between two wall spheres and friction"});
  result.charts.push_back(chart);
}

}  // namespace

void find_wall_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  push_through(options, result);
  strike_at_angles(options, result);
  tilt(options, result);
}

}  // namespace diefill::process::laboratory
