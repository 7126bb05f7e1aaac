// Laws with a kink or a steep slope: the step that Luding's unloading spring needs, and that of van der Waals
// attraction with its smallest gap.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "process/laboratory/stability/pair_collision.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;
namespace laws = engine::laws;

engine::SimulationSettings with_law(const laws::LawParameters& law) {
  engine::SimulationSettings settings;
  const auto sphere = thesis_grain(ThesisGrain::sphere);
  settings.types = {{engine::model_b(sphere.sphere_radius, sphere.mass)}};
  settings.gravity.setZero();
  laws::LawParameters walls = law;
  walls.attraction = {};
  settings.contact = engine::one_powder(law, walls);
  return settings;
}

/// Largest difference of the speed of rebound from `exact` (m/s) over where in a step the contact begins,
/// over the speed of impact.
double rebound_error(engine::SimulationSettings settings, double time_step, double speed, double duration,
                     double range, double exact) {
  settings.time_step = time_step;
  const auto steps = std::max(50L, std::lround(duration / time_step));
  double largest = 0;
  for (int k = 0; k < 8; ++k)
    largest = std::max(
        largest,
        std::abs(meet_head_on(settings, speed, (k + 0.5) / 8, steps, range).rebound - exact) / speed);
  return largest;
}

constexpr double kLudingLoading = 100, kLudingSpeed = 0.2;  // N/m, m/s

/// kg, of two spheres of the thesis.
double pair_mass() {
  return 0.5 * thesis_grain(ThesisGrain::sphere).mass;
}

/// k_2 is `ratio` times k_1.
laws::LudingNormal::Parameters luding_spring(double ratio) {
  return {.loading = kLudingLoading, .unloading = ratio * kLudingLoading, .plasticity_depth = 1e-4};
}

/// s, 2 sqrt(m_eff / k_2).
double luding_step_predicted(double ratio) {
  const double radius = thesis_grain(ThesisGrain::sphere).sphere_radius, mass = pair_mass();
  const laws::LudingNormal spring(luding_spring(ratio), {radius, radius, 2 * mass, 2 * mass});
  return 2 * std::sqrt(mass / spring.stiffness(0, nullptr));
}

/// s, the largest step whose rebound is within 0.05 of the impact speed of that of a fine one.
double luding_step_found(double ratio) {
  const auto settings = with_law({.normal = luding_spring(ratio)});
  const double period = std::numbers::pi * std::sqrt(pair_mass() / kLudingLoading);
  const double fine = 1e-3 * 2 * std::sqrt(pair_mass() / (ratio * kLudingLoading));
  auto exact_settings = settings;
  exact_settings.time_step = fine;
  const double exact =
      meet_head_on(exact_settings, kLudingSpeed, 0.5, std::lround(4 * period / fine)).rebound;
  return largest_that_holds(fine, 4 * period, 0.03, [&](double time_step) {
    return rebound_error(settings, time_step, kLudingSpeed, 4 * period, 0, exact) < 0.05;
  });
}

void luding(const ExperimentOptions& options, results::ExperimentResult& result) {
  results::ExperimentChart chart;
  chart.name = "luding_time_step";
  chart.title = "Time step that Luding's unloading spring needs";
  chart.subtitle = "k_1 = 100 N/m, plasticity depth 1e-4, 0.2 m/s: the contact unloads along k_2";
  chart.note =
      "Rebound correct within 0.05 of the impact speed. Walls 30 times as stiff: the same at 30 k_2.";
  chart.x = {.label = "k_2 over k_1", .logarithmic = true};
  chart.y = {.label = "Time step [us]", .logarithmic = true};
  ExperimentSeries measured{.name = "rebound right within 0.05", .x = {}, .y = {}};
  ExperimentSeries theory{.name = "2 sqrt(m_eff / k_2)", .role = Role::predicted, .x = {}, .y = {}};
  ExperimentSeries loading{.name = "2 sqrt(m_eff / k_1)", .role = Role::predicted, .x = {}, .y = {}};
  for (const double ratio : logarithmic_range(1.2, 600, options.quick ? 8 : 16)) {
    for (auto* curve : {&measured, &theory, &loading}) curve->x.push_back(ratio);
    measured.y.push_back(1e6 * luding_step_found(ratio));
    theory.y.push_back(1e6 * luding_step_predicted(ratio));
    loading.y.push_back(2e6 * std::sqrt(pair_mass() / kLudingLoading));
  }
  result.limits.push_back({"Luding, k_2 / k_1 = 20: step with rebound right within 0.05",
                           luding_step_found(20), luding_step_predicted(20), "s", "2 sqrt(m_eff / k_2)"});
  chart.series = {measured, theory, loading};
  result.charts.push_back(chart);
}

/// m/s, speed just above that at which attraction of `well` (J) would hold the pair.
double speed_above(double well) {
  return 1.5 * std::sqrt(2 * well / pair_mass());
}

/// Steps at which a pair still flies apart as fast as it came, within 0.05, against the smallest gap.
void van_der_waals(const ExperimentOptions& options, results::ExperimentResult& result) {
  constexpr double kHamaker = 5e-18, kLargestGap = 1e-6;  // J, m (Kottlan 2018)
  constexpr double kContactStep = 1e-5;                   // s, beyond it the contact itself is not resolved
  results::ExperimentChart chart;
  chart.name = "van_der_waals_time_step";
  chart.title = "Time step that van der Waals attraction needs";
  chart.subtitle = "Hamaker constant 5e-18 J, largest gap 1 um; 1.5 times the speed that escapes the well";
  chart.note = "Not tested above 10 us, where the contact itself is not resolved.";
  chart.x = {.label = "Smallest gap [nm]", .logarithmic = true};
  chart.y = {.label = "Time step [us]", .logarithmic = true};
  ExperimentSeries measured{.name = "rebound right within 0.05", .x = {}, .y = {}};
  ExperimentSeries theory{.name = "smallest gap over speed", .role = Role::predicted, .x = {}, .y = {}};
  const double radius = thesis_grain(ThesisGrain::sphere).sphere_radius;
  for (const double gap : logarithmic_range(1e-9, 2e-8, options.quick ? 7 : 13)) {
    const laws::VanDerWaals::Parameters attraction{
        .hamaker = kHamaker, .smallest_gap = gap, .largest_gap = kLargestGap};
    const auto settings =
        with_law({.normal = laws::HertzMindlinNormal::Parameters{.modulus = 5e6}, .attraction = attraction});
    const double well = -laws::VanDerWaals(attraction, {radius, radius}).energy(gap, nullptr);
    const double speed = speed_above(well), passing = gap / speed;
    const double duration = 40 * kLargestGap / speed + 4e-4;
    const auto limit = largest_that_holds(0.05 * passing, kContactStep, 0.05, [&](double time_step) {
      return rebound_error(settings, time_step, speed, duration, 1.01 * kLargestGap, speed) < 0.05;
    });
    for (auto* curve : {&measured, &theory}) curve->x.push_back(1e9 * gap);
    measured.y.push_back(1e6 * limit);
    theory.y.push_back(1e6 * passing);
  }
  result.limits.push_back({"van der Waals, smallest gap 1 nm: step with rebound right within 0.05",
                           1e-6 * measured.y.front(), 1e-6 * theory.y.front(), "s",
                           "smallest gap over speed"});
  chart.series = {measured, theory};
  result.charts.push_back(chart);
}

}  // namespace

void find_attraction_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  luding(options, result);
  van_der_waals(options, result);
}

}  // namespace diefill::process::laboratory
