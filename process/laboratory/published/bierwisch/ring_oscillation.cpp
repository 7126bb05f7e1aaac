// What decides whether rotational oscillation at 8 Hz and 5 degrees densifies a filled ring and evens it out
// over the azimuth, as in the source (Bierwisch 2009, section 6.5.2): one setting varied at a time. Coarse: d
// = 1.88 mm; the other sizes: 0.94 mm.
#include <numbers>

#include "engine/simulation/standard_gravity.h"
#include "process/laboratory/published/bierwisch/ring_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/results/figure_table.h"

namespace diefill::process::laboratory {
namespace {

constexpr const char* kFilled = "filled";  // snapshot before the oscillation
constexpr const char* kHarmonic = "solid_fraction_harmonic_1";

struct Variant {
  const char* name;
  const char* set;
  double frequency = 8, amplitude = 5;  ///< Hz, deg
};

constexpr Variant kVariants[] = {
    {"as published", ""},
    {"sudden start", "step.4.ramp = \"1 ms\"\n"},
    {"ramp of 0.25 s", "step.4.ramp = \"0.25 s\"\n"},
    // Walls that rough wedge more grains under the shoe than a run may lose by default.
    {"wall friction 0.5", "walls.friction = 0.5\nnumerics.most_sheared = 0.02\n"},
    {"wall spacing 0.8", "walls.spacing = 0.8\n"},
    {"4 s", "step.4.duration = \"4 s\"\n"},
    {"10 deg", "step.4.amplitude = \"10 deg\"\n", 8, 10},
    {"16 Hz", "step.4.frequency = \"16 Hz\"\n", 16, 5},
    {"32 Hz", "step.4.frequency = \"32 Hz\"\n", 32, 5}};

/// Over g, largest acceleration of the core rod's surface.
double peak_acceleration(const Variant& variant) {
  constexpr double kRadius = 0.008;  // m
  const double rate = 2 * std::numbers::pi * variant.frequency;
  return variant.amplitude * std::numbers::pi / 180 * rate * rate * kRadius / engine::kStandardGravity;
}

LabRun oscillation_run(const LabSetting& setting, const Variant& variant) {
  LabRun run{variant.name, "../narrow_ring/strategies/rotation_after.toml", {}};
  run.changes.under = ring_keys(setting, "../") + line("step.4.frequency", "\"8 Hz\"");
  run.changes.set = line("step.3.name", "\"cleared\"") + variant.set +
                    "[[snapshot]]\nname = \"filled\"\nwhen = { after = \"cleared\" }\n";
  return run;
}

/// A figure at the end less that before the oscillation.
double change_of(const SeedResults& seed, const std::string& run, const char* figure) {
  return results::figure_of(seed.of(run), figure) - results::figure_of(seed.at(run, kFilled), figure);
}

LabQuantity change(const Variant& variant, const char* what, const char* figure) {
  const std::string name = std::string(what) + ", " + variant.name;
  return {.id = name,
          .quantity = name,
          .unit = "1",
          .runs = {variant.name},
          .value = [=](const SeedResults& seed) { return change_of(seed, variant.name, figure); }};
}

results::ExperimentChart ring_oscillation_chart(const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "ring_oscillation";
  chart.title = "Rise of the solid fraction by rotational oscillation";
  chart.subtitle = "8 Hz and 5 deg as published, and with one setting varied at a time";
  chart.x = {.label = "Largest acceleration of the core rod's surface over g [-]", .logarithmic = true};
  chart.y = {.label = "Rise of the mean solid fraction [1]"};
  results::ExperimentSeries rises{
      .name = "here", .role = results::ExperimentSeries::Role::points, .x = {}, .y = {}};
  for (const Variant& variant : kVariants) {
    if (!seed.has(variant.name)) continue;
    rises.x.push_back(peak_acceleration(variant));
    rises.y.push_back(change_of(seed, variant.name, "solid_fraction_mean"));
  }
  if (!rises.x.empty()) chart.series.push_back(rises);
  return chart;
}

}  // namespace

LabPlan plan_ring_oscillation(const LabSetting& setting) {
  LabPlan plan;
  for (const Variant& variant : kVariants) {
    plan.runs.push_back(oscillation_run(setting, variant));
    plan.quantities.push_back(change(variant, "rise of the mean solid fraction", "solid_fraction_mean"));
    plan.quantities.push_back(change(variant, "change of its 1st harmonic over the azimuth", kHarmonic));
  }
  plan.charts = [](const SeedResults& seed) { return std::vector{ring_oscillation_chart(seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
