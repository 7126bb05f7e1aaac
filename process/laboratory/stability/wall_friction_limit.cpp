// Effective friction of walls of spheres: a bed that slides over them, against their spacing.
#include <algorithm>
#include <cmath>
#include <string>

#include "engine/limits/time_step.h"
#include "engine/simulation/simulation.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"
#include "process/laboratory/stability/undamped_bed.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

constexpr double kGrainFriction = 0.5, kWallFriction = 0.15, kSpeed = 0.2;  // kSpeed: m/s, at the start

/// A settled bed and what it is made of, without a floor.
struct SlidingBed {
  engine::SimulationSettings settings;
  std::vector<engine::NewGrain> grains;
};

SlidingBed bed_of(ThesisGrain kind, bool quick) {
  const auto shape = thesis_grain(kind);
  const UndampedBed pile = undamped_bed(shape, kGrainFriction, quick ? 6 : 8, quick ? 6 : 10);
  SlidingBed bed{pile.settings, pile.grains};
  auto& settings = bed.settings;
  engine::ContactParameters grains = pile.contact;
  grains.damping = 1e6 * shape.sphere_radius;
  engine::ContactParameters walls = grains;
  walls.friction = kWallFriction;
  settings.contact = bierwisch_contact(grains, walls);
  settings.time_step = engine::kDefaultTimeStepFraction *
                       engine::critical_time_step(shape, engine::laws::bierwisch_law(grains), 0.5);
  return bed;
}

/// Of the spacings over `radius` (m) with which wall spheres repeat with the bed's period, the one nearest to
/// `spacing`.
double fitting_spacing(const SlidingBed& bed, double radius, double spacing) {
  const double period = *bed.settings.period[0] / radius;
  return period / std::round(period / spacing);
}

/// A floor of spheres whose tops are at z = 0, `spacing` times `radius` (m) apart; a plane for spacing 0.
engine::WallBodySpec floor_of(const SlidingBed& bed, double radius, double spacing) {
  if (spacing <= 0) return floor_plate();
  engine::WallBodySpec body;
  body.name = "floor";
  body.sphere_radius = radius;
  const double period = *bed.settings.period[0], margin = 3 * bed.settings.shape().bounding_radius();
  const double step = spacing * radius;
  const int count = static_cast<int>(std::ceil((0.5 * period + margin) / step));
  for (int y = -count; y <= count; ++y)
    for (int x = -count; x <= count; ++x) body.centres.emplace_back(x * step, y * step, -radius);
  return body;
}

/// Tangential over normal force on the floor, from the momentum that the bed loses until it has half its
/// speed.
double effective_friction(const SlidingBed& bed, double radius, double spacing) {
  engine::Simulation simulation(bed.settings, {floor_of(bed, radius, spacing)});
  auto grains = bed.grains;
  for (auto& grain : grains) grain.velocity.x() = kSpeed;
  simulation.add_grains(grains);
  const auto speed = [&] {
    double sum = 0;
    for (const auto& velocity : simulation.grains().velocity) sum += velocity.x();
    return sum / static_cast<double>(simulation.grains().size());
  };
  const auto steps = static_cast<long>(0.2 / bed.settings.time_step);
  double along = 0, down = 0;
  for (long k = 0; k < steps && speed() > 0.5 * kSpeed; ++k) {
    simulation.step();
    along += simulation.wall_load(0).force.x();
    down -= simulation.wall_load(0).force.z();
  }
  return down > 0 ? along / down : std::nan("");
}

}  // namespace

void find_wall_friction_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  results::ExperimentChart chart;
  chart.name = "wall_friction";
  chart.title = "Effective friction of a floor of wall spheres";
  chart.subtitle = "A bed that slides from 0.2 to 0.1 m/s; wall friction 0.15, among grains 0.5";
  chart.note = "Spheres do not rotate. A plane gives the coefficient itself.";
  chart.x = {.label = "Spacing of the wall spheres over their radius"};
  chart.y = {.label = "Tangential over normal force", .lower = 0};
  const auto spacings = linear_range(0.4, 2.2, options.quick ? 7 : 13);
  struct Case {
    std::string name;
    ThesisGrain kind;
    double wall_radius;  // over the sphere radius
  };
  for (const Case& one : {Case{"spheres, R_w = R", ThesisGrain::sphere, 1},
                          Case{"spheres, R_w = R / 2", ThesisGrain::sphere, 0.5},
                          Case{"model D, R_w = 1.91 R", ThesisGrain::d, 1.91}}) {
    const SlidingBed bed = bed_of(one.kind, options.quick);
    const double radius = one.wall_radius * bed.settings.shape().sphere_radius;
    ExperimentSeries measured{.name = one.name, .x = {}, .y = {}};
    for (const double wanted : spacings) {
      const double spacing = fitting_spacing(bed, radius, wanted);
      if (!measured.x.empty() && measured.x.back() == spacing) continue;
      measured.x.push_back(spacing);
      measured.y.push_back(effective_friction(bed, radius, spacing));
      result.limits.push_back({"effective wall friction, " + one.name + ", spacing " +
                                   std::to_string(spacing).substr(0, 4) + " R_w",
                               measured.y.back(), std::nan(""), "1", ""});
    }
    chart.series.push_back(measured);
    result.limits.push_back({"effective friction of a plane, " + one.name.substr(0, one.name.find(',')),
                             effective_friction(bed, radius, 0), kWallFriction, "1",
                             "the wall's coefficient"});
  }
  ExperimentSeries plane{.name = "coefficient of the wall", .role = Role::predicted, .x = spacings, .y = {}};
  plane.y.assign(spacings.size(), kWallFriction);
  chart.series.push_back(plane);
  result.charts = {chart};
}

}  // namespace diefill::process::laboratory
