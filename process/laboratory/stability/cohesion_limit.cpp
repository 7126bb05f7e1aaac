// Cohesion opens at zero overlap with an infinite slope (Bierwisch 2009, Eq. 2.4): what step resolves it, and
// what chatter remains in contacts that should be at rest.
#include <cmath>
#include <numbers>

#include "engine/laws/contact_law.h"
#include "engine/observe/energy_balance.h"
#include "engine/simulation/simulation.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

/// Two spheres that hold each other, and the well they lie in.
struct BoundPair {
  engine::ContactParameters contact = elastic_contact();
  engine::SimulationSettings settings;
  double rest = 0;      // m, overlap without force: k h^(3/2) = c h^(3/4)
  double depth = 0;     // J, of the well
  double period = 0;    // s, of small oscillations
  double critical = 0;  // s, 2 / eigenfrequency at rest: slope 3/4 k sqrt(h) there
};

BoundPair bound_pair(double work_of_adhesion) {
  BoundPair pair;
  auto& settings = pair.settings;
  settings.types = {{thesis_grain(ThesisGrain::sphere)}};
  pair.contact.work_of_adhesion = work_of_adhesion;
  settings.contact = bierwisch_contact(pair.contact, pair.contact);
  settings.gravity.setZero();
  const double radius = 0.5 * settings.shape().sphere_radius;
  const engine::laws::Hertz hertz(1e7, radius);
  const engine::laws::HertzianCohesion cohesion(work_of_adhesion, 1e7, radius);
  pair.rest = std::pow(cohesion.coefficient / hertz.coefficient, 4.0 / 3.0);
  pair.depth = -(hertz.energy(pair.rest) + cohesion.energy(pair.rest));
  const double slope = 0.75 * hertz.coefficient * std::sqrt(pair.rest);
  const double frequency = std::sqrt(slope / (0.5 * settings.shape().mass));
  pair.period = 2 * std::numbers::pi / frequency;
  pair.critical = 2 / frequency;
  return pair;
}

/// Spheres at `overlap` (m) with closing speed `speed` (m/s).
engine::Simulation started(engine::SimulationSettings settings, double time_step, double overlap,
                           double speed) {
  settings.time_step = time_step;
  engine::Simulation simulation(settings, {});
  engine::NewGrain left, right;
  right.position.x() = settings.shape().sphere_radius - 0.5 * overlap;
  left.position = -right.position;
  left.velocity.x() = 0.5 * speed;
  right.velocity = -left.velocity;
  simulation.add_grains({left, right});
  return simulation;
}

/// Whether a pair that has hardly touched, undamped, keeps its energy to within a tenth of the well's depth
/// for `periods` oscillations, which take it to the edge of the well every time.
bool keeps_its_energy(const BoundPair& pair, double time_step, double periods) {
  auto simulation = started(pair.settings, time_step, 1e-3 * pair.rest, 0);
  const double before = engine::energy_of(simulation).total();
  const auto steps = std::lround(periods * pair.period / time_step);
  for (long k = 0; k < steps; ++k) {
    simulation.step();
    if (engine::energy_of(simulation).total() - before > 0.1 * pair.depth) return false;
  }
  return true;
}

/// m/s, rms speed that remains between damped spheres after the time in which damping leaves nothing.
double chatter(const BoundPair& pair, double time_step) {
  engine::SimulationSettings settings = pair.settings;
  engine::ContactParameters damped = pair.contact;
  damped.damping = 1e6 * settings.shape().sphere_radius;
  settings.contact = bierwisch_contact(damped, damped);
  auto simulation = started(settings, time_step, 0.5 * pair.rest, 0);
  const auto steps = std::lround(200 * pair.period / time_step);
  for (long k = 0; k < steps; ++k) simulation.step();
  double sum = 0;
  for (long k = 0; k < 100; ++k) {
    simulation.step();
    sum += (simulation.grains().velocity[1] - simulation.grains().velocity[0]).squaredNorm();
  }
  return std::sqrt(sum / 100);
}

double oscillations(const ExperimentOptions& options) {
  return options.quick ? 100 : 1000;
}

double step_that_keeps_energy(const BoundPair& pair, double periods) {
  return largest_that_holds(1e-3 * pair.critical, 4 * pair.critical, 0.03,
                            [&](double time_step) { return keeps_its_energy(pair, time_step, periods); });
}

results::ExperimentChart step_chart(const ExperimentOptions& options) {
  results::ExperimentChart chart;
  chart.name = "cohesion_time_step";
  chart.title = "Time step that resolves cohesion near zero overlap";
  chart.subtitle = "Two undamped cohesive spheres near zero overlap; a tenth of the well depth allowed";
  chart.x = {.label = "Work of adhesion [J/m2]", .logarithmic = true};
  chart.y = {.label = "Time step [us]", .logarithmic = true};
  const double periods = oscillations(options);
  ExperimentSeries measured{
      .name = "energy kept through " + std::to_string(std::lround(periods)) + " oscillations",
      .x = {},
      .y = {}};
  ExperimentSeries theory{
      .name = "2 / eigenfrequency at the resting overlap", .role = Role::predicted, .x = {}, .y = {}};
  for (const double work : logarithmic_range(1e-5, 0.3, options.quick ? 10 : 20)) {
    const auto pair = bound_pair(work);
    measured.x.push_back(work);
    measured.y.push_back(1e6 * step_that_keeps_energy(pair, periods));
    theory.x.push_back(work);
    theory.y.push_back(1e6 * pair.critical);
  }
  chart.series = {measured, theory};
  return chart;
}

results::ExperimentChart chatter_chart(const ExperimentOptions& options) {
  results::ExperimentChart chart;
  chart.name = "cohesion_chatter";
  chart.title = "Residual speed in a damped cohesive contact";
  chart.subtitle = "After 200 oscillations, gamma_n / R = 1e6 Pa s/m";
  chart.x = {.label = "Time step over 2 / eigenfrequency at rest", .logarithmic = true};
  chart.y = {.label = "Relative speed, rms [m/s]", .logarithmic = true, .lower = 1e-15};
  for (const double work : {1e-4, 1e-2}) {
    ExperimentSeries curve{.name = work < 1e-3 ? "w = 1e-4 J/m2" : "w = 0.01 J/m2", .x = {}, .y = {}};
    const auto pair = bound_pair(work);
    for (const double over : logarithmic_range(0.02, 2, options.quick ? 12 : 24)) {
      curve.x.push_back(over);
      curve.y.push_back(std::max(1e-15, chatter(pair, over * pair.critical)));
    }
    chart.series.push_back(curve);
  }
  return chart;
}

}  // namespace

void find_cohesion_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  const auto pair = bound_pair(0.01);
  result.limits.push_back({"cohesive pair, w = 0.01 J/m2: step that keeps its energy",
                           step_that_keeps_energy(pair, oscillations(options)), pair.critical, "s",
                           "2 / eigenfrequency at the resting overlap"});
  result.limits.push_back(
      {"cohesive pair, w = 0.01 J/m2: step without chatter",
       largest_that_holds(1e-2 * pair.critical, 4 * pair.critical, 0.03,
                          [&](double time_step) { return chatter(pair, time_step) < 1e-9; }),
       pair.critical, "s", "2 / eigenfrequency at the resting overlap"});
  result.charts = {step_chart(options), chatter_chart(options)};
}

}  // namespace diefill::process::laboratory
