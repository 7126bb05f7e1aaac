// Discharge of a silo with a large and a small opening (Dosta et al. 2024, case 1, material M1). The other
// codes start from a packing; here powder is poured and the gate leaves. Coarse and medium sizes have a
// hundredth of the stiffness, which allows ten times the step, and shorter times; the coarse one has 40,000
// grains in place of 100,000.
#include <cmath>

#include "process/laboratory/published/dosta/bulk_curves.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kGrainMass = 8.3775804e-5;  // kg

struct Opening {
  const char* name;  ///< as dosta/curves.csv has it
  int radius;        ///< mm, of the opening
  int lip;           ///< mm below the cylinder
};
constexpr Opening kOpenings[] = {{"large opening", 30, 70}, {"small opening", 20, 80}};

/// What a size computes, and between which times (s) since the gate has left the rate is taken.
struct Window {
  int grains;
  bool soft;
  double from, to, length;
};

Window window_of(LabSize size) {
  if (size == LabSize::coarse) return {40000, true, 0.1, 0.35, 0.35};
  if (size == LabSize::medium) return {100000, true, 0.5, 1.5, 1.5};
  return {100000, false, 0.5, 3.5, 5};
}

LabRun silo_run(const Opening& opening, LabSize size) {
  const Window window = window_of(size);
  LabRun run{opening.name, "silo.toml", {}};
  std::string& set = run.changes.set;
  set += line("tool.silo.file", "\"dosta/silo_" + std::to_string(opening.radius) + ".stl\"");
  set += line("tool.gate.position", point_in_millimetres(0, 0, -1e-3 * opening.lip));
  set += line("probe.lip.origin", point_in_millimetres(0, 0, -1e-3 * opening.lip));
  set += line("pour.fill_height", millimetres(0.2849517e-5 * window.grains));
  set += line("step.discharge.duration", with_unit(window.length, "s"));
  if (!window.soft) return run;
  set += line("numerics.time_step", "\"15 us\"");
  set += line("contact.normal.modulus", "\"5.208333 MPa\"");
  set += line("contact.friction.shear_modulus", "\"1.157407 MPa\"");
  // Steel stays as stiff as it is.
  set += line("contact.walls.normal.modulus", "\"10.4162 MPa\"");
  set += line("contact.walls.friction.shear_modulus", "\"2.31475 MPa\"");
  return run;
}

/// Grains below the lip over the time since the gate began to leave.
TimeCurve discharged(const SeedResults& seed, const Opening& opening) {
  TimeCurve curve = probe_curve(seed, opening.name, "lip", "mass");
  const double start = start_of_motion(seed, opening.name, "gate");
  for (double& time : curve.time) time -= start;
  for (double& value : curve.value) value /= kGrainMass;
  return curve;
}

double rate(const SeedResults& seed, const Opening& opening, const Window& window) {
  return slope_of(discharged(seed, opening), window.from, window.to);
}

results::ExperimentChart silo_chart(const LabSetting& setting, const SeedResults& seed) {
  const Window window = window_of(setting.size);
  results::ExperimentChart chart;
  chart.name = "silo";
  chart.title = "Grains discharged from a silo";
  chart.subtitle = "Spheres of 4 mm, openings of 60 and 40 mm (Dosta et al. 2024)";
  chart.x = {.label = "Time since the opening [s]"};
  chart.y = {.label = "Discharged grains [1000]"};
  for (const Opening& opening : kOpenings) {
    if (!seed.has(opening.name)) continue;
    const auto add = [&](const std::string& who, results::ExperimentSeries::Role role, const TimeCurve& curve,
                         double all, double sign) {
      results::ExperimentSeries series{.name = who + ", " + opening.name, .role = role, .x = {}, .y = {}};
      for (std::size_t k = 0; k < curve.time.size(); ++k) {
        if (curve.time[k] < 0 || curve.time[k] > window.length) continue;
        series.x.push_back(curve.time[k]);
        series.y.push_back(1e-3 * (all + sign * curve.value[k]));
      }
      chart.series.push_back(std::move(series));
    };
    add("diefill", results::ExperimentSeries::Role::predicted, discharged(seed, opening), 0, 1);
    for (const CodeCurve& code : code_curves(setting.scenes, opening.name))
      add(code.code, results::ExperimentSeries::Role::published, code.curve, code.curve.value.front(), -1);
  }
  return chart;
}

}  // namespace

LabPlan plan_silo(const LabSetting& setting) {
  const Opening &large = kOpenings[0], &small = kOpenings[1];
  const Window window = window_of(setting.size);
  LabPlan plan;
  for (const Opening& opening : kOpenings) plan.runs.push_back(silo_run(opening, setting.size));
  plan.quantities.push_back({.id = "DOS-SL",
                             .quantity = "",
                             .unit = "",
                             .runs = {large.name},
                             .value = [=](const SeedResults& seed) { return rate(seed, large, window); }});
  plan.quantities.push_back({.id = "DOS-SS",
                             .quantity = "",
                             .unit = "",
                             .runs = {small.name},
                             .value = [=](const SeedResults& seed) { return rate(seed, small, window); }});
  plan.quantities.push_back({.id = "DOS-SR",
                             .quantity = "",
                             .unit = "",
                             .runs = {large.name, small.name},
                             .value = [=](const SeedResults& seed) {
                               return rate(seed, large, window) / rate(seed, small, window);
                             }});
  plan.charts = [setting](const SeedResults& seed) { return std::vector{silo_chart(setting, seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
