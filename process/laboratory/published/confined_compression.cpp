// Confined compression of adhesive beds in five cycles between 0.5 and 15 kPa (Kottlan 2018, section 2.7.2):
// compressibility, stiffness on loading and unloading, final solid fraction. Beds are periodic in x and y in
// place of the cylinder and are not cut: the initial height is that of the plate at 50 Pa. Coarse: 8 d wide,
// 15 d of powder; medium: 10 d and 20 d; published: 16 d and 20 d.
#include <algorithm>
#include <cmath>
#include <limits>

#include "process/laboratory/published/adhesive_bed.h"
#include "process/laboratory/published/bulk_curves.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/laboratory/published/load_cycles.h"

namespace diefill::process::laboratory {
namespace {

constexpr LoadCycle kLoads;
constexpr double kTouch = 50, kRest = 100;  // Pa
constexpr const char* kPacked = "packed";

struct Powder {
  const char *name, *id;
  AdhesivePowder parameters;
};

std::vector<Powder> powders() {
  return {{"LH100", "L100", lh100()}, {"LH220", "L220", lh220()}};
}

AdhesiveBed bed_of(LabSize size) {
  if (size == LabSize::coarse) return {8, 15};
  return size == LabSize::medium ? AdhesiveBed{10, 20} : AdhesiveBed{16, 20};
}

LabRun run_of(const Powder& powder, LabSize size) {
  Loads loads;
  loads.stresses = {kLoads.high};
  for (int k = 0; k < kLoads.cycles; ++k)
    loads.stresses.insert(loads.stresses.end(), {kLoads.low, kLoads.high});
  loads.stresses.push_back(kRest);
  return {powder.name, "adhesive_bed.toml", {pressed_bed_lines(powder.parameters, bed_of(size), loads), {}}};
}

LoadCurve curve_of(const SeedResults& seed, const Powder& powder, LabSize size) {
  const double d = powder.parameters.diameter(), width = bed_of(size).width * d;
  const double start = plate_height(bed_of(size)) * d;
  const TimeCurve force = probe_curve(seed, powder.name, "plate", "force z"),
                  shift = probe_curve(seed, powder.name, "plate", "shift z");
  const double lowered = start_of_motion(seed, powder.name, "plate");
  LoadCurve curve;
  for (std::size_t k = 0; k < force.value.size(); ++k) {
    const double stress = force.value[k] / (width * width);
    // Flying spheres hit the plate, too, before it moves.
    if (force.time[k] < lowered || (curve.stress.empty() && stress < kTouch)) continue;
    curve.height.push_back(start + shift.value[k]);
    curve.stress.push_back(stress);
  }
  return curve;
}

results::ExperimentChart chart_of(const LabSetting& setting, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "confined_compression";
  chart.title = "Confined compression of lactose in five cycles";
  chart.subtitle = "Periodic beds, spheres of one size, calibrated sets (Kottlan 2018)";
  chart.x = {.label = "Height over that at 50 Pa, decrease [%]"};
  chart.y = {.label = "Stress on the plate [kPa]"};
  for (const Powder& powder : powders()) {
    if (!seed.has(powder.name)) continue;
    const LoadCurve curve = curve_of(seed, powder, setting.size);
    results::ExperimentSeries series{
        .name = powder.name, .role = results::ExperimentSeries::Role::predicted, .x = {}, .y = {}};
    for (std::size_t k = 0; k < curve.height.size(); ++k) {
      series.x.push_back(100 * (1 - curve.height[k] / curve.height.front()));
      series.y.push_back(1e-3 * curve.stress[k]);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

using OfStiffness = double (*)(const Stiffness&);

LabQuantity stiffness_quantity(const Powder& powder, const std::string& id, LabSize size, OfStiffness value) {
  return {.id = id, .quantity = "", .unit = "", .runs = {powder.name}, .value = [=](const SeedResults& seed) {
            return value(stiffness_of(curve_of(seed, powder, size), kLoads));
          }};
}

/// Of the bed's middle six tenths.
double middle_fraction(const results::PowderState& powder) {
  const double top = surface_of(powder);
  return fraction_between(powder, 0.2 * top, 0.8 * top);
}

void add_fractions(LabPlan& plan, const Powder& powder) {
  const std::string run = powder.name;
  plan.quantities.push_back(
      {.id = run + "-phi_initial",
       .quantity = run + ": solid fraction before compression",
       .unit = "1",
       .runs = {run},
       .value = [run](const SeedResults& seed) { return middle_fraction(seed.at(run, kPacked).powder); }});
  plan.quantities.push_back(
      {.id = run + "-phi_final",
       .quantity = run + ": solid fraction after compression",
       .unit = "1",
       .runs = {run},
       .value = [run](const SeedResults& seed) { return middle_fraction(seed.of(run).powder); }});
}

}  // namespace

LabPlan plan_confined_compression(const LabSetting& setting) {
  LabPlan plan;
  for (const Powder& powder : powders()) {
    plan.runs.push_back(run_of(powder, setting.size));
    const std::string id = std::string(powder.id) + "-pred-";
    plan.quantities.push_back(stiffness_quantity(powder, id + "beta", setting.size,
                                                 [](const Stiffness& of) { return 100 * of.beta; }));
    plan.quantities.push_back(stiffness_quantity(powder, id + "k_load", setting.size,
                                                 [](const Stiffness& of) { return 1e-6 * of.loading; }));
    plan.quantities.push_back(stiffness_quantity(powder, id + "k_unload", setting.size,
                                                 [](const Stiffness& of) { return 1e-6 * of.unloading; }));
    add_fractions(plan, powder);
  }
  plan.quantities.push_back({.id = "SCR-order",
                             .quantity = "",
                             .unit = "",
                             .runs = {"LH100", "LH220"},
                             .value = [size = setting.size](const SeedResults& seed) {
                               double least = std::numeric_limits<double>::infinity();
                               for (const Powder& powder : powders()) {
                                 const Stiffness of = stiffness_of(curve_of(seed, powder, size), kLoads);
                                 least = std::min(least, of.unloading / of.loading);
                               }
                               return least;
                             }});
  plan.charts = [setting](const std::vector<SeedResults>& seeds) {
    return std::vector{chart_of(setting, seeds.front())};
  };
  return plan;
}

}  // namespace diefill::process::laboratory
