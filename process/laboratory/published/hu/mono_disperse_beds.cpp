// Mono-disperse beds with two rolling resistances and three methods of scaling (Hu 2024, section 5.2):
// density and contacts between 20 and 60 mm. Coarse: l = 4 on a sixth of the floor, compared with l = 8, as
// l = 1 takes 1.5e12 sphere-steps; medium: l = 2 and 4; published: l = 1 and 4.
#include <algorithm>
#include <cmath>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/hu/inserted_bed.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kLow = 0.020, kHigh = 0.060;  // m, of the window
constexpr double kDiameter = 5e-4;             // m, original
constexpr double kNarrowest = 4.2;             // d

struct Sizes {
  double reference, enlarged;  ///< l
};

Sizes sizes_of(LabSize size) {
  if (size == LabSize::coarse) return {4, 8};
  return size == LabSize::medium ? Sizes{2, 4} : Sizes{1, 4};
}

/// One bed of the study.
struct Case {
  std::string rolling;
  double friction;
  int method;
  double enlargement;
};

std::string name_of(const Case& one) {
  const std::string rolling =
      one.friction > 0 ? one.rolling + ", mu_r = " + plain(one.friction) : "no rolling resistance";
  return rolling + ", method " + std::to_string(one.method) + ", l = " + plain(one.enlargement);
}

InsertedBed bed_of(const Case& one, LabSize size) {
  InsertedBed bed{name_of(one), {}, {}};
  bed.spheres.enlargement = one.enlargement;
  bed.spheres.method = one.method;
  bed.spheres.rolling = one.friction > 0 ? one.rolling : "none";
  bed.spheres.rolling_friction = one.friction;
  if (size == LabSize::coarse)
    bed.insertion =
        of_width(bed.insertion, std::min(bed.insertion.width, kNarrowest * one.enlargement * kDiameter));
  return bed;
}

/// The published points, l = `enlargement`, method 1.
std::vector<Case> epsd2(double enlargement) {
  return {{"EPSD2", 0, 1, enlargement}, {"EPSD2", 0.4, 1, enlargement}, {"EPSD2", 0.8, 1, enlargement}};
}

Case constant_torque(double enlargement) {
  return {"CDT", 0.16, 1, enlargement};
}

double density(const SeedResults& seed, const Case& one) {
  return figures_of(seed, name_of(one), kLow, kHigh).density;
}

LabQuantity quantity(const std::string& id, const std::string& label, const std::vector<Case>& cases,
                     const std::function<double(const SeedResults&)>& value) {
  LabQuantity quantity{.id = id, .quantity = label, .unit = "", .runs = {}, .value = value};
  for (const Case& one : cases) quantity.runs.push_back(name_of(one));
  return quantity;
}

/// Share of steps from one bed to the next in which contacts fall and the bed grows.
double loosening(const SeedResults& seed, const std::vector<Case>& cases) {
  double fallen = 0;
  for (std::size_t k = 1; k < cases.size(); ++k) {
    const InsertedBedFigures before = figures_of(seed, name_of(cases[k - 1]), kLow, kHigh),
                             after = figures_of(seed, name_of(cases[k]), kLow, kHigh);
    fallen += after.contacts < before.contacts && after.height > before.height ? 1 : 0;
  }
  return fallen / static_cast<double>(cases.size() - 1);
}

results::ExperimentChart mono_disperse_beds_chart(const std::vector<Case>& cases, const SeedResults& seed,
                                                  bool contacts) {
  using Role = results::ExperimentSeries::Role;
  results::ExperimentChart chart;
  chart.name = contacts ? "mono_disperse_contacts" : "mono_disperse_density";
  chart.title =
      contacts ? "Contacts of a sphere over rolling resistance" : "Bulk density over rolling resistance";
  chart.subtitle = "Cohesive spheres of 0.5 mm times l, 0.2 J/m2, 20 to 60 mm above the floor (Hu 2024)";
  chart.x = {.label = "Rolling friction mu_r [1]"};
  chart.y = {.label = contacts ? "Coordination number [1]" : "Bulk density [kg/m3]"};
  for (const Case& one : cases) {
    if (!seed.has(name_of(one))) continue;
    const std::string name = (one.friction > 0 ? one.rolling : std::string("EPSD2")) + ", method " +
                             std::to_string(one.method) + ", l = " + plain(one.enlargement);
    auto series = std::find_if(chart.series.begin(), chart.series.end(),
                               [&](const auto& known) { return known.name == name; });
    if (series == chart.series.end()) series = chart.series.insert(series, {.name = name, .x = {}, .y = {}});
    const InsertedBedFigures figures = figures_of(seed, name_of(one), kLow, kHigh);
    series->x.push_back(one.friction);
    series->y.push_back(contacts ? figures.contacts : figures.density);
  }
  if (!contacts)
    chart.series.push_back({.name = "published, l = 1: EPSD2 0 and 0.8, CDT 0.16",
                            .role = Role::published,
                            .x = {0, 0.8, 0.16},
                            .y = {541, 484, 502}});
  return chart;
}

