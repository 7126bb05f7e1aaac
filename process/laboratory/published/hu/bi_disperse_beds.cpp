// Beds of two sizes, 0.5 and 1 mm, of equal mass (Hu 2024, section 6.2): density and contacts between 50 and
// 100 mm, and segregation. Coarse: l = 4 compared with l = 8 on a smaller floor, all spheres in within 2 s
// instead of 10 s; medium: l = 2 and 4; published: l = 1 and 4.
#include <algorithm>
#include <cmath>

#include "process/laboratory/published/bed_window.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/hu/inserted_bed.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kLow = 0.050, kHigh = 0.100;  // m, of the window
constexpr double kNarrowest = 4.2;             // largest diameters
constexpr int kSlices = 10;
constexpr const char* kAlone = "small spheres alone";

struct Sizes {
  double reference, enlarged;  ///< l
};

Sizes sizes_of(LabSize size) {
  if (size == LabSize::coarse) return {4, 8};
  return size == LabSize::medium ? Sizes{2, 4} : Sizes{1, 4};
}

std::string name_of(double friction, int method, double enlargement) {
  return "mu_r = " + plain(friction) + ", method " + std::to_string(method) + ", l = " + plain(enlargement);
}

InsertedBed bed_of(const std::string& name, const CohesiveSpheres& spheres, LabSize size) {
  InsertedBed bed{name, spheres, {0.028, 0.026, 0.240, 0.520, 59.6e-3, 10, 2}};
  if (size != LabSize::coarse) return bed;
  bed.insertion = of_width(bed.insertion, kNarrowest * 1e-3 * spheres.enlargement);
  bed.insertion.time = 2;
  return bed;
}

/// Eight small spheres weigh as much as a large one.
CohesiveSpheres mixture(double friction, int method, double enlargement) {
  CohesiveSpheres spheres;
  spheres.sizes = {{5e-4, 8}, {1e-3, 1}};
  spheres.enlargement = enlargement;
  spheres.method = method;
  spheres.rolling = friction > 0 ? "EPSD2" : "none";
  spheres.rolling_friction = friction;
  return spheres;
}

double density(const SeedResults& seed, const std::string& run) {
  return figures_of(seed, run, kLow, kHigh).density;
}

/// Largest difference of a slice's share of small spheres from a half, over the lowest 100 mm.
double segregation(const SeedResults& seed, const std::string& run) {
  double largest = 0;
  for (const double share : small_share_by_slice(seed.at(run, "bed").powder, 0, kHigh, kSlices))
    largest = std::fmax(largest, std::abs(share - 0.5));
  return largest;
}

results::ExperimentChart bi_disperse_beds_chart(const Sizes& sizes, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "bi_disperse_shares";
  chart.title = "Share of small spheres over the height of the bed";
  chart.subtitle = "Two sizes of equal mass, ten slices (Hu 2024, section 6.2); published: no segregation";
  chart.x = {.label = "Height [mm]"};
  chart.y = {.label = "Mass share of small spheres [1]", .lower = 0, .upper = 1};
  for (const double friction : {0.0, 0.8}) {
    const std::string run = name_of(friction, 1, sizes.reference);
    if (!seed.has(run)) continue;
    results::ExperimentSeries series{.name = run, .x = {}, .y = {}};
    series.y = small_share_by_slice(seed.at(run, "bed").powder, 0, kHigh, kSlices);
    for (int slice = 0; slice < kSlices; ++slice) series.x.push_back(1e3 * kHigh * (slice + 0.5) / kSlices);
    chart.series.push_back(series);
  }
  return chart;
}

void add_quantities(const Sizes& sizes, LabPlan& plan) {
  const std::string smooth = name_of(0, 1, sizes.reference), rough = name_of(0.8, 1, sizes.reference),
                    enlarged = name_of(0, 1, sizes.enlarged);
  plan.quantities.push_back({.id = "BI-M1",
                             .quantity = "deviation at mu_r = 0, l = " + plain(sizes.enlarged) +
                                         " from l = " + plain(sizes.reference),
                             .unit = "",
                             .runs = {smooth, enlarged},
                             .value = [=](const SeedResults& seed) {
                               return percent_apart(density(seed, enlarged), density(seed, smooth));
                             }});
  plan.quantities.push_back(
      {.id = "BI-mono",
       .quantity = "",
       .unit = "",
       .runs = {smooth, kAlone},
       .value = [=](const SeedResults& seed) { return density(seed, smooth) / density(seed, kAlone); }});
  plan.quantities.push_back({.id = "BI-seg",
                             .quantity = "",
                             .unit = "",
                             .runs = {smooth, rough},
                             .value = [=](const SeedResults& seed) {
                               return std::max(segregation(seed, smooth), segregation(seed, rough));
                             }});
}

}  // namespace

LabPlan plan_bi_disperse_beds(const LabSetting& setting) {
  const Sizes sizes = sizes_of(setting.size);
  LabPlan plan;
  const auto add = [&](const std::string& name, const CohesiveSpheres& spheres) {
    plan.runs.push_back(run_of(bed_of(name, spheres, setting.size)));
  };
  for (const double friction : {0.0, 0.8})
    add(name_of(friction, 1, sizes.reference), mixture(friction, 1, sizes.reference));
  add(name_of(0, 1, sizes.enlarged), mixture(0, 1, sizes.enlarged));
  CohesiveSpheres alone;
  alone.enlargement = sizes.reference;
  add(kAlone, alone);
  add_quantities(sizes, plan);
  for (const LabRun& run : plan.runs) {
    plan.quantities.push_back(
        own_figure(run.name, "density", "kg/m^3", kLow, kHigh, &InsertedBedFigures::density));
    plan.quantities.push_back(
        own_figure(run.name, "contacts", "1", kLow, kHigh, &InsertedBedFigures::contacts));
  }
  plan.charts = [sizes](const SeedResults& seed) { return std::vector{bi_disperse_beds_chart(sizes, seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
