// What damping costs: overdamped contacts and shorter steps.
#include <algorithm>
#include <cmath>

#include "engine/limits/time_step.h"
#include "process/laboratory/stability/pair_encounter.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

constexpr double kSpeed = 0.5;  // m/s

engine::SimulationSettings settings_with(double damping_over_radius) {
  engine::SimulationSettings settings;
  settings.shape = thesis_grain(ParticleType::d);
  settings.grain_contact = elastic_contact();
  settings.grain_contact.damping = damping_over_radius * settings.shape.sphere_radius;
  settings.gravity.setZero();
  return settings;
}

/// Largest and smallest restitution over where in a step the contact begins; above 1: the contact gives more
/// than it took.
std::pair<double, double> restitution(engine::SimulationSettings settings, double time_step, double speed) {
  settings.time_step = time_step;
  const auto steps = std::max(
      20L, static_cast<long>(50 * collision_time(settings.shape, settings.grain_contact, speed) / time_step));
  double most = 0, least = 1e9;
  for (int k = 0; k < 8; ++k) {
    const double rebound = meet_head_on(settings, speed, (k + 0.5) / 8, steps).rebound / speed;
    most = std::max(most, rebound);
    least = std::min(least, rebound);
  }
  return {most, least};
}

double step_of_two_percent(const engine::SimulationSettings& settings, double collision) {
  const double exact = restitution(settings, collision / 2000, kSpeed).first;
  return largest_that_holds(1e-4 * collision, collision, 0.03, [&](double time_step) {
    const auto [most, least] = restitution(settings, time_step, kSpeed);
    return most < exact + 0.02 && least > exact - 0.02;
  });
}

double step_of_energy(const engine::SimulationSettings& settings, double collision) {
  return largest_that_holds(1e-4 * collision, 4 * collision, 0.03, [&](double time_step) {
    return restitution(settings, time_step, kSpeed).first <= 1;
  });
}

}  // namespace

void find_damping_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  results::ExperimentChart bounce, step;
  bounce.name = "damping_restitution";
  bounce.title = "Restitution of a head-on collision over damping";
  bounce.subtitle = "Model D of 7.63e-8 kg, R = 78.4 um, E = 1e7 Pa";
  bounce.x = {.label = "Damping over sphere radius [Pa s/m]", .logarithmic = true};
  bounce.y = {.label = "Restitution", .lower = 0, .upper = 1};
  step.name = "damping_time_step";
  step.title = "Time step limit due to damping";
  step.subtitle = "Head-on collision of model D at 0.5 m/s";
  step.note =
      "Theory: 2 m / c and 2 sqrt(m / k) of one contact at the deepest overlap of the undamped impact.";
  step.x = bounce.x;
  step.y = {.label = "Time step [us]", .logarithmic = true};
  const auto range = logarithmic_range(1e4, 1e7, options.quick ? 13 : 25);
  for (const double speed : {0.05, 0.5}) {
    ExperimentSeries curve{.name = speed < 0.1 ? "0.05 m/s" : "0.5 m/s", .x = {}, .y = {}};
    for (const double damping : range) {
      const auto settings = settings_with(damping);
      const double collision = collision_time(settings.shape, settings.grain_contact, speed);
      curve.x.push_back(damping);
      curve.y.push_back(restitution(settings, collision / 1000, speed).first);
    }
    bounce.series.push_back(curve);
  }
  ExperimentSeries exact{.name = "restitution right within 0.02", .x = {}, .y = {}};
  ExperimentSeries gain{.name = "no energy gained", .x = {}, .y = {}};
  ExperimentSeries theory{.name = "critical step of the contact", .role = Role::predicted, .x = {}, .y = {}};
  ExperimentSeries chosen{
      .name = "default: 0.2 of the critical step", .role = Role::predicted, .x = {}, .y = {}};
  for (const double damping : range) {
    const auto settings = settings_with(damping);
    const auto& shape = settings.shape;
    const auto& contact = settings.grain_contact;
    const double collision = collision_time(shape, contact, kSpeed);
    // Head-on, arms in line: nothing turns, so that the grain's whole mass counts.
    engine::GrainShape rigid = shape;
    rigid.rotates = false;
    const double limit =
        engine::critical_time_step_at_overlap(rigid, contact, engine::impact_overlap(shape, contact, kSpeed));
    const double own = engine::kDefaultTimeStepFraction * engine::critical_time_step(shape, contact, kSpeed);
    for (auto* curve : {&exact, &gain, &theory, &chosen}) curve->x.push_back(damping);
    exact.y.push_back(1e6 * step_of_two_percent(settings, collision));
    gain.y.push_back(1e6 * step_of_energy(settings, collision));
    theory.y.push_back(1e6 * limit);
    chosen.y.push_back(1e6 * own);
  }
  const auto last = range.size() - 1;
  result.limits.push_back({"step without energy gained at gamma_n / R = 1e7 Pa s/m", 1e-6 * gain.y[last],
                           1e-6 * theory.y[last], "s", "2 m_eff / c at the deepest overlap"});
  result.limits.push_back({"step with restitution right within 0.02 at gamma_n / R = 1e7 Pa s/m",
                           1e-6 * exact.y[last], 1e-6 * chosen.y[last], "s", "default step"});
  const double soft = largest_that_holds(1e4, 1e8, 0.02, [&](double damping) {
    const auto settings = settings_with(damping);
    return restitution(settings, collision_time(settings.shape, settings.grain_contact, kSpeed) / 1000,
                       kSpeed)
               .first > 0.05;
  });
  result.limits.push_back({"damping over radius from which grains hardly rebound (restitution 0.05, 0.5 m/s)",
                           soft, std::nan(""), "Pa s/m", ""});
  step.series = {exact, gain, theory, chosen};
  result.charts = {bounce, step};
}

}  // namespace diefill::process::laboratory