/// Densities of the published points, and what they lose.
void add_published(double l, LabPlan& plan) {
  const auto points = epsd2(l);
  const Case none = points.front(), most = points.back(), torque = constant_torque(l);
  const auto of = [](const Case& one) {
    return [one](const SeedResults& seed) { return density(seed, one); };
  };
  const auto lost = [none](const Case& one) {
    return
        [none, one](const SeedResults& seed) { return 100 * (1 - density(seed, one) / density(seed, none)); };
  };
  plan.quantities.push_back(quantity("BED-0", "", {none}, of(none)));
  plan.quantities.push_back(quantity("BED-08", "", {most}, of(most)));
  plan.quantities.push_back(quantity("BED-drop", "", {none, most}, lost(most)));
  plan.quantities.push_back(quantity("BED-coord", "", points,
                                     [points](const SeedResults& seed) { return loosening(seed, points); }));
  plan.quantities.push_back(quantity("CDT-016", "", {torque}, of(torque)));
  plan.quantities.push_back(quantity("CDT-drop", "", {none, torque}, lost(torque)));
}

/// How far enlarged spheres are from the reference, and method 3 from method 1.
void add_scaling(const Sizes& sizes, LabPlan& plan) {
  const auto fine = epsd2(sizes.reference), coarse = epsd2(sizes.enlarged);
  const Case fine_torque = constant_torque(sizes.reference), coarse_torque = constant_torque(sizes.enlarged);
  const auto apart = [](const SeedResults& seed, const Case& one, const Case& other) {
    return percent_apart(density(seed, one), density(seed, other));
  };
  const std::string from = ", l = " + plain(sizes.enlarged) + " from l = " + plain(sizes.reference);
  plan.quantities.push_back(quantity("BED-M1", "deviation, mean of mu_r = 0 and 0.8" + from,
                                     {fine[0], fine[2], coarse[0], coarse[2]}, [=](const SeedResults& seed) {
                                       return 0.5 * (apart(seed, coarse[0], fine[0]) +
                                                     apart(seed, coarse[2], fine[2]));
                                     }));
  plan.quantities.push_back(quantity("BED-M1l", "larger deviation of mu_r = 0 and 0.8" + from,
                                     {fine[0], fine[2], coarse[0], coarse[2]}, [=](const SeedResults& seed) {
                                       return std::max(apart(seed, coarse[0], fine[0]),
                                                       apart(seed, coarse[2], fine[2]));
                                     }));
  plan.quantities.push_back(
      quantity("CDT-M1", "deviation" + from, {fine_torque, coarse_torque},
               [=](const SeedResults& seed) { return apart(seed, coarse_torque, fine_torque); }));
  const double l = std::max(4.0, sizes.reference);
  for (const int method : {2, 3}) {
    const Case first{"EPSD2", 0, 1, l}, other{"EPSD2", 0, method, l};
    plan.quantities.push_back(quantity(
        method == 3 ? "BED-M3" : "density lost with method 2",
        method == 3 ? "" : "density lost with method 2, l = " + plain(l), {first, other},
        [=](const SeedResults& seed) { return 100 * (1 - density(seed, other) / density(seed, first)); }));
    if (method == 2) plan.quantities.back().unit = "%";
  }
}

std::vector<Case> cases_of(const Sizes& sizes) {
  std::vector<Case> cases = epsd2(sizes.reference);
  cases.push_back(constant_torque(sizes.reference));
  const auto coarse = epsd2(sizes.enlarged);
  cases.push_back(coarse.front());
  cases.push_back(coarse.back());
  cases.push_back(constant_torque(sizes.enlarged));
  for (const int method : {2, 3}) cases.push_back({"EPSD2", 0, method, std::max(4.0, sizes.reference)});
  return cases;
}

}  // namespace

LabPlan plan_mono_disperse_beds(const LabSetting& setting) {
  const Sizes sizes = sizes_of(setting.size);
  const auto cases = cases_of(sizes);
  LabPlan plan;
  for (const Case& one : cases) plan.runs.push_back(run_of(bed_of(one, setting.size)));
  add_published(sizes.reference, plan);
  add_scaling(sizes, plan);
  for (const Case& one : cases) {
    plan.quantities.push_back(
        own_figure(name_of(one), "density", "kg/m^3", kLow, kHigh, &InsertedBedFigures::density));
    plan.quantities.push_back(
        own_figure(name_of(one), "contacts", "1", kLow, kHigh, &InsertedBedFigures::contacts));
    plan.quantities.push_back(own_figure(name_of(one), "kinetic energy over m g d", "1", kLow, kHigh,
                                         &InsertedBedFigures::kinetic));
  }
  plan.charts = [cases](const SeedResults& seed) {
    return std::vector{mono_disperse_beds_chart(cases, seed, false),
                       mono_disperse_beds_chart(cases, seed, true)};
  };
  return plan;
}

}  // namespace diefill::process::laboratory
