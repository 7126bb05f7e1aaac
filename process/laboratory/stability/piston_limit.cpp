// The gain at which a force-controlled piston rings on a bed of powder.
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "engine/time_step.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/settled_pile.h"
#include "process/machine/force_control.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

constexpr int kStepsAnUpdate = 20;                          // as the schedule of a run looks at its loads
constexpr double kSpeedLimit = 0.02, kIntegralTime = 0.02;  // m/s, s
constexpr double kRinging = 0.1;                            // scatter of the force over the force

/// A settled bed with a flat piston just above it, damped.
struct PressedBed {
  engine::SimulationSettings settings;
  std::vector<engine::NewGrain> grains;
  double top = 0;  ///< m, of the highest sphere

  double area() const { return *settings.period[0] * *settings.period[1]; }
};

PressedBed bed_to_press(bool quick) {
  const auto shape = thesis_grain(GrainKind::sphere);
  const SettledPile pile = settled_pile(shape, 0, quick ? 6 : 10, quick ? 8 : 12);
  PressedBed bed{pile.settings, pile.grains, 0};
  bed.settings.grain_contact.damping = bed.settings.wall_contact.damping = 1e6 * shape.sphere_radius;
  bed.settings.time_step =
      engine::kDefaultTimeStepFraction * engine::critical_time_step(shape, bed.settings.grain_contact, 0.5);
  for (const auto& grain : bed.grains) bed.top = std::max(bed.top, grain.position[2] + shape.sphere_radius);
  return bed;
}

engine::WallBodySpec piston_above(double height) {
  engine::WallBodySpec piston;
  piston.name = "piston";
  piston.planes = {{Eigen::Vector3d(0, 0, height), -Eigen::Vector3d::UnitZ()}};
  return piston;
}

/// Mean and scatter of a force, N, and the mean way, m, over the last third of a run.
struct Pressing {
  double force = 0, scatter = 0, way = 0;
};

/// Presses with `target` (N) and `gain` (as a scene gives it) for `duration` (s).
Pressing press(const PressedBed& bed, double target, double gain, double duration) {
  engine::Simulation simulation(bed.settings, {floor_plate(), piston_above(bed.top)});
  simulation.add_grains(bed.grains);
  ForceControl control;
  control.axis.direction = -Eigen::Vector3d::UnitZ();
  control.target = target;
  control.speed_limit = kSpeedLimit;
  control.gain = gain * kSpeedLimit / target;
  control.integral_time = kIntegralTime;
  control.travel = 0.5 * bed.top;
  ControlState state;
  const long updates = std::lround(duration / (kStepsAnUpdate * bed.settings.time_step));
  double sum = 0, squares = 0, ways = 0, counted = 0;
  for (long update = 0; update < updates; ++update) {
    simulation.set_motion(1, [state](double time) {
      engine::BodyMotion motion;
      motion.translation = {0, 0, -state.coordinate_at(time)};
      motion.velocity = {0, 0, -state.rate};
      return motion;
    });
    double load = 0;
    for (int step = 0; step < kStepsAnUpdate; ++step) {
      simulation.step();
      load += simulation.wall_load(1).force[2] / kStepsAnUpdate;
    }
    const double interval = kStepsAnUpdate * bed.settings.time_step;
    control.update(state, load, simulation.time(), interval);
    if (3 * update < 2 * updates) continue;
    sum += load, squares += load * load, ways += state.coordinate, counted += 1;
  }
  const double mean = sum / counted;
  return {mean, std::sqrt(std::max(0.0, squares / counted - mean * mean)), ways / counted};
}

}  // namespace

void find_piston_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  const PressedBed bed = bed_to_press(options.quick);
  const double duration = options.quick ? 0.06 : 0.15;
  const double interval = kStepsAnUpdate * bed.settings.time_step;
  results::ExperimentChart chart;
  chart.name = "piston_gain";
  chart.title = "Gain at which a force-controlled piston rings";
  chart.subtitle = "Spheres of 0.3 mm, E~ 10 MPa; speed limit 0.02 m/s, integral time 20 ms";
  chart.note = "Ringing: the force scatters by a tenth of itself after it should have come to rest.";
  chart.x = {.label = "Pressure [kPa]", .logarithmic = true};
  chart.y = {.label = "Gain", .logarithmic = true};
  ExperimentSeries measured{.name = "measured", .x = {}, .y = {}};
  ExperimentSeries theory{.name = "2 F / (K v T)", .role = Role::predicted, .x = {}, .y = {}};
  for (const double pressure : logarithmic_range(1e3, 3e4, options.quick ? 3 : 6)) {
    const double target = pressure * bed.area();
    const double limit = largest_that_holds(0.05, 500, 0.1, [&](double gain) {
      return press(bed, target, gain, duration).scatter < kRinging * target;
    });
    // Stiffness of the bed at that load, N/m, from two loads at a gain that is sure to be quiet.
    const auto less = press(bed, 0.9 * target, 0.05, 4 * duration),
               more = press(bed, 1.1 * target, 0.05, 4 * duration);
    const double stiffness = (more.force - less.force) / (more.way - less.way);
    for (auto* curve : {&measured, &theory}) curve->x.push_back(1e-3 * pressure);
    measured.y.push_back(limit);
    theory.y.push_back(2 * target / (stiffness * kSpeedLimit * interval));
    result.limits.push_back(
        {"piston at " + std::to_string(std::lround(1e-3 * pressure)) + " kPa: gain at which it rings", limit,
         theory.y.back(), "", "2 F / (K v T), K: stiffness of the bed, T: 20 steps"});
  }
  chart.series = {measured, theory};
  result.charts.push_back(chart);
}

}  // namespace diefill::process::laboratory
