// Effective friction of walls of spheres (Bierwisch 2009, section 4.2.4): a frame full of powder D2 under a
// lid is dragged over a plate; force along the motion over force across, of the powder on the plate, over the
// friction coefficient mu_w and the distance of the wall spheres. The source drives lid and blade over a
// period; here the frame's rear wall drives the powder, as a plate with periods cannot move. And what the
// wall changes in the discharge of the moving shoe (Table 4.10, whose values are not in the tree). The
// plate's spheres are enlarged with the grains.
#include <algorithm>
#include <cmath>
#include <map>

#include "process/laboratory/published/bierwisch/slit_scene.h"
#include "process/laboratory/published/dosta/bulk_curves.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/run_series.h"
#include "process/results/figure_table.h"
#include "process/results/none.h"

namespace diefill::process::laboratory {
namespace {

constexpr const char* kPreset = "ASC100.29 D2";
constexpr double kSpacings[] = {0.4, 0.8, 1.6};     // over R_w
constexpr double kFrictions[] = {0.05, 0.25, 0.5};  // mu_w
constexpr double kWallRadius = 1.5e-4;              // m, R_w at the published grain size
constexpr double kLid = 0.031, kStress = 1000;      // m along the motion, Pa
constexpr double kSpeed = 0.2, kLeftOut = 0.4;      // m/s; of the way, before forces are looked at
constexpr double kWay = 0.040;                      // m

std::string name_of(double friction, double spacing) {
  return "mu_w = " + plain(friction) + ", spacing " + plain(spacing) + " R_w";
}

LabRun drag_of(const LabSetting& setting, double friction, double spacing) {
  const LabPowder powder = lab_powder(setting, kPreset, setting.scale());
  const double half = 2.3 * powder.size;
  LabRun run{name_of(friction, spacing), "drag.toml", powder.changes};
  std::string& set = run.changes.set;
  set += line("pour.from", point_in_millimetres(0.0041, -half, 0));
  set += line("pour.to", point_in_millimetres(0.0359, half, 0.044));
  set += line("tool.plate.sphere_radius", millimetres(kWallRadius * powder.size / powder.own_size));
  set += line("tool.plate.spacing", plain(spacing));
  set += line("tool.plate.friction", plain(friction));
  set += line("step.press.force", with_unit(kStress * kLid * 2 * half, "N"));
  set += line("numerics.periodic", "{ y = " + millimetres(2 * half) + " }");
  if (!has_own_powder(setting))
    set += line("numerics.time_step", with_unit(2 * powder.size / powder.own_size, "us"));
  return run;
}

/// Mean force along the motion over mean force across it, after the first part of the way; NaN without load.
double effective_friction(const SeedResults& seed, const std::string& run) {
  const TimeCurve along = probe_curve(seed, run, "plate", "force x"),
                  across = probe_curve(seed, run, "plate", "force z");
  const double start = start_of_motion(seed, run, "shoe");
  double sum_along = 0, sum_across = 0;
  for (std::size_t k = 0; k < along.time.size(); ++k) {
    const double way = kSpeed * (along.time[k] - start);
    if (way < kLeftOut * kWay || way > 0.98 * kWay) continue;
    sum_along += along.value[k];
    sum_across += across.value[k];
  }
  return sum_across != 0 ? std::abs(sum_along / sum_across) : kNone;
}

double slope_over_friction(const SeedResults& seed, double spacing) {
  TimeCurve line;
  for (const double friction : kFrictions) {
    line.time.push_back(friction);
    line.value.push_back(effective_friction(seed, name_of(friction, spacing)));
  }
  return slope_of(line, 0, 1);
}

double mean_over_friction(const SeedResults& seed, double spacing) {
  double sum = 0;
  for (const double friction : kFrictions) sum += effective_friction(seed, name_of(friction, spacing));
  return sum / static_cast<double>(std::size(kFrictions));
}

results::ExperimentChart wall_friction_chart(const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "wall_friction";
  chart.title = "Effective friction of walls of spheres";
  chart.subtitle =
      "Powder D2 under 1 kPa; published: slope of about 1, offset grows with the distance of spheres";
  chart.x = {.label = "Friction coefficient mu_w [1]", .lower = 0};
  chart.y = {.label = "Effective friction [1]", .lower = 0};
  for (const double spacing : kSpacings) {
    std::vector<PointOfRun> points;
    for (const double friction : kFrictions) points.push_back({friction, name_of(friction, spacing)});
    add_run_series(chart, seed, "spacing " + plain(spacing) + " R_w", points,
                   [&](const std::string& run) { return effective_friction(seed, run); });
  }
  return chart;
}

/// Discharge through a slit of 10 mm at 0.18 m/s over walls of this friction and spacing.
LabRun discharge_of(const LabSetting& setting, double friction, double spacing) {
  const LabPowder powder = lab_powder(setting, kPreset, setting.scale());
  const SlitPassage passage{.width = adjusted_slit(0.010, powder), .speed = 0.18};
  LabRun run{name_of(friction, spacing), "slit.toml", slit_changes(setting, powder, passage)};
  run.changes.set += line("walls.sphere_radius", millimetres(kWallRadius * powder.size / powder.own_size));
  run.changes.set += line("walls.spacing", plain(spacing));
  run.changes.set += line("walls.friction", plain(friction));
  return run;
}

results::ExperimentChart wall_discharge_chart(const std::map<double, std::vector<PointOfRun>>& by_spacing,
                                              const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "wall_discharge";
  chart.title = "Discharge over the friction of walls made of spheres";
  chart.subtitle = "By the spacing of the wall spheres; published: no effect";
  chart.x = {.label = "Friction of the walls [-]", .lower = 0};
  chart.y = {.label = "Discharged area [mm2]", .lower = 0};
  for (const auto& [spacing, runs] : by_spacing)
    add_run_series(chart, seed, "spacing " + plain(spacing) + " R_w", runs,
                   [&](const std::string& run) { return 1e6 * discharged_area(seed, run); });
  return chart;
}

}  // namespace

LabPlan plan_wall_friction(const LabSetting& setting) {
  LabPlan plan;
  std::vector<std::string> all;
  for (const double spacing : kSpacings)
    for (const double friction : kFrictions) {
      plan.runs.push_back(drag_of(setting, friction, spacing));
      all.push_back(plan.runs.back().name);
    }
  plan.quantities.push_back(
      {.id = "W01", .quantity = "", .unit = "", .runs = all, .value = [](const SeedResults& seed) {
         double sum = 0;
         for (const double spacing : kSpacings) sum += slope_over_friction(seed, spacing);
         return sum / static_cast<double>(std::size(kSpacings));
       }});
  plan.quantities.push_back(
      {.id = "W02", .quantity = "", .unit = "", .runs = all, .value = [](const SeedResults& seed) {
         const double near = mean_over_friction(seed, 0.4), middle = mean_over_friction(seed, 0.8),
                      far = mean_over_friction(seed, 1.6);
         return std::min(middle - near, far - middle);
       }});
  for (const std::string& run : all)
    plan.quantities.push_back(
        {.id = "effective friction, " + run,
         .quantity = "effective friction, " + run,
         .unit = "1",
         .runs = {run},
         .value = [run](const SeedResults& seed) { return effective_friction(seed, run); }});
  plan.charts = [](const SeedResults& seed) { return std::vector{wall_friction_chart(seed)}; };
  return plan;
}

LabPlan plan_wall_discharge(const LabSetting& setting) {
  LabPlan plan;
  std::map<double, std::vector<PointOfRun>> by_spacing;
  for (const auto& [friction, spacing] : {std::pair(0.15, 0.4), std::pair(0.15, 0.8), std::pair(0.05, 1.6),
                                          std::pair(0.15, 1.6), std::pair(0.25, 1.6)}) {
    plan.runs.push_back(discharge_of(setting, friction, spacing));
    const std::string run = plan.runs.back().name;
    by_spacing[spacing].push_back({friction, run});
    plan.quantities.push_back(
        {.id = "discharged area, " + run,
         .quantity = "discharged area, " + run,
         .unit = "mm^2",
         .runs = {run},
         .value = [run](const SeedResults& seed) { return 1e6 * discharged_area(seed, run); }});
  }
  plan.charts = [by_spacing](const SeedResults& seed) {
    return std::vector{wall_discharge_chart(by_spacing, seed)};
  };
  return plan;
}

}  // namespace diefill::process::laboratory
