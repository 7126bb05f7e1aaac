// What else loosens a bed with rolling resistance: one setting at a time of the bed with EPSD2 and mu_r = 0.8
// (Hu 2024, section 5.2), whose published density the beds of mono_disperse_beds.cpp miss. l = 8 for all
// sizes but the published one, and all spheres come in within 2 s.
#include <functional>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/hu/inserted_bed.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kLow = 0.020, kHigh = 0.060;  // m, of the window

/// One setting that differs.
struct Change {
  const char* name;
  void (*make)(InsertedBed& bed);
};

const std::vector<Change>& changes() {
  static const std::vector<Change> all = {
      {"as published, inserted within 2 s", [](InsertedBed&) {}},
      {"inserted within 10 s", [](InsertedBed& bed) { bed.insertion.time = 10; }},
      {"inserted within 0.5 s", [](InsertedBed& bed) { bed.insertion.time = 0.5; }},
      {"falls of 90 mm less", [](InsertedBed& bed) { bed.insertion.from = 0.150, bed.insertion.to = 0.240; }},
      {"restitution 0.5", [](InsertedBed& bed) { bed.spheres.restitution = 0.5; }},
      {"restitution 0.9", [](InsertedBed& bed) { bed.spheres.restitution = 0.9; }},
      {"rolling spring a tenth", [](InsertedBed& bed) { bed.spheres.rolling_spring = 0.1; }},
      {"rolling spring ten times", [](InsertedBed& bed) { bed.spheres.rolling_spring = 10; }},
      {"6 s at rest", [](InsertedBed& bed) { bed.insertion.rest = 6; }},
      {"F_N as printed in Eq. 2.28", [](InsertedBed& bed) { bed.spheres.load = "printed"; }},
      {"F_N with damping", [](InsertedBed& bed) { bed.spheres.load_rule = "with damping"; }},
      {"F_N of repulsion only", [](InsertedBed& bed) { bed.spheres.load_rule = "repulsive only"; }},
      {"limit of rolling halved", [](InsertedBed& bed) { bed.spheres.rolling_friction *= 0.5; }},
      {"limit of rolling a quarter", [](InsertedBed& bed) { bed.spheres.rolling_friction *= 0.25; }},
      {"method 2", [](InsertedBed& bed) { bed.spheres.method = 2; }},
      {"no rolling resistance", [](InsertedBed& bed) { bed.spheres.rolling = "none"; }},
  };
  return all;
}

InsertedBed bed_of(const Change& change, LabSize size) {
  InsertedBed bed{change.name, {}, {}};
  bed.spheres.enlargement = size == LabSize::published ? 4 : 8;
  bed.spheres.rolling = "EPSD2";
  bed.spheres.rolling_friction = 0.8;
  bed.insertion.time = 2;
  change.make(bed);
  return bed;
}

results::ExperimentChart bed_variants_chart(const SeedResults& seed) {
  using Role = results::ExperimentSeries::Role;
  results::ExperimentChart chart;
  chart.name = "bed_variants";
  chart.title = "Density of a bed with rolling resistance, one setting at a time";
  chart.subtitle = "Over contacts of a sphere; published density 484 kg/m3, its contacts are not known";
  chart.x = {.label = "Coordination number [1]"};
  chart.y = {.label = "Bulk density [kg/m3]"};
  for (const Change& change : changes()) {
    if (!seed.has(change.name)) continue;
    const InsertedBedFigures figures = figures_of(seed, change.name, kLow, kHigh);
    chart.series.push_back(
        {.name = change.name, .role = Role::points, .x = {figures.contacts}, .y = {figures.density}});
  }
  return chart;
}

}  // namespace

LabPlan plan_bed_variants(const LabSetting& setting) {
  LabPlan plan;
  for (const Change& change : changes()) {
    plan.runs.push_back(run_of(bed_of(change, setting.size)));
    for (const auto& [what, unit, figure] :
         {std::tuple("density", "kg/m^3", &InsertedBedFigures::density),
          std::tuple("contacts", "1", &InsertedBedFigures::contacts),
          std::tuple("kinetic energy over m g d", "1", &InsertedBedFigures::kinetic)})
      plan.quantities.push_back(own_figure(change.name, what, unit, kLow, kHigh, figure));
  }
  plan.charts = [](const SeedResults& seed) { return std::vector{bed_variants_chart(seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
