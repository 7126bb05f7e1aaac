// Angle of repose of a heap of cohesive spheres on a square plate (Hu 2024, section 5.3): the angle of a cone
// with the same shadow, and Carr's classes. Coarse: l = 4 compared with l = 3; medium: l = 2 and 4;
// published: l = 1 and 2. Classes are those of the smaller spheres.
#include <algorithm>
#include <cmath>
#include <map>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/hu/heap_projection.h"
#include "process/laboratory/published/hu/inserted_bed.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kPlate = 0.056, kDiameter = 1e-3;                  // m, side of the plate, original spheres
constexpr double kPouredShare = 0.01, kMass = 33.5e-3, kTime = 10;  // kg, s
constexpr double kFrictions[] = {0, 0.2, 0.8};
constexpr const char* kClasses[] = {"very free flowing", "free flowing", "fair to passable", "cohesive",
                                    "very cohesive"};

struct Sizes {
  double reference, enlarged;  ///< l
};

Sizes sizes_of(LabSize size) {
  if (size == LabSize::coarse) return {3, 4};
  return size == LabSize::medium ? Sizes{2, 4} : Sizes{1, 2};
}

struct Case {
  double friction;
  int method;
  double enlargement;
};

std::string name_of(const Case& one) {
  return "mu_r = " + plain(one.friction) + ", method " + std::to_string(one.method) +
         ", l = " + plain(one.enlargement);
}

LabRun heap_of(const Case& one) {
  CohesiveSpheres spheres;
  spheres.enlargement = one.enlargement;
  spheres.method = one.method;
  spheres.surface_energy = 0.05;
  spheres.rolling = one.friction > 0 ? "EPSD2" : "none";
  spheres.rolling_friction = one.friction;
  spheres.sizes = {{kDiameter, 1}};
  LabRun run{name_of(one), "heap.toml", {cohesive_lines(spheres), {}}};
  const double entering = (1 - kPouredShare) * kMass;
  run.changes.set += line("step.insert.mass", with_unit(entering, "kg"));
  run.changes.set += line("step.insert.rate", with_unit(entering / kTime, "kg/s"));
  return run;
}

double angle_of(const SeedResults& seed, const Case& one) {
  return area_equivalent_angle(seed.at(name_of(one), "heap").powder, kPlate);
}

LabQuantity quantity(const std::string& id, const std::string& label, const std::vector<Case>& cases,
                     const std::function<double(const SeedResults&)>& value) {
  LabQuantity quantity{.id = id, .quantity = label, .unit = "", .runs = {}, .value = value};
  for (const Case& one : cases) quantity.runs.push_back(name_of(one));
  return quantity;
}

/// Share of four statements that hold: 38 to 45 deg without rolling resistance and more than 55 deg with the
/// largest, both within 3 deg, and steeper from each coefficient to the next.
double share_of_statements(const std::vector<double>& angles) {
  double right = angles[0] > 35 && angles[0] < 48 ? 1 : 0;
  right += angles[2] > 52 ? 1 : 0;
  for (const std::size_t k : {1U, 2U}) right += angles[k] > angles[k - 1] ? 1 : 0;
  return right / 4;
}

/// Height of the heap's surface over x, the highest sphere in columns of d.
results::ExperimentSeries surface_of(const SeedResults& seed, const Case& one) {
  const results::PowderState& powder = seed.at(name_of(one), "heap").powder;
  const double width = powder.grain_diameter;
  std::map<long, double> top;
  for (const auto& place : powder.position) {
    double& highest = top[std::lround(place[0] / width)];
    highest = std::max(highest, place[2] + 0.5 * width);
  }
  results::ExperimentSeries series{.name = name_of(one), .x = {}, .y = {}};
  for (const auto& [column, height] : top) {
    series.x.push_back(1e3 * static_cast<double>(column) * width);
    series.y.push_back(1e3 * height);
  }
  return series;
}

results::ExperimentChart heap_on_plate_chart(const std::vector<Case>& cases, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "heap_on_plate";
  chart.title = "Heaps on a plate of 56 mm";
  chart.subtitle = "Highest sphere in columns of d";
  chart.x = {.label = "x [mm]"};
  chart.y = {.label = "Height [mm]", .lower = 0};
  for (const Case& one : cases) {
    if (!seed.has(name_of(one))) continue;
    chart.series.push_back(surface_of(seed, one));
    const double angle = angle_of(seed, one);
    chart.note += (chart.note.empty() ? "Angles of equal shadow in degrees, as in the legend: " : ", ") +
                  plain(std::round(10 * angle) / 10) + " (" + kClasses[carr_class(angle)] + ")";
  }
  return chart;
}

void add_scaling(const Sizes& sizes, LabPlan& plan) {
  const auto deviation = [sizes](const SeedResults& seed, double friction) {
    return percent_apart(angle_of(seed, {friction, 1, sizes.enlarged}),
                         angle_of(seed, {friction, 1, sizes.reference}));
  };
  const std::string from = ", l = " + plain(sizes.enlarged) + " from l = " + plain(sizes.reference);
  const std::vector<Case> rough = {{0.2, 1, sizes.enlarged}, {0.2, 1, sizes.reference}};
  plan.quantities.push_back(quantity("AOR-M1", "deviation at mu_r = 0.2" + from, rough,
                                     [=](const SeedResults& seed) { return deviation(seed, 0.2); }));
  std::vector<Case> both = rough;
  both.push_back({0, 1, sizes.enlarged});
  both.push_back({0, 1, sizes.reference});
  plan.quantities.push_back(
      quantity("AOR-M1b", "deviation at mu_r = 0 less that at 0.2" + from, both,
               [=](const SeedResults& seed) { return deviation(seed, 0) - deviation(seed, 0.2); }));
  const Case first{0.2, 1, sizes.enlarged}, third{0.2, 3, sizes.enlarged};
  plan.quantities.push_back(quantity("AOR-M3", "", {first, third}, [=](const SeedResults& seed) {
    return angle_of(seed, third) - angle_of(seed, first);
  }));
}

}  // namespace

LabPlan plan_heap_on_plate(const LabSetting& setting) {
  const Sizes sizes = sizes_of(setting.size);
  std::vector<Case> cases, steps;
  for (const double friction : kFrictions) steps.push_back({friction, 1, sizes.reference});
  cases = steps;
  for (const double friction : {0.0, 0.2}) cases.push_back({friction, 1, sizes.enlarged});
  cases.push_back({0.2, 3, sizes.enlarged});
  LabPlan plan;
  for (const Case& one : cases) plan.runs.push_back(heap_of(one));
  const std::string stands = "angle of repose, l = " + plain(sizes.reference);
  plan.quantities.push_back(quantity("AOR-02", stands, {steps[1]},
                                     [steps](const SeedResults& seed) { return angle_of(seed, steps[1]); }));
  plan.quantities.push_back(
      quantity("AOR-range",
               "classes at mu_r = 0 and 0.8 within 3 deg, steeper with mu_r, l = " + plain(sizes.reference),
               steps, [steps](const SeedResults& seed) {
                 std::vector<double> angles;
                 for (const Case& one : steps) angles.push_back(angle_of(seed, one));
                 return share_of_statements(angles);
               }));
  add_scaling(sizes, plan);
  for (const Case& one : cases)
    plan.quantities.push_back({.id = "angle, " + name_of(one),
                               .quantity = "angle, " + name_of(one),
                               .unit = "deg",
                               .runs = {name_of(one)},
                               .value = [one](const SeedResults& seed) { return angle_of(seed, one); }});
  plan.charts = [cases](const SeedResults& seed) { return std::vector{heap_on_plate_chart(cases, seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
