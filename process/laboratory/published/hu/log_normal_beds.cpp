// Beds of log-normal sizes at two surface energies (Hu 2024, section 6.3): density and contacts between 20
// and 60 mm over the width of the distribution. Sizes are kept from the 1st to the 99.9th percentile by
// number [assumed: not published]. The periods are as small as the largest spheres allow. Coarse: l = 4,
// compared with l = 2 where spheres are equal; medium: l = 2 and 4; published: l = 1, 2 and 4. Enlargement of
// the widest sizes at the weaker attraction is an experiment of its own: coarse: l = 8 from l = 4 and from l
// = 2; the other sizes: l = 2 and 4 from l = 1; sizes up to the 99th percentile, coming in below 0.52 m,
// looked at 0.7 s after they came in.
#include <algorithm>
#include <cmath>

#include "engine/powder/size_classes.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/hu/inserted_bed.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/laboratory/published/run_series.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kLow = 0.020, kHigh = 0.060;  // m, of the window
constexpr double kMean = 1e-3;                 // m, original
constexpr double kMin = 0.01, kMax = 0.999;    // percentiles kept
constexpr std::size_t kClasses = 24;
constexpr double kNarrowest = 5.6, kOfLargest = 4.02;  // mean and largest diameters
/// Of the comparison of enlarged spheres of the widest sizes: the largest percentile kept, and m, below which
/// spheres come in. With those above, small spheres are pressed into each other between large ones that fall
/// a metre beyond what the method allows (0.78 R at l = 8).
constexpr double kMaxCompared = 0.99, kHighest = 0.52;
/// s after spheres came in, twice the longest fall; share of the critical step: 0.14 of Rayleigh's time,
/// where the source takes 0.15.
constexpr double kRestCompared = 0.7, kStepCompared = 0.2;
constexpr double kStrong = 0.2, kWeak = 0.02;  // J/m^2

/// One bed.
struct Case {
  double variation, surface_energy, enlargement;
};

std::string name_of(const Case& one) {
  return "s_d over m_d = " + plain(one.variation) + ", " + plain(one.surface_energy) +
         " J per m2, l = " + plain(one.enlargement);
}

std::vector<SphereClass> classes_of(double variation, double most) {
  if (variation == 0) return {{kMean, 1}};
  using Sizes = engine::SizeDistribution;
  const auto whole = Sizes::log_normal_of_mean(kMean, variation * kMean);
  const auto kept = Sizes::log_normal_of_mean(
      kMean, variation * kMean,
      {whole.quantile(kMin, engine::SizeBasis::number), whole.quantile(most, engine::SizeBasis::number)});
  std::vector<SphereClass> classes;
  for (const auto& one : engine::size_classes(kept, kClasses))
    classes.push_back({one.diameter, one.number_share});
  return classes;
}

InsertedBed bed_of(const Case& one, double most = kMax) {
  const double l = one.enlargement;
  InsertedBed bed{name_of(one), {}, {0.056 * l, 0.052 * l, 0.025, 1.015, 0.18 * l * l, 0, 1.05}};
  bed.spheres.enlargement = l;
  bed.spheres.surface_energy = one.surface_energy;
  bed.spheres.sizes = classes_of(one.variation, most);
  bed.insertion =
      of_width(bed.insertion, std::max(kNarrowest * kMean * l, kOfLargest * largest_diameter(bed.spheres)));
  return bed;
}

/// Widths of the distribution. Coarse: the widest one, which takes longest, with the stronger attraction
/// alone.
std::vector<double> variations(LabSize size, double surface_energy) {
  if (size == LabSize::published) return {0, 0.2, 0.4, 0.6, 0.8};
  if (size == LabSize::coarse && surface_energy < kStrong) return {0, 0.4};
  return {0, 0.4, 0.8};
}

/// l of the beds over all widths, and what they are compared with.
double finest(LabSize size) {
  return size == LabSize::coarse ? 4 : size == LabSize::medium ? 2 : 1;
}

std::vector<Case> cases_of(LabSize size) {
  std::vector<Case> cases;
  for (const double energy : {kStrong, kWeak})
    for (const double variation : variations(size, energy))
      cases.push_back({variation, energy, finest(size)});
  for (const double energy : {kStrong, kWeak}) {
    cases.push_back({0, energy, size == LabSize::medium ? 4.0 : 2.0});
    if (size == LabSize::published) cases.push_back({0, energy, 4});
  }
  // The widest ones, which take longest, come last.
  std::stable_sort(cases.begin(), cases.end(),
                   [](const Case& one, const Case& other) { return one.variation < other.variation; });
  return cases;
}

