// The gain at which a force-controlled piston rings on a bed of powder.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "engine/limits/time_step.h"
#include "engine/numerics/out_of_range.h"
#include "engine/simulation/simulation.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"
#include "process/laboratory/stability/undamped_bed.h"
#include "process/machine/force_control.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

constexpr int kStepsAnUpdate = 20;                          // as the schedule of a run looks at its loads
constexpr double kSpeedLimit = 0.02, kIntegralTime = 0.02;  // m/s, s
constexpr double kRinging = 0.1;                            // scatter of the force over the force

/// A settled bed with a flat piston just above it, damped.
struct PistonBed {
  engine::SimulationSettings settings;
  std::vector<engine::NewGrain> grains;
  double top = 0;  ///< m, of the highest sphere

  double area() const { return *settings.period[0] * *settings.period[1]; }
};

PistonBed bed_to_press(bool quick) {
  const auto shape = thesis_grain(ThesisGrain::sphere);
  const UndampedBed pile = undamped_bed(shape, 0, quick ? 5 : 10, quick ? 6 : 12);
  PistonBed bed{pile.settings, pile.grains, 0};
  engine::ContactParameters contact = pile.contact;
  contact.damping = 1e6 * shape.sphere_radius;
  bed.settings.contact = bierwisch_contact(contact, contact);
  bed.settings.time_step = engine::kDefaultTimeStepFraction *
                           engine::critical_time_step(shape, engine::laws::bierwisch_law(contact), 0.5);
  for (const auto& grain : bed.grains) bed.top = std::max(bed.top, grain.position[2] + shape.sphere_radius);
  return bed;
}

engine::WallBodySpec piston_above(double height) {
  engine::WallBodySpec piston;
  piston.name = "piston";
  piston.planes = {{Eigen::Vector3d(0, 0, height), -Eigen::Vector3d::UnitZ()}};
  return piston;
}

/// A bed under a piston that is moved update by update.
class Press {
 public:
  explicit Press(const PistonBed& bed)
      : simulation_(bed.settings, {floor_plate(), piston_above(bed.top)}),
        interval_(kStepsAnUpdate * bed.settings.time_step) {
    simulation_.add_grains(bed.grains);
  }

  double interval() const { return interval_; }
  double now() const { return simulation_.time(); }
  ControlState& state() { return state_; }
  /// N, mean resistance over one update with the state's rate.
  double advance() {
    simulation_.set_motion(1, [state = state_](double time) {
      engine::BodyMotion motion;
      motion.translation = {0, 0, -state.coordinate_at(time)};
      motion.velocity = {0, 0, -state.rate};
      return motion;
    });
    double load = 0;
    for (int step = 0; step < kStepsAnUpdate; ++step) {
      simulation_.step();
      load += simulation_.wall_load(1).force[2] / kStepsAnUpdate;
    }
    return load;
  }
  /// Continues at `rate` (m/s) downwards.
  void set_rate(double rate) {
    state_.coordinate = state_.coordinate_at(now());
    state_.since = now();
    state_.rate = rate;
  }

 private:
  engine::Simulation simulation_;
  double interval_;
  ControlState state_;
};

/// N/m, of the bed when it is let go by a fifth of `target` (N).
double stiffness_at(const PistonBed& bed, double target) {
  constexpr double kSlow = 2e-3;  // m/s
  Press press(bed);
  press.set_rate(kSlow);
  while (press.advance() < target) press.set_rate(kSlow);
  press.set_rate(-kSlow);
  const double first = press.advance();
  double last = first;
  const double from = press.state().coordinate_at(press.now());
  while (last > first - 0.2 * target) last = press.advance();
  return (first - last) / (from - press.state().coordinate_at(press.now()));
}

/// Scatter (N) of the force about its mean over the last quarter of `duration` (s), pressed to `target` (N)
/// with `gain` (as a scene gives it); infinite where grains were ejected.
double scatter(const PistonBed& bed, double target, double gain, double duration) {
  ForceControl control;
  control.axis.direction = -Eigen::Vector3d::UnitZ();
  control.targets = {target};
  control.speed_limit = kSpeedLimit;
  control.gain = gain;
  control.integral_time = kIntegralTime;
  control.travel = 0.5 * bed.top;
  double sum = 0, squares = 0, counted = 0;
  try {
    Press press(bed);
    while (press.now() < duration) {
      const double load = press.advance();
      control.update(press.state(), load, press.now(), press.interval());
      if (press.now() < 0.75 * duration) continue;
      sum += load, squares += load * load, counted += 1;
    }
  } catch (const engine::OutOfRange&) {
    return std::numeric_limits<double>::infinity();
  }
  return std::sqrt(std::max(0.0, squares / counted - sum / counted * (sum / counted)));
}

}  // namespace

void find_piston_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  const PistonBed bed = bed_to_press(options.quick);
  const double duration = options.quick ? 0.1 : 0.2;
  results::ExperimentChart chart;
  chart.name = "piston_gain";
  chart.title = "Gain at which a force-controlled piston oscillates";
  chart.subtitle = "Spheres of 0.3 mm, E~ 10 MPa; speed limit 0.02 m/s, integral time 20 ms";
  chart.note = "Oscillation: the force still varies by a tenth after it should have settled.";
  chart.x = {.label = "Pressure [kPa]", .logarithmic = true};
  chart.y = {.label = "Gain", .logarithmic = true};
  ExperimentSeries measured{.name = "measured", .x = {}, .y = {}};
  ExperimentSeries theory{.name = "2 F / (K v T)", .role = Role::predicted, .x = {}, .y = {}};
  // Up to what such grains are hard enough for (STABILITY.md, stiffness).
  for (const double pressure : logarithmic_range(5e2, 5e3, options.quick ? 3 : 6)) {
    const double target = pressure * bed.area();
    const double limit = largest_that_holds(0.2, 500, 0.15, [&](double gain) {
      return scatter(bed, target, gain, duration) < kRinging * target;
    });
    const double interval = kStepsAnUpdate * bed.settings.time_step;
    for (auto* curve : {&measured, &theory}) curve->x.push_back(1e-3 * pressure);
    measured.y.push_back(limit);
    theory.y.push_back(2 * target / (stiffness_at(bed, target) * kSpeedLimit * interval));
    result.limits.push_back(
        {"piston at " + std::to_string(std::lround(pressure)) + " Pa: gain at which it oscillates", limit,
         theory.y.back(), "1", "2 F / (K v T), K: stiffness of the bed, T: 20 steps"});
  }
  chart.series = {measured, theory};
  result.charts.push_back(chart);
}

}  // namespace diefill::process::laboratory
