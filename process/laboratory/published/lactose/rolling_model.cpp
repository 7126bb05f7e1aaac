// Whether Luding's rolling spring shakes a bed where it is large enough to matter (Kottlan 2018,
// section 2.2.4): packed beds of LH100 without rolling resistance, with that spring and with the elastic
// torque of the calibrated set. Kinetic energies are those at the end of the fall. Coarse: beds 6 d wide and
// 10 d deep; the other sizes: 10 d and 20 d.
#include "process/laboratory/published/bed_window.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lactose/pressed_bed.h"
#include "process/laboratory/published/run_series.h"

namespace diefill::process::laboratory {
namespace {

struct Rolling {
  const char *name, *law;
  double friction;
};

constexpr Rolling kSmooth = {"no rolling resistance", "elastic CDT", 0},
                  kSmall = {"Luding, mu_r = 0.1", "Luding", 0.1}, kLarge = {"Luding, mu_r = 1", "Luding", 1},
                  kTorque = {"elastic CDT, mu_r = 1", "elastic CDT", 1};

LabRun rolling_model_run(const LabSetting& setting, const Rolling& rolling) {
  const AdhesiveBed bed = setting.size == LabSize::coarse ? AdhesiveBed{6, 10} : AdhesiveBed{10, 20};
  AdhesivePowder powder = lh100();
  powder.rolling_law = rolling.law;
  powder.rolling = rolling.friction;
  return {rolling.name, "adhesive_bed.toml", {packed_bed_lines(powder, bed) + unpressed_lines(), {}}};
}

double fraction(const SeedResults& seed, const Rolling& rolling) {
  return middle_fraction(packed_bed(seed, rolling.name));
}

double kinetic(const SeedResults& seed, const Rolling& rolling) {
  return kinetic_energy_over_weight(packed_bed(seed, rolling.name));
}

results::ExperimentChart rolling_model_chart(const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "rolling_model";
  chart.title = "Kinetic energy of packed beds over rolling friction";
  chart.subtitle = "Published: the rolling spring shakes the bed where it is large enough to matter";
  chart.x = {.label = "Rolling friction mu_r [-]", .lower = 0};
  chart.y = {.label = "Kinetic energy over m g d [-]", .logarithmic = true};
  const auto energy = [&](const std::string& run) {
    return kinetic_energy_over_weight(packed_bed(seed, run));
  };
  add_run_series(
      chart, seed, "rolling spring (Luding)",
      {{kSmooth.friction, kSmooth.name}, {kSmall.friction, kSmall.name}, {kLarge.friction, kLarge.name}},
      energy);
  add_run_series(chart, seed, "elastic torque",
                 {{kSmooth.friction, kSmooth.name}, {kTorque.friction, kTorque.name}}, energy);
  return chart;
}

}  // namespace

LabPlan plan_rolling_model(const LabSetting& setting) {
  LabPlan plan;
  for (const Rolling& rolling : {kSmooth, kSmall, kLarge, kTorque}) {
    plan.runs.push_back(rolling_model_run(setting, rolling));
    const auto add = [&](const std::string& what, double (*value)(const SeedResults&, const Rolling&)) {
      plan.quantities.push_back({.id = what + ", " + rolling.name,
                                 .quantity = what + ", " + rolling.name,
                                 .unit = "1",
                                 .runs = {rolling.name},
                                 .value = [=](const SeedResults& seed) { return value(seed, rolling); }});
    };
    add("solid fraction", fraction);
    add("kinetic energy over m g d", kinetic);
  }
  plan.quantities.push_back(
      {.id = "ROLL-1",
       .quantity = "",
       .unit = "",
       .runs = {kSmooth.name, kLarge.name},
       .value = [](const SeedResults& seed) { return kinetic(seed, kLarge) / kinetic(seed, kSmooth); }});
  plan.charts = [](const SeedResults& seed) { return std::vector{rolling_model_chart(seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