InsertedBedFigures figures(const SeedResults& seed, const Case& one) {
  return figures_of(seed, name_of(one), kLow, kHigh);
}

LabQuantity quantity(const std::string& id, const std::string& label, const std::vector<Case>& cases,
                     const std::function<double(const SeedResults&)>& value) {
  LabQuantity quantity{.id = id, .quantity = label, .unit = "", .runs = {}, .value = value};
  for (const Case& one : cases) quantity.runs.push_back(name_of(one));
  return quantity;
}

/// Of beds in the order of rising width: whether density rises, or contacts fall, step for step.
double share_of_steps(const SeedResults& seed, const std::vector<Case>& cases) {
  double right = 0, all = 0;
  for (std::size_t k = 1; k < cases.size(); ++k) {
    if (cases[k].variation <= cases[k - 1].variation) continue;
    const InsertedBedFigures before = figures(seed, cases[k - 1]), after = figures(seed, cases[k]);
    right += (after.density > before.density ? 0.5 : 0) + (after.contacts < before.contacts ? 0.5 : 0);
    ++all;
  }
  return right / all;
}

/// Share of widths at which the stronger attraction gives less density and fewer contacts.
double loosened_by_attraction(const SeedResults& seed, LabSize size) {
  const auto widths = variations(size, kWeak);
  double right = 0;
  for (const double variation : widths) {
    const InsertedBedFigures strong = figures(seed, {variation, kStrong, finest(size)}),
                             weak = figures(seed, {variation, kWeak, finest(size)});
    right += (strong.density < weak.density ? 0.5 : 0) + (strong.contacts < weak.contacts ? 0.5 : 0);
  }
  return right / static_cast<double>(widths.size());
}

void add_values(LabSize size, LabPlan& plan) {
  const double l = finest(size);
  const auto add = [&](const char* id, const Case& one, double InsertedBedFigures::*figure) {
    plan.quantities.push_back(
        quantity(id, "", {one}, [=](const SeedResults& seed) { return figures(seed, one).*figure; }));
  };
  add("LN-02-rho-0", {0, kStrong, l}, &InsertedBedFigures::density);
  add("LN-02-rho-80", {0.8, kStrong, l}, &InsertedBedFigures::density);
  add("LN-02-z-0", {0, kStrong, l}, &InsertedBedFigures::contacts);
  add("LN-02-z-80", {0.8, kStrong, l}, &InsertedBedFigures::contacts);
}

void add_scaling(LabSize size, LabPlan& plan) {
  const Case one{0, kStrong, 2}, other{0, kStrong, 4}, weak_one{0, kWeak, 2}, weak_other{0, kWeak, 4};
  plan.quantities.push_back(quantity("LN-02-M1", "", {one, other}, [=](const SeedResults& seed) {
    const InsertedBedFigures fine = figures(seed, one), coarse = figures(seed, other);
    return std::max(percent_apart(coarse.density, fine.density),
                    std::abs(coarse.contacts - fine.contacts) / 0.08);
  }));
  const Case original = size == LabSize::published ? Case{0, kWeak, 1} : weak_one;
  plan.quantities.push_back(
      quantity("LN-002-M1rho", "deviation, equal spheres, l = 4 from l = " + plain(original.enlargement),
               {original, weak_other}, [=](const SeedResults& seed) {
                 return percent_apart(figures(seed, weak_other).density, figures(seed, original).density);
               }));
}

void add_trends(LabSize size, LabPlan& plan) {
  std::vector<Case> all, both;
  for (const double energy : {kStrong, kWeak}) {
    for (const double variation : variations(size, energy)) all.push_back({variation, energy, finest(size)});
    for (const double variation : variations(size, kWeak)) both.push_back({variation, energy, finest(size)});
  }
  plan.quantities.push_back(quantity(
      "LN-gamma", "", both, [size](const SeedResults& seed) { return loosened_by_attraction(seed, size); }));
  plan.quantities.push_back(
      quantity("LN-trend", "", all, [all](const SeedResults& seed) { return share_of_steps(seed, all); }));
}

