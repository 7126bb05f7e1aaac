// A rotating drum with two materials, from the published start (Dosta et al. 2024, case 2): how many grains
// of each are in the quarter x < 0, z < 0 over time. The other codes' numbers are not known here. The coarse
// size ends after 0.1 s and takes steps twice as long as the published ones, the medium one ends after 1 s.
#include <cmath>

#include "process/laboratory/published/dosta/bulk_curves.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

constexpr const char* kRun = "drum";
constexpr const char* kMaterials[] = {"M1", "M2"};
constexpr const char* kCoarseStep = "\"1.6 us\"";  // a seventeenth of a collision at 1 m/s

double length_of(LabSize size) {
  if (size == LabSize::coarse) return 0.1;
  return size == LabSize::medium ? 1 : 5;
}

/// Grains of a material in the quarter at the instants that the results keep.
TimeCurve in_quarter(const SeedResults& seed, const std::string& material) {
  const results::FillResult& result = seed.of(kRun);
  TimeCurve curve;
  for (const results::Instant& instant : result.instants) {
    double count = 0;
    for (std::size_t k = 0; k < instant.position.size(); ++k) {
      const std::size_t kind = instant.kind.empty() ? 0 : instant.kind[k];
      if (result.powder.kinds.material[kind] != material) continue;
      if (instant.position[k].x() < 0 && instant.position[k].z() < 0) ++count;
    }
    curve.time.push_back(instant.time);
    curve.value.push_back(count);
  }
  return curve;
}

results::ExperimentChart drum_chart(const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "drum";
  chart.title = "Grains in a quarter of the rotating drum";
  chart.subtitle = "30,000 grains M1 of 2 mm and 8,000 M2 of 4 mm, 2 rad/s (Dosta et al. 2024)";
  chart.x = {.label = "Time [s]"};
  chart.y = {.label = "Grains in x < 0, z < 0"};
  if (!seed.has(kRun)) return chart;
  for (const char* material : kMaterials) {
    const TimeCurve curve = in_quarter(seed, material);
    chart.series.push_back({.name = material, .x = curve.time, .y = curve.value});
  }
  return chart;
}

}  // namespace

LabPlan plan_drum(const LabSetting& setting) {
  const double length = length_of(setting.size);
  LabPlan plan;
  LabRun run{kRun, "drum.toml", {}};
  run.changes.set += line("step.turn.duration", with_unit(length, "s"));
  run.changes.set += line("measure.snapshot_interval", with_unit(length / 50, "s"));
  if (setting.size == LabSize::coarse) run.changes.set += line("numerics.time_step", kCoarseStep);
  plan.runs.push_back(run);
  for (const char* material : kMaterials)
    plan.quantities.push_back(
        {.id = "DOS-D-" + std::string(material),
         .quantity = "grains of " + std::string(material) + " in x < 0, z < 0 after " + plain(length) + " s",
         .unit = "1",
         .runs = {kRun},
         .value = [=](const SeedResults& seed) {
           return value_at(in_quarter(seed, material), length * (1 - 1e-6));
         }});
  plan.charts = [](const SeedResults& seed) { return std::vector{drum_chart(seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
