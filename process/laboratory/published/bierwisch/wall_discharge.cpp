// What friction and spacing of wall spheres change in the discharge of the moving shoe (Bierwisch 2009,
// section 4.2.4, Table 4.10, whose values are not in the tree). The spheres are enlarged with the grains.
#include <map>

#include "process/laboratory/published/bierwisch/slit_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/run_series.h"

namespace diefill::process::laboratory {
namespace {

constexpr const char* kPreset = "ASC100.29 D2";
constexpr double kWallRadius = 1.5e-4;  // m, R_w at the published grain size

std::string name_of(double friction, double spacing) {
  return "mu_w = " + plain(friction) + ", spacing " + plain(spacing) + " R_w";
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
