// Effective friction of walls of spheres (Bierwisch 2009, section 4.2.4): powder D2 under a lid with a blade
// on a plate, periodic in x and y; force along the plate over the force across it, over the friction
// coefficient mu_w and the distance of the wall spheres. Seen from the lid: the plate moves. Force across is
// that on the plate, powder included; that which the lid is pressed with alone is a row of its own. Load and
// speed are 1 kPa and 0.5 m/s but for two runs. Coarse and medium: d = 0.94 mm, plate spheres twice as large;
// published: 0.47 mm.
#include <algorithm>
#include <cmath>
#include <map>

#include "process/laboratory/published/bierwisch/wall_shear.h"
#include "process/laboratory/published/dosta/bulk_curves.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/run_series.h"

namespace diefill::process::laboratory {
namespace {

constexpr const char* kPreset = "ASC100.29 D2";
constexpr double kSpacings[] = {0.4, 0.8, 1.6};     // over R_w
constexpr double kFrictions[] = {0.01, 0.25, 0.5};  // mu_w

/// One point: a wall and how it is sheared.
struct Sheared {
  double friction, spacing;
  WallShear shear = {};
};

/// The same wall under the other published load and at the other speed.
constexpr Sheared kOthers[] = {{0.25, 1.6, {.stress = 5000}}, {0.25, 1.6, {.speed = 0.1}}};

std::string name_of(const Sheared& one) {
  const WallShear usual;
  std::string name = "mu_w = " + plain(one.friction) + ", spacing " + plain(one.spacing) + " R_w";
  if (one.shear.stress != usual.stress) name += ", " + plain(1e-3 * one.shear.stress) + " kPa";
  if (one.shear.speed != usual.speed) name += ", " + plain(one.shear.speed) + " m/s";
  return name;
}

LabPowder powder_of(const LabSetting& setting) {
  return lab_powder(setting, kPreset, setting.size == LabSize::published ? 1 : 2);
}

LabRun shear_run(const LabSetting& setting, const LabPowder& powder, const Sheared& one) {
  LabRun run{name_of(one), "wall_friction.toml", wall_shear_changes(setting, powder, one.shear)};
  run.changes.set += line("tool.plate.spacing", plain(one.spacing));
  run.changes.set += line("tool.plate.friction", plain(one.friction));
  if (setting.size == LabSize::published) run.changes.set += line("tool.lid.file", "\"lid_4.5mm.stl\"");
  return run;
}

double friction_at(const SeedResults& seed, const LabPowder& powder, const Sheared& one) {
  return effective_friction(seed, name_of(one), powder, one.shear);
}

double friction_by_imposed_load(const SeedResults& seed, const LabPowder& powder, const Sheared& one) {
  return wall_forces(seed, name_of(one), powder, one.shear).along / imposed_load(powder, one.shear);
}

double slope_over_friction(const SeedResults& seed, const LabPowder& powder, double spacing) {
  TimeCurve line;
  for (const double friction : kFrictions) {
    line.time.push_back(friction);
    line.value.push_back(friction_at(seed, powder, {friction, spacing}));
  }
  return slope_of(line, 0, 1);
}

double mean_over_friction(const SeedResults& seed, const LabPowder& powder, double spacing) {
  double sum = 0;
  for (const double friction : kFrictions) sum += friction_at(seed, powder, {friction, spacing});
  return sum / static_cast<double>(std::size(kFrictions));
}

double mean_slope(const SeedResults& seed, const LabPowder& powder) {
  double sum = 0;
  for (const double spacing : kSpacings) sum += slope_over_friction(seed, powder, spacing);
  return sum / static_cast<double>(std::size(kSpacings));
}

double smallest_rise(const SeedResults& seed, const LabPowder& powder) {
  const auto mean = [&](std::size_t k) { return mean_over_friction(seed, powder, kSpacings[k]); };
  return std::min(mean(1) - mean(0), mean(2) - mean(1));
}

results::ExperimentChart wall_friction_chart(const LabPowder& powder, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "wall_friction";
  chart.title = "Effective friction of walls of spheres";
  chart.subtitle =
      "Powder D2 under 1 kPa, 0.5 m/s; published: slope of about 1, offset grows with the distance of "
      "spheres";
  chart.x = {.label = "Friction coefficient mu_w [1]", .lower = 0};
  chart.y = {.label = "Effective friction [1]", .lower = 0};
  for (const double spacing : kSpacings) {
    std::vector<PointOfRun> points;
    std::map<std::string, Sheared> walls;
    for (const double friction : kFrictions) {
      points.push_back({friction, name_of({friction, spacing})});
      walls[points.back().run] = {friction, spacing};
    }
    add_run_series(chart, seed, "spacing " + plain(spacing) + " R_w", points,
                   [&](const std::string& run) { return friction_at(seed, powder, walls.at(run)); });
  }
  return chart;
}

/// The run and both of its frictions as rows.
void add_point(const LabSetting& setting, const LabPowder& powder, const Sheared& one, LabPlan& plan) {
  plan.runs.push_back(shear_run(setting, powder, one));
  const std::string run = plan.runs.back().name;
  const auto add = [&](const std::string& what,
                       double (*value)(const SeedResults&, const LabPowder&, const Sheared&)) {
    plan.quantities.push_back({.id = what + ", " + run,
                               .quantity = what + ", " + run,
                               .unit = "1",
                               .runs = {run},
                               .value = [=](const SeedResults& seed) { return value(seed, powder, one); }});
  };
  add("effective friction", friction_at);
  add("effective friction by the imposed load", friction_by_imposed_load);
}

}  // namespace

LabPlan plan_wall_friction(const LabSetting& setting) {
  const LabPowder powder = powder_of(setting);
  LabPlan plan;
  std::vector<std::string> all;
  for (const double spacing : kSpacings)
    for (const double friction : kFrictions) {
      add_point(setting, powder, {friction, spacing}, plan);
      all.push_back(plan.runs.back().name);
    }
  for (const Sheared& one : kOthers) add_point(setting, powder, one, plan);
  const auto add = [&](const char* id, double (*value)(const SeedResults&, const LabPowder&)) {
    plan.quantities.push_back(
        {.id = id, .quantity = "", .unit = "", .runs = all, .value = [=](const SeedResults& seed) {
           return value(seed, powder);
         }});
  };
  add("W01", mean_slope);
  add("W02", smallest_rise);
  plan.charts = [powder](const SeedResults& seed) { return std::vector{wall_friction_chart(powder, seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