results::ExperimentChart log_normal_beds_chart(LabSize size, const SeedResults& seed, bool contacts) {
  using Role = results::ExperimentSeries::Role;
  results::ExperimentChart chart;
  chart.name = contacts ? "log_normal_contacts" : "log_normal_density";
  chart.title = contacts ? "Contacts of a sphere over the width of the distribution"
                         : "Bulk density over the width of the distribution";
  chart.subtitle = "Spheres of 1 mm in the mean times l, 20 to 60 mm above the floor (Hu 2024, section 6.3)";
  chart.x = {.label = "Standard deviation of the diameter over its mean [1]"};
  chart.y = {.label = contacts ? "Coordination number [1]" : "Bulk density [kg/m3]"};
  for (const double energy : {kStrong, kWeak}) {
    std::vector<PointOfRun> points;
    for (const double variation : variations(size, energy))
      points.push_back({variation, name_of({variation, energy, finest(size)})});
    add_run_series(chart, seed, plain(energy) + " J/m2, l = " + plain(finest(size)), points,
                   [&](const std::string& run) {
                     const InsertedBedFigures bed = figures_of(seed, run, kLow, kHigh);
                     return contacts ? bed.contacts : bed.density;
                   });
  }
  chart.series.push_back({.name = "published, 0.2 J/m2, l = 1",
                          .role = Role::published,
                          .x = {0, 0.8},
                          .y = contacts ? std::vector<double>{4.82, 4.38} : std::vector<double>{573, 625}});
  return chart;
}

/// How far contacts of the widest sizes are from those of less enlarged spheres.
LabQuantity contacts_apart(const char* id, double l, double original) {
  const Case enlarged{0.8, kWeak, l}, reference{0.8, kWeak, original};
  return quantity(id, "deviation of coordination number, l = " + plain(l) + " from l = " + plain(original),
                  {enlarged, reference}, [=](const SeedResults& seed) {
                    return std::abs(figures(seed, enlarged).contacts - figures(seed, reference).contacts);
                  });
}

results::ExperimentChart log_normal_scaling_chart(const std::vector<PointOfRun>& runs,
                                                  const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "log_normal_scaling";
  chart.title = "Contacts of enlarged spheres of widely different sizes";
  chart.subtitle = "s_d over m_d = 0.8; published: 0.04 (l = 2) and 0.12 (l = 4) from the originals";
  chart.x = {.label = "Enlargement l [-]", .lower = 0};
  chart.y = {.label = "Mean coordination number [-]", .lower = 0};
  add_run_series(chart, seed, "method 1", runs,
                 [&](const std::string& run) { return figures_of(seed, run, kLow, kHigh).contacts; });
  return chart;
}

}  // namespace

LabPlan plan_log_normal_scaling(const LabSetting& setting) {
  const bool coarse = setting.size == LabSize::coarse;
  LabPlan plan;
  std::vector<PointOfRun> points;
  for (const double l : coarse ? std::vector<double>{8, 4, 2} : std::vector<double>{4, 2, 1}) {
    const Case one{0.8, kWeak, l};
    InsertedBed bed = bed_of(one, kMaxCompared);
    bed.insertion.to = kHighest;
    bed.insertion.rest = kRestCompared;
    plan.runs.push_back(run_of(bed));
    points.push_back({l, plan.runs.back().name});
    plan.runs.back().changes.set += line("numerics.time_step_fraction", plain(kStepCompared));
    plan.quantities.push_back(
        own_figure(name_of(one), "contacts", "1", kLow, kHigh, &InsertedBedFigures::contacts));
    plan.quantities.push_back(own_figure(name_of(one), "kinetic energy over m g d", "1", kLow, kHigh,
                                         &InsertedBedFigures::kinetic));
  }
  plan.quantities.push_back(coarse ? contacts_apart("LN-002-M1z2", 8, 4)
                                   : contacts_apart("LN-002-M1z2", 2, 1));
  plan.quantities.push_back(coarse ? contacts_apart("LN-002-M1z4", 8, 2)
                                   : contacts_apart("LN-002-M1z4", 4, 1));
  plan.charts = [points](const SeedResults& seed) {
    return std::vector{log_normal_scaling_chart(points, seed)};
  };
  return plan;
}

LabPlan plan_log_normal_beds(const LabSetting& setting) {
  const LabSize size = setting.size;
  LabPlan plan;
  for (const Case& one : cases_of(size)) plan.runs.push_back(run_of(bed_of(one)));
  add_values(size, plan);
  add_scaling(size, plan);
  add_trends(size, plan);
  for (const Case& one : cases_of(size)) {
    plan.quantities.push_back(
        own_figure(name_of(one), "density", "kg/m^3", kLow, kHigh, &InsertedBedFigures::density));
    plan.quantities.push_back(
        own_figure(name_of(one), "contacts", "1", kLow, kHigh, &InsertedBedFigures::contacts));
  }
  plan.charts = [size](const SeedResults& seed) {
    return std::vector{log_normal_beds_chart(size, seed, false), log_normal_beds_chart(size, seed, true)};
  };
  return plan;
}

}  // namespace diefill::process::laboratory
