// Confined compression of LH100 over the reference overlap delta' that turns Young's modulus into k_1
// (Kottlan 2018, Eq. 3), which is not published: the overlap at which k_unload is the published one, and what
// the other results of the bed are there.
#include <cmath>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/laboratory/published/lactose/pressed_bed.h"
#include "process/laboratory/published/run_series.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kOverlaps[] = {0.0025, 0.01, 0.04};                    // over the radius
constexpr double kPublishedLoading = 1.27, kPublishedUnloading = 2.93;  // MPa, predicted for LH100 (Table 12)

using OfBed = double (*)(const BedMetrics&);

/// A result of the bed.
struct Result {
  const char* name;
  const char* unit;
  OfBed value;
};

constexpr Result kResults[] = {
    {"k_unload", "MPa", [](const BedMetrics& of) { return 1e-6 * of.stiffness.unloading; }},
    {"k_load", "MPa", [](const BedMetrics& of) { return 1e-6 * of.stiffness.loading; }},
    {"beta", "%", [](const BedMetrics& of) { return 100 * of.stiffness.beta; }},
    {"sigma_tens", "kPa", [](const BedMetrics& of) { return 1e-3 * of.strength; }}};

PressedBed bed_with(LabSize size, double overlap) {
  PressedBed bed{"LH100, reference overlap " + plain(overlap), lh100(), pressed_bed_of(size)};
  bed.powder.reference_overlap = overlap;
  return bed;
}

/// Between the first two overlaps that have `wanted` between them, along a line over the logarithm; NaN where
/// none have.
double overlap_at(const SeedResults& seed, LabSize size, const Result& result, double wanted) {
  double before = NAN, smaller = NAN;
  for (const double overlap : kOverlaps) {
    const double value = result.value(metrics_of(seed, bed_with(size, overlap)));
    if ((before - wanted) * (value - wanted) <= 0)
      return smaller * std::pow(overlap / smaller, (wanted - before) / (value - before));
    before = value, smaller = overlap;
  }
  return NAN;
}

std::vector<std::string> run_names(LabSize size) {
  std::vector<std::string> names;
  for (const double overlap : kOverlaps) names.push_back(bed_with(size, overlap).name);
  return names;
}

void add_overlap_at(LabPlan& plan, LabSize size, const Result& result, double wanted) {
  const std::string id = std::string("overlap-") + result.name;
  plan.quantities.push_back(
      {.id = id,
       .quantity = std::string("reference overlap over r at which ") + result.name + " is " + plain(wanted) +
                   ' ' + result.unit,
       .unit = "1",
       .runs = run_names(size),
       .value = [=](const SeedResults& seed) { return overlap_at(seed, size, result, wanted); }});
}

results::ExperimentChart stiffness_chart(const SeedResults& seed, LabSize size) {
  results::ExperimentChart chart;
  chart.name = "reference_overlap";
  chart.title = "Stiffness of a bed of LH100 over the reference overlap";
  chart.subtitle =
      "k_1 = 4/3 Y r sqrt(delta'), periodic bed, spheres of one size; published: Kottlan 2018, Table 12";
  chart.x = {.label = "Reference overlap over the radius [-]", .logarithmic = true};
  chart.y = {.label = "Stiffness [MPa]", .lower = 0};
  std::vector<PointOfRun> points;
  for (const double overlap : kOverlaps) points.push_back({overlap, bed_with(size, overlap).name});
  for (const Result& result : {kResults[0], kResults[1]})
    add_run_series(chart, seed, result.name, points, [&](const std::string& run) {
      for (const double overlap : kOverlaps)
        if (const PressedBed bed = bed_with(size, overlap); bed.name == run)
          return result.value(metrics_of(seed, bed));
      return static_cast<double>(NAN);
    });
  for (const auto& [name, value] : {std::pair{"k_unload, published", kPublishedUnloading},
                                    std::pair{"k_load, published", kPublishedLoading}})
    chart.series.push_back({.name = name,
                            .role = results::ExperimentSeries::Role::published,
                            .x = {std::begin(kOverlaps), std::end(kOverlaps)},
                            .y = std::vector<double>(std::size(kOverlaps), value)});
  return chart;
}

}  // namespace

LabPlan plan_reference_overlap(const LabSetting& setting) {
  const LabSize size = setting.size;
  LabPlan plan;
  for (const double overlap : kOverlaps) {
    const PressedBed bed = bed_with(size, overlap);
    plan.runs.push_back(run_of(bed));
    for (const Result& result : kResults)
      plan.quantities.push_back(
          {.id = std::string(result.name) + ", " + plain(overlap),
           .quantity = std::string(result.name) + ", reference overlap " + plain(overlap) + " r",
           .unit = result.unit,
           .runs = {bed.name},
           .value = [=](const SeedResults& seed) { return result.value(metrics_of(seed, bed)); }});
  }
  add_overlap_at(plan, size, kResults[0], kPublishedUnloading);
  add_overlap_at(plan, size, kResults[1], kPublishedLoading);
  plan.charts = [size](const SeedResults& seed) { return std::vector{stiffness_chart(seed, size)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
