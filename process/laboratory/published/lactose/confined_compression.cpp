// Confined compression in five cycles and tension of the calibrated lactoses (Kottlan 2018, sections 2.7.2
// and 2.7.3). Beds are periodic in x and y in place of the cylinder, of spheres of one size, and cut flat.
#include <algorithm>
#include <limits>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lactose/pressed_bed.h"

namespace diefill::process::laboratory {
namespace {

struct Lactose {
  std::string id;  ///< of its published figures
  PressedBed bed;
};

std::vector<Lactose> lactoses(LabSize size) {
  const AdhesiveBed bed = pressed_bed_of(size);
  return {{"L100", {"LH100", lh100(), bed}}, {"L220", {"LH220", lh220(), bed}}};
}

using OfBed = double (*)(const BedMetrics&);

LabQuantity quantity(const Lactose& one, const std::string& id, OfBed value, const std::string& unit = {}) {
  return {
      .id = id, .quantity = "", .unit = unit, .runs = {one.bed.name}, .value = [=](const SeedResults& seed) {
        return value(metrics_of(seed, one.bed));
      }};
}

LabQuantity fraction(const Lactose& one, const std::string& when, OfBed value) {
  LabQuantity of = quantity(one, one.bed.name + "-phi-" + when, value, "1");
  of.quantity = one.bed.name + ": solid fraction " + when + " compression";
  return of;
}

/// The smaller one of both powders.
LabQuantity smaller(const std::vector<Lactose>& all, const char* id, OfBed value) {
  LabQuantity of{.id = id, .quantity = "", .unit = "", .runs = {}, .value = [=](const SeedResults& seed) {
                   double least = std::numeric_limits<double>::infinity();
                   for (const Lactose& one : all) least = std::min(least, value(metrics_of(seed, one.bed)));
                   return least;
                 }};
  for (const Lactose& one : all) of.runs.push_back(one.bed.name);
  return of;
}

void add_quantities(LabPlan& plan, const Lactose& one) {
  const std::string id = one.id + "-pred-";
  plan.quantities.push_back(
      quantity(one, id + "beta", [](const BedMetrics& of) { return 100 * of.stiffness.beta; }));
  plan.quantities.push_back(
      quantity(one, id + "k_load", [](const BedMetrics& of) { return 1e-6 * of.stiffness.loading; }));
  plan.quantities.push_back(
      quantity(one, id + "k_unload", [](const BedMetrics& of) { return 1e-6 * of.stiffness.unloading; }));
  plan.quantities.push_back(
      quantity(one, id + "sigma_tens", [](const BedMetrics& of) { return 1e-3 * of.strength; }));
  plan.quantities.push_back(
      fraction(one, "before", [](const BedMetrics& of) { return of.initial_fraction; }));
  plan.quantities.push_back(fraction(one, "after", [](const BedMetrics& of) { return of.final_fraction; }));
}

/// Of LH100: the fraction of the pressed bed over that measured.
LabQuantity looser_than_simulated(const Lactose& one) {
  constexpr double kMeasured = 0.50;  // Table 5
  return {
      .id = "PACK-2",
      .quantity = "",
      .unit = "",
      .runs = {one.bed.name},
      .value = [=](const SeedResults& seed) { return metrics_of(seed, one.bed).final_fraction / kMeasured; }};
}

results::ExperimentSeries empty_series(const Lactose& one) {
  return {.name = one.bed.name, .role = results::ExperimentSeries::Role::predicted, .x = {}, .y = {}};
}

results::ExperimentChart load_chart(const std::vector<Lactose>& all, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "confined_compression";
  chart.title = "Confined compression of lactose in five cycles";
  chart.subtitle = "Periodic beds, spheres of one size, calibrated sets (Kottlan 2018)";
  chart.x = {.label = "Compressive strain from 50 Pa [%]"};
  chart.y = {.label = "Stress on the plate [kPa]"};
  for (const Lactose& one : all) {
    if (!seed.has(one.bed.name)) continue;
    const LoadCurve curve = load_curve(seed, one.bed);
    results::ExperimentSeries series = empty_series(one);
    for (std::size_t k = 0; k < curve.height.size(); ++k) {
      series.x.push_back(100 * (1 - curve.height[k] / curve.height.front()));
      series.y.push_back(1e-3 * curve.stress[k]);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

results::ExperimentChart pull_chart(const std::vector<Lactose>& all, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "tension";
  chart.title = "Tensile test of lactose after compression";
  chart.subtitle = "Plate and floor glued, calibrated sets (Kottlan 2018)";
  chart.x = {.label = "Displacement of the plate [d]"};
  chart.y = {.label = "Tensile stress on the plate [kPa]"};
  for (const Lactose& one : all) {
    if (!seed.has(one.bed.name)) continue;
    const PullCurve curve = pull_curve(seed, one.bed);
    results::ExperimentSeries series = empty_series(one);
    for (std::size_t k = 0; k < curve.travel.size(); ++k) {
      series.x.push_back((curve.travel[k] - curve.travel.front()) / one.bed.powder.diameter());
      series.y.push_back(1e-3 * curve.pull[k] / one.bed.area());
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

}  // namespace

LabPlan plan_confined_compression(const LabSetting& setting) {
  const std::vector<Lactose> all = lactoses(setting.size);
  LabPlan plan;
  for (const Lactose& one : all) {
    plan.runs.push_back(run_of(one.bed));
    add_quantities(plan, one);
  }
  plan.quantities.push_back(smaller(
      all, "SCR-order", [](const BedMetrics& of) { return of.stiffness.unloading / of.stiffness.loading; }));
  plan.quantities.push_back(looser_than_simulated(all.front()));
  plan.quantities.push_back(smaller(all, "SCR-tens2", [](const BedMetrics& of) { return of.fracture; }));
  plan.charts = [all](const SeedResults& seed) {
    return std::vector{load_chart(all, seed), pull_chart(all, seed)};
  };
  return plan;
}

}  // namespace diefill::process::laboratory
