// What damping costs: overdamped contacts and shorter steps.
#include <algorithm>
#include <cmath>

#include "engine/limits/time_step.h"
#include "process/laboratory/stability/pair_collision.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

constexpr double kSpeed = 0.5;  // m/s

/// Grains of model D with damping, without gravity.
struct DampedGrains {
  engine::ContactParameters contact = elastic_contact();
  engine::SimulationSettings settings;

  explicit DampedGrains(double damping_over_radius) {
    settings.types = {{thesis_grain(ThesisGrain::d)}};
    contact.damping = damping_over_radius * settings.shape().sphere_radius;
    settings.contact = bierwisch_contact(contact, contact);
    settings.gravity.setZero();
  }
  /// s, of an undamped collision at `speed` (m/s).
  double collision(double speed) const { return collision_time(settings.shape(), contact, speed); }
};

/// Largest and smallest restitution over where in a step the contact begins; above 1: the contact gives more
/// than it took.
std::pair<double, double> restitution(const DampedGrains& grains, double time_step, double speed) {
  engine::SimulationSettings settings = grains.settings;
  settings.time_step = time_step;
  const auto steps = std::max(20L, static_cast<long>(50 * grains.collision(speed) / time_step));
  double most = 0, least = 1e9;
  for (int k = 0; k < 8; ++k) {
    const double rebound = meet_head_on(settings, speed, (k + 0.5) / 8, steps).rebound / speed;
    most = std::max(most, rebound);
    least = std::min(least, rebound);
  }
  return {most, least};
}

double step_of_two_percent(const DampedGrains& grains, double collision) {
  const double exact = restitution(grains, collision / 2000, kSpeed).first;
  return largest_that_holds(1e-4 * collision, collision, 0.03, [&](double time_step) {
    const auto [most, least] = restitution(grains, time_step, kSpeed);
    return most < exact + 0.02 && least > exact - 0.02;
  });
}

double step_of_energy(const DampedGrains& grains, double collision) {
  return largest_that_holds(1e-4 * collision, 4 * collision, 0.03, [&](double time_step) {
    return restitution(grains, time_step, kSpeed).first <= 1;
  });
}

results::ExperimentChart restitution_chart(const std::vector<double>& range) {
  results::ExperimentChart chart;
  chart.name = "damping_restitution";
  chart.title = "Restitution of a head-on collision over damping";
  chart.subtitle = "Model D of 7.63e-8 kg, R = 78.4 um, E = 1e7 Pa";
  chart.x = {.label = "Damping over sphere radius [Pa s/m]", .logarithmic = true};
  chart.y = {.label = "Restitution", .lower = 0, .upper = 1};
  for (const double speed : {0.05, 0.5}) {
    ExperimentSeries curve{.name = speed < 0.1 ? "0.05 m/s" : "0.5 m/s", .x = range, .y = {}};
    for (const double damping : range) {
      const DampedGrains grains(damping);
      curve.y.push_back(restitution(grains, grains.collision(speed) / 1000, speed).first);
    }
    chart.series.push_back(curve);
  }
  return chart;
}

/// Time steps, s.
struct Steps {
  double exact;   // restitution right within 0.02
  double gain;    // no energy gained
  double theory;  // critical step of the contact at the deepest overlap
  double chosen;  // default
};

Steps steps_at(double damping) {
  const DampedGrains grains(damping);
  const auto& shape = grains.settings.shape();
  const auto law = engine::laws::bierwisch_law(grains.contact);
  const double collision = grains.collision(kSpeed);
  // Head-on, arms in line: nothing turns, so that the grain's whole mass counts.
  engine::GrainShape rigid = shape;
  rigid.rotates = false;
  const double overlap = engine::impact_overlap(shape, law, kSpeed);
  return {step_of_two_percent(grains, collision), step_of_energy(grains, collision),
          engine::critical_time_step_at_overlap(rigid, law, overlap),
          engine::kDefaultTimeStepFraction * engine::critical_time_step(shape, law, kSpeed)};
}

results::ExperimentChart step_chart(const std::vector<double>& range, const std::vector<Steps>& steps) {
  results::ExperimentChart chart;
  chart.name = "damping_time_step";
  chart.title = "Time step limit due to damping";
  chart.subtitle = "Head-on collision of model D at 0.5 m/s";
  chart.note =
      "Theory: 2 m / c and 2 sqrt(m / k) of one contact at the deepest overlap of the undamped impact.";
  chart.x = {.label = "Damping over sphere radius [Pa s/m]", .logarithmic = true};
  chart.y = {.label = "Time step [us]", .logarithmic = true};
  const auto add = [&](const char* name, Role role, double Steps::*step) {
    ExperimentSeries curve{.name = name, .role = role, .x = range, .y = {}};
    for (const auto& at : steps) curve.y.push_back(1e6 * at.*step);
    chart.series.push_back(curve);
  };
  add("restitution right within 0.02", Role::measured, &Steps::exact);
  add("no energy gained", Role::measured, &Steps::gain);
  add("critical step of the contact", Role::predicted, &Steps::theory);
  add("default: 0.2 of the critical step", Role::predicted, &Steps::chosen);
  return chart;
}

}  // namespace

void find_damping_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  const auto range = logarithmic_range(1e4, 1e7, options.quick ? 13 : 25);
  std::vector<Steps> steps;
  for (const double damping : range) steps.push_back(steps_at(damping));
  const Steps& last = steps.back();
  result.limits.push_back({"step without energy gained at gamma_n / R = 1e7 Pa s/m", last.gain, last.theory,
                           "s", "2 m_eff / c at the deepest overlap"});
  result.limits.push_back({"step with restitution right within 0.02 at gamma_n / R = 1e7 Pa s/m", last.exact,
                           last.chosen, "s", "default step"});
  const double soft = largest_that_holds(1e4, 1e8, 0.02, [&](double damping) {
    const DampedGrains grains(damping);
    return restitution(grains, grains.collision(kSpeed) / 1000, kSpeed).first > 0.05;
  });
  result.limits.push_back({"damping over radius from which grains hardly rebound (restitution 0.05, 0.5 m/s)",
                           soft, std::nan(""), "Pa s/m", ""});
  result.charts = {restitution_chart(range), step_chart(range, steps)};
}

}  // namespace diefill::process::laboratory
