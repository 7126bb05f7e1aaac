// The tests of powder metallurgists on a model powder: apparent density and flow out of a funnel (after ISO
// 3923-1 and ISO 4490), density after vibration (after ISO 3953), angles of repose, wall friction angle,
// discharge of the shoe over its speed. Funnels have the orifices of 5 or 7.5 mm; flow is converted to the
// standard's orifices by Beverloo's law with the width less 1.4 d (Bierwisch 2009, Eq. 5.1 and
// section 3.2.2).
#include <cmath>
#include <limits>
#include <numbers>

#include "process/laboratory/published/bierwisch/repose_scene.h"
#include "process/laboratory/published/bierwisch/slit_scene.h"
#include "process/laboratory/published/bierwisch/wall_shear.h"
#include "process/laboratory/published/experiments.h"
#include "process/measure/figures/heap_slope.h"
#include "process/powder/empty_annulus.h"
#include "process/results/figure_table.h"
#include "process/tradeoff/quantities.h"

namespace diefill::process::laboratory {
namespace {

constexpr const char* kFunnel = "funnel and cup";
constexpr const char* kHeap = "heap";
constexpr const char* kWall = "wall friction";
constexpr const char* kPreset = "Distaloy AE";  // where the user gives no powder
constexpr double kRealGrain = 1e-4;             // m, of the powder that the grains stand for
constexpr double kSpeeds[] = {0.18, 0.4, 0.8};

/// Sizes of funnel and cup for the size of the experiment.
struct Apparatus {
  double scale = 1, orifice = 7.5e-3;  ///< over the standard's lengths; m
};

Apparatus apparatus_of(const LabSetting& setting) {
  if (setting.size == LabSize::coarse) return {0.5, 7.5e-3};
  return {1, setting.size == LabSize::medium ? 7.5e-3 : 5e-3};
}

SceneChanges funnel_changes(const LabSetting& setting, const LabPowder& powder) {
  const Apparatus apparatus = apparatus_of(setting);
  const double s = apparatus.scale, half = 18e-3 * s;
  SceneChanges changes = powder.changes;
  const std::string ending = s < 1 ? "_half" : "";
  changes.set += line("tool.cup.file", "\"cup" + ending + ".stl\"");
  changes.set +=
      line("tool.funnel.file", "\"funnel" + ending + "_" + plain(1e3 * apparatus.orifice) + "mm.stl\"");
  changes.set += line("tool.funnel.position", point_in_millimetres(0, 0, 0.025 * s));
  changes.set += line("tool.gate.position", point_in_millimetres(0, 0, 0.025 * s - 2e-4));
  changes.set += line("pour.from", point_in_millimetres(-half, -half, 0.025 * s + 5e-4));
  changes.set += line("pour.to", point_in_millimetres(half, half, 0.080 * s));
  changes.set += line("pour.fill_height", millimetres(0.024 * s));
  changes.set += line("probe.orifice.origin", point_in_millimetres(0, 0, 0.025 * s - 1.5e-3));
  return changes;
}

/// Columns of the probe at the orifice.
struct Fallen {
  std::vector<double> time, mass;
};

Fallen fallen_of(const results::FillResult& result) {
  Fallen fallen;
  for (const auto& probe : result.probes)
    if (probe.name == "orifice")
      for (std::size_t k = 0; k < probe.values.size(); k += probe.columns.size()) {
        fallen.time.push_back(probe.values[k]);
        fallen.mass.push_back(probe.values[k + 1]);
      }
  return fallen;
}

/// m^3/s of solid out of the funnel, steady part.
double solid_rate(const SeedResults& seed) {
  const auto& result = seed.of(kFunnel);
  const Fallen fallen = fallen_of(result);
  return steady_rate(fallen.time, fallen.mass) / result.powder.grain_mass * result.powder.grain_solid_volume;
}

/// m^3/s of solid through an orifice of the standard: Beverloo's power of 5/2 of the width less 1.4 d.
double rate_through(const SeedResults& seed, double orifice, double model_orifice) {
  const double d = seed.of(kFunnel).powder.grain_diameter;
  const double ratio = (orifice - kEmptyAnnulus * kRealGrain) / (model_orifice - kEmptyAnnulus * d);
  return solid_rate(seed) * std::pow(ratio, 2.5);
}

double fraction_in_cup(const results::FillResult& result) {
  return results::figure_of(result, "solid_fraction_mean");
}

/// kg/m^3 of the metal: that of the preset, or of the grains.
double metal_of(const results::FillResult& result, double solid_density) {
  return solid_density > 0 ? solid_density : result.powder.grain_mass / result.powder.grain_solid_volume;
}

void add(LabPlan& plan, const char* id, const char* quantity, const char* unit, const std::string& run,
         std::function<double(const SeedResults&)> value) {
  plan.quantities.push_back(
      {.id = id, .quantity = quantity, .unit = unit, .runs = {run}, .value = std::move(value)});
}

void add_funnel(const LabSetting& setting, const LabPowder& powder, LabPlan& plan) {
  plan.runs.push_back({kFunnel, "funnel.toml", funnel_changes(setting, powder)});
  const double metal = powder.solid_density, model_orifice = apparatus_of(setting).orifice;
  const auto density = [metal](const results::FillResult& result) {
    return 1e-3 * fraction_in_cup(result) * metal_of(result, metal);
  };
  add(plan, "apparent_fraction", "solid fraction in the cup", "1", kFunnel,
      [](const SeedResults& seed) { return fraction_in_cup(seed.at(kFunnel, "filled")); });
  add(plan, "apparent_density", "apparent density", "g/cm3", kFunnel,
      [density](const SeedResults& seed) { return density(seed.at(kFunnel, "filled")); });
  add(plan, "vibrated_density", "density after 1 s of vibration, 30 Hz, 1 mm", "g/cm3", kFunnel,
      [density](const SeedResults& seed) { return density(seed.of(kFunnel)); });
  add(plan, "hausner", "density after vibration over apparent density", "1", kFunnel,
      [](const SeedResults& seed) {
        return fraction_in_cup(seed.of(kFunnel)) / fraction_in_cup(seed.at(kFunnel, "filled"));
      });
  add(plan, "left_in_funnel", "share of the powder that stays in the funnel", "%", kFunnel,
      [](const SeedResults& seed) {
        const auto& filled = seed.at(kFunnel, "filled");
        const double poured =
            static_cast<double>(filled.powder.position.size()) + results::figure_of(filled, "grains_left");
        const double fell = fallen_of(seed.of(kFunnel)).mass.back() / filled.powder.grain_mass;
        return 100 * (1 - fell / poured);
      });
  for (const double orifice : {2.5e-3, 5e-3}) {
    const bool hall = orifice < 3e-3;
    add(plan, hall ? "hall_flow" : "carney_flow",
        hall ? "time of 50 g through 2.5 mm" : "time of 50 g through 5 mm", "s", kFunnel,
        [=](const SeedResults& seed) {
          const auto& result = seed.of(kFunnel);
          return 0.050 / (rate_through(seed, orifice, model_orifice) * metal_of(result, metal));
        });
  }
}

void add_heap(const LabSetting& setting, LabPlan& plan) {
  plan.runs.push_back({kHeap, "repose.toml", repose_changes(setting, kPreset)});
  add(plan, "repose_slider", "angle of repose, powder left on the slider", "deg", kHeap,
      [](const SeedResults& seed) { return results::figure_of(seed.of(kHeap), heap_figure(kHeapOnSlider)); });
  add(plan, "repose_floor", "angle of repose, heap on the floor", "deg", kHeap,
      [](const SeedResults& seed) { return results::figure_of(seed.of(kHeap), heap_figure(kHeapOnFloor)); });
}

void add_wall(const LabSetting& setting, const LabPowder& powder, LabPlan& plan) {
  const WallShear shear;
  plan.runs.push_back({kWall, "wall_friction.toml", wall_shear_changes(setting, powder, shear)});
  add(plan, "wall_friction_angle", "wall friction angle under 1 kPa, wall spheres as in a die", "deg", kWall,
      [=](const SeedResults& seed) {
        return std::atan(effective_friction(seed, kWall, powder, shear)) * 180 / std::numbers::pi;
      });
}

std::string slit_name(double speed) {
  return "slit of 10 mm, " + plain(speed) + " m/s";
}

void add_slits(const LabSetting& setting, const LabPowder& powder, LabPlan& plan) {
  for (const double speed : kSpeeds) {
    const SlitPassage passage{.width = adjusted_slit(0.010, powder), .speed = speed};
    plan.runs.push_back({slit_name(speed), "slit.toml", slit_changes(setting, powder, passage)});
    const std::string run = slit_name(speed);
    plan.quantities.push_back(
        {.id = "area_" + plain(speed),
         .quantity = "discharged area, slit 10 mm, shoe at " + plain(speed) + " m/s",
         .unit = "mm2",
         .runs = {run},
         .value = [run](const SeedResults& seed) { return 1e6 * discharged_area(seed, run); }});
  }
}

results::ExperimentChart discharge_chart(const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "powder_sheet_discharge";
  chart.title = "Discharge of the shoe through a slit of 10 mm";
  chart.subtitle = "Slit widened by 1.4 (d' - d); line: ASC100.29 as measured (Bierwisch 2009, Eq. 4.1)";
  chart.x = {.label = "Speed of the shoe [m/s]"};
  chart.y = {.label = "Discharged area [mm2]", .logarithmic = true};
  results::ExperimentSeries curve{
      .name = "ASC100.29, measured", .role = results::ExperimentSeries::Role::predicted, .x = {}, .y = {}};
  for (double speed = kSpeeds[0]; speed <= kSpeeds[2] + 1e-9; speed += 0.01) {
    curve.x.push_back(speed);
    curve.y.push_back(1e6 * measured_area(0.010, speed));
  }
  results::ExperimentSeries model{.name = "model powder", .x = {}, .y = {}};
  for (const double speed : kSpeeds)
    if (seed.has(slit_name(speed))) {
      const double area = 1e6 * discharged_area(seed, slit_name(speed));
      model.x.push_back(speed);
      model.y.push_back(area > 0 ? area : std::numeric_limits<double>::quiet_NaN());
    }
  chart.series = {curve, model};
  return chart;
}

}  // namespace

LabPlan plan_powder_sheet(const LabSetting& setting) {
  const LabPowder powder = lab_powder(setting, kPreset, setting.scale());
  LabPlan plan;
  add_funnel(setting, powder, plan);
  add_heap(setting, plan);
  add_wall(setting, powder, plan);
  add_slits(setting, powder, plan);
  plan.charts = [](const SeedResults& seed) { return std::vector{discharge_chart(seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
