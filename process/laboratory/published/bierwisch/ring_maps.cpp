// Maps of the narrow ring that a comparison of strategies does not hold (Bierwisch 2009, sections 6.3
// and 6.5): two passages at 0.2 m/s against one at 0.09 m/s, and volumetric filling with and without the
// shaking shoe, before the shoe moves off. Coarse: d = 1.88 mm; the other sizes: 0.94 mm.
#include <cmath>
#include <numbers>

#include "process/laboratory/published/bierwisch/ring_motion.h"
#include "process/laboratory/published/bierwisch/ring_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/results/figure_table.h"

namespace diefill::process::laboratory {
namespace {

constexpr const char* kSlow = "one passage at 0.09 m per s";
constexpr const char* kTwo = "two passages at 0.2 m per s";
constexpr const char* kShaken = "volumetric, shoe shaken";
constexpr const char* kStill = "volumetric, shoe at rest";
constexpr const char* kSettled = "settled";  // snapshot of volumetric filling, before the shoe strikes off

/// A millionth of a millimetre stands for no shaking.
LabRun volumetric(const LabSetting& setting, const char* name, const char* amplitude) {
  LabRun run{name, "../narrow_ring/strategies/volumetric.toml", {}};
  run.changes.set = ring_keys(setting, "../") + line("step.2.amplitude", amplitude) +
                    line("step.3.name", "\"settled\"") +
                    "[[snapshot]]\nname = \"settled\"\nwhen = { after = \"settled\" }\n";
  return run;
}

/// Solid fraction at an azimuth, from the mean and the first two harmonics.
double fraction_at(const results::FillResult& result, double degrees) {
  double fraction = results::figure_of(result, "solid_fraction_mean");
  for (int order = 1; order <= 2; ++order) {
    const std::string name = "solid_fraction_harmonic_" + std::to_string(order);
    const double place = results::figure_of(result, name + "_azimuth_deg");
    fraction +=
        results::figure_of(result, name) * std::cos(order * (degrees - place) * std::numbers::pi / 180);
  }
  return fraction;
}

/// m^3, solid volume in the ring under the shoe. The passage that strikes off breaks an arch over the ring.
double volume_under_shoe(const SeedResults& seed, const char* run) {
  return filled_volume(seed.at(run, kSettled).powder);
}

results::ExperimentChart ring_maps_chart(const SeedResults& seed) {
  constexpr double kStep = 10, kTurn = 360;  // deg
  results::ExperimentChart chart;
  chart.name = "ring_maps";
  chart.title = "Solid fraction over the azimuth";
  chart.subtitle = "Mean and first two harmonics; published: two passages densify the far side (180 deg)";
  chart.x = {.label = "Azimuth [deg]", .lower = 0, .upper = kTurn};
  chart.y = {.label = "Solid fraction [-]"};
  for (const char* run : {kSlow, kTwo}) {
    if (!seed.has(run)) continue;
    results::ExperimentSeries series{.name = run, .x = {}, .y = {}};
    for (double azimuth = 0; azimuth <= kTurn; azimuth += kStep) {
      series.x.push_back(azimuth);
      series.y.push_back(fraction_at(seed.of(run), azimuth));
    }
    chart.series.push_back(series);
  }
  return chart;
}

LabQuantity of_one(const char* quantity, const char* unit, const char* run, const char* figure,
                   double scale) {
  return {.id = std::string(figure) + ", " + run,
          .quantity = std::string(quantity) + ", " + run,
          .unit = unit,
          .runs = {run},
          .value = [=](const SeedResults& seed) { return scale * results::figure_of(seed.of(run), figure); }};
}

}  // namespace

std::string ring_keys(const LabSetting& setting, const std::string& tools) {
  const std::string size = setting.size == LabSize::coarse ? "1.88" : "0.94";
  return line("powder.grain_diameter", '"' + size + " mm\"") +
         line("tool.die.file", '"' + tools + "die_d" + size + ".stl\"") +
         line("tool.\"lower punch\".file", '"' + tools + "punch_d" + size + ".stl\"") +
         line("walls.spacing", setting.size == LabSize::coarse ? "2.4" : "1.6");
}

LabRun ring_passages(const LabSetting& setting, const char* name, const char* speed, int count) {
  LabRun run{name, kRingScene, {}};
  run.changes.set =
      ring_keys(setting) + line("step.1.velocity", speed) + line("step.1.passages", std::to_string(count));
  return run;
}

LabPlan plan_ring_maps(const LabSetting& setting) {
  LabPlan plan;
  plan.runs = {ring_passages(setting, kSlow, "\"0.09 m/s\"", 1),
               ring_passages(setting, kTwo, "\"0.2 m/s\"", 2), volumetric(setting, kShaken, "\"1 mm\""),
               volumetric(setting, kStill, "\"0.000001 mm\"")};
  plan.quantities.push_back(
      {.id = "M07", .quantity = "", .unit = "", .runs = {kSlow, kTwo}, .value = [](const SeedResults& seed) {
         constexpr double kFarSide = 180;  // deg, where the shoe leaves
         return fraction_at(seed.of(kTwo), kFarSide) - fraction_at(seed.of(kSlow), kFarSide);
       }});
  plan.quantities.push_back({.id = "M23",
                             .quantity = "",
                             .unit = "",
                             .runs = {kShaken, kStill},
                             .value = [](const SeedResults& seed) {
                               return volume_under_shoe(seed, kStill) / volume_under_shoe(seed, kShaken);
                             }});
  for (const char* run : {kSlow, kTwo, kShaken, kStill}) {
    plan.quantities.push_back(of_one("filled mass", "g", run, "filled_mass_kg", 1e3));
    plan.quantities.push_back(of_one("mean solid fraction", "1", run, "solid_fraction_mean", 1));
  }
  plan.charts = [](const SeedResults& seed) { return std::vector{ring_maps_chart(seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
