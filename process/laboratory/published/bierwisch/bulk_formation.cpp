// Bulk formation (Bierwisch 2009, section 3.2.1, Figs. 3.2 to 3.4, Table C.2): beds of two grain sizes on a
// ground of spheres of the grains' own radius. The source has 0.47, 0.94 and 1.88 mm; sizes collapse but near
// ground and top, so that they are compared by grains 2 d away from both.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "process/laboratory/layer_profile.h"
#include "process/laboratory/published/contact_statistics.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/results/figure_table.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kReference = 4.7e-4;  // m
constexpr double kSlab = 0.010;        // m
constexpr double kWidth = 0.005;       // m at the reference size; others are as many grains wide
constexpr double kAway = 2;            // d, from ground and top, of the grains that sizes are compared by
constexpr double kSameOverlap = 0.03, kSameContacts = 0.1, kSameFraction = 0.005;  // of a collapse
constexpr double kMoreContacts = 0.05, kMoreFraction = 0.001;  // beyond the scatter of packings

/// A set of Table C.2.
struct Set {
  const char* name;
  double friction;
  double work;            ///< J/m^2, work of adhesion at the reference size, scaled with the size
  const char* held = "";  ///< key whose coefficient is that of the reference size for all sizes
  double value = 0;
  const char* unit = "";
};

constexpr Set kFree = {"no cohesion", 0.5, 0};
constexpr Set kCohesive = {"cohesion", 1.0, 0.01};
constexpr Set kDamping = {"gamma_n fixed", 0.5, 0, "powder.damping_over_radius", 1e5, "Pa s/m"};
constexpr Set kSpring = {"kappa_t fixed", 0.5, 0, "powder.tangential_over_radius", 1e6, "Pa"};
constexpr Set kWork = {"w fixed", 1.0, 0, "powder.work_of_adhesion", 0.01, "J/m^2"};
constexpr Set kSets[] = {kFree, kCohesive, kDamping, kSpring, kWork};

struct Sizes {
  double fine, coarse;  ///< over the reference size
};

Sizes sizes_of(LabSize size) {
  return size == LabSize::coarse ? Sizes{2, 4} : size == LabSize::medium ? Sizes{1.5, 3} : Sizes{1, 2};
}

std::string run_name(const Set& set, double scale) {
  return std::string(set.name) + ", d = " + plain(1e3 * kReference * scale) + " mm";
}

LabRun bulk_formation_run(const Set& one, double scale) {
  const double width = kWidth * scale, half = 0.5 * width;
  LabRun run{run_name(one, scale), "bed.toml", {}};
  std::string& set = run.changes.set;
  set += line("powder.grain_diameter", millimetres(kReference * scale));
  set += line("powder.friction", plain(one.friction));
  if (one.held != std::string_view(kWork.held))
    set += line("powder.work_of_adhesion", with_unit(one.work, "J/m^2"));
  if (*one.held != '\0') set += line(one.held, with_unit(one.value / scale, one.unit));
  set += line("walls.sphere_radius", millimetres(7.84e-5 * scale));
  set += line("pour.from", point_in_millimetres(-half, -half, 0));
  set += line("pour.to", point_in_millimetres(half, half, kSlab));
  set += line("numerics.periodic", "{ x = " + millimetres(width) + ", y = " + millimetres(width) + " }");
  set += line("numerics.time_step", with_unit(scale, "us"));
  return run;
}

double bulk_of(const results::FillResult& result) {
  return results::figure_of(result, "bulk_solid_fraction");
}

using OfBed = double (*)(const results::FillResult&);

LabQuantity of_one(const char* id, const std::string& run, OfBed value) {
  return {
      .id = id, .quantity = "", .unit = "", .runs = {run}, .value = [run, value](const SeedResults& seed) {
        return value(seed.of(run));
      }};
}

double contacts_of(const results::FillResult& result) {
  return contact_statistics(result.powder).contacts_a_grain;
}

/// Solid over cell volume of the grains that sizes are compared by.
double fraction_away(const results::FillResult& result) {
  const auto counts = away_from_ends(result.powder, kAway);
  double solid = 0, cells = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (!counts[k] || result.solid_fraction.open[k] != 0) continue;
    solid += result.powder.solid_volume_of(k);
    cells += result.solid_fraction.cell_volume[k];
  }
  return solid / cells;
}

/// What coarse grains have more than fine ones, away from ground and top.
struct Rise {
  double overlap = 0;  ///< mean h / d, coarse over fine, less 1
  double contacts = 0, fraction = 0;
};

Rise rise_of(const SeedResults& seed, const Set& set, const Sizes& sizes) {
  const auto& fine = seed.of(run_name(set, sizes.fine));
  const auto& coarse = seed.of(run_name(set, sizes.coarse));
  constexpr double kBin = 5e-5;  // h / d
  const auto few = contact_statistics(fine.powder, kBin, kAway),
             many = contact_statistics(coarse.powder, kBin, kAway);
  return {many.mean_overlap / few.mean_overlap - 1, many.contacts_a_grain - few.contacts_a_grain,
          fraction_away(coarse) - fraction_away(fine)};
}

/// Largest difference between the sizes, over what the source's collapse allows.
double lack_of_collapse(const SeedResults& seed, const Set& set, const Sizes& sizes) {
  const Rise rise = rise_of(seed, set, sizes);
  return std::max({std::abs(rise.overlap) / kSameOverlap, std::abs(rise.contacts) / kSameContacts,
                   std::abs(rise.fraction) / kSameFraction});
}

/// K08: share of three statements that hold with gamma_n fixed: overlaps collapse, contacts and fraction rise
/// with d.
double share_with_damping_fixed(const Rise& damping) {
  return ((std::abs(damping.overlap) < kSameOverlap) + (damping.contacts > kMoreContacts) +
          (damping.fraction > kMoreFraction)) /
         3.0;
}

/// K09: the same with kappa_t fixed, and more than with gamma_n fixed.
double share_with_spring_fixed(const Rise& spring, const Rise& damping) {
  return ((std::abs(spring.overlap) < kSameOverlap) +
          (spring.contacts > std::max(kMoreContacts, damping.contacts)) +
          (spring.fraction > std::max(kMoreFraction, damping.fraction))) /
         3.0;
}

/// K10: share of three statements that hold with w fixed: overlaps of small grains are larger, contacts and
/// fraction rise with d.
double share_with_work_fixed(const Rise& work) {
  return ((work.overlap < 0) + (work.contacts > 0) + (work.fraction > 0)) / 3.0;
}

LayerProfile layers_of(const results::PowderState& powder) {
  return layer_profile(powder, powder.period[0] * powder.period[1]);
}

std::vector<results::ExperimentChart> charts_of(const SeedResults& seed, const Sizes& sizes) {
  results::ExperimentChart overlaps, layers;
  overlaps.name = "bulk_formation_overlaps";
  overlaps.title = "Contact overlaps in deposited beds";
  overlaps.subtitle = "Model D, slab of 10 mm; published peaks at 2e-4 and 8e-4";
  overlaps.x = {.label = "Overlap over grain size [1]", .lower = 0, .upper = 2e-3};
  overlaps.y = {.label = "Fraction of contacts [1]"};
  layers.name = "bulk_formation_layers";
  layers.title = "Area fraction of solid over height in deposited beds";
  layers.subtitle = "Model D, slab of 10 mm; lowest published near the ground: 0.18";
  layers.x = {.label = "Height over grain size [1]", .lower = 0, .upper = 5};
  layers.y = {.label = "Area fraction of solid [1]"};
  for (const Set& set : {kFree, kCohesive})
    for (const double scale : {sizes.fine, sizes.coarse}) {
      const std::string run = run_name(set, scale);
      if (!seed.has(run)) continue;
      const auto& powder = seed.of(run).powder;
      const auto contacts = contact_statistics(powder);
      const auto profile = layers_of(powder);
      using Role = results::ExperimentSeries::Role;
      overlaps.series.push_back({run, Role::predicted, contacts.overlap, contacts.share});
      layers.series.push_back({run, Role::predicted, profile.height, profile.share});
    }
  results::ExperimentSeries peaks{.name = "published peaks",
                                  .role = results::ExperimentSeries::Role::published,
                                  .x = {2e-4, 8e-4},
                                  .y = {0, 0}};
  overlaps.series.push_back(peaks);
  return {overlaps, layers};
}

/// How the sizes differ with each set: K07 to K10, and what they are made of.
void add_differences(const Sizes& sizes, LabPlan& plan) {
  const auto add = [&](const std::string& id, const std::string& quantity, const std::string& unit,
                       const std::vector<Set>& sets, const std::function<double(const SeedResults&)>& value) {
    plan.quantities.push_back({.id = id, .quantity = quantity, .unit = unit, .runs = {}, .value = value});
    for (const Set& set : sets)
      for (const double scale : {sizes.fine, sizes.coarse})
        plan.quantities.back().runs.push_back(run_name(set, scale));
  };
  add("K07", "", "", {kFree, kCohesive}, [sizes](const SeedResults& seed) {
    return std::max(lack_of_collapse(seed, kFree, sizes), lack_of_collapse(seed, kCohesive, sizes));
  });
  add("K08", "", "", {kDamping},
      [sizes](const SeedResults& seed) { return share_with_damping_fixed(rise_of(seed, kDamping, sizes)); });
  add("K09", "", "", {kDamping, kSpring}, [sizes](const SeedResults& seed) {
    return share_with_spring_fixed(rise_of(seed, kSpring, sizes), rise_of(seed, kDamping, sizes));
  });
  add("K10", "", "", {kWork},
      [sizes](const SeedResults& seed) { return share_with_work_fixed(rise_of(seed, kWork, sizes)); });
  for (const Set& set : kSets)
    for (const auto& [what, part] : {std::pair("mean h/d, coarse over fine less 1, ", &Rise::overlap),
                                     std::pair("contacts a grain, coarse less fine, ", &Rise::contacts),
                                     std::pair("solid fraction, coarse less fine, ", &Rise::fraction)}) {
      const std::string name = std::string(what) + set.name;
      add(name, name, "1", {set}, [=](const SeedResults& seed) { return rise_of(seed, set, sizes).*part; });
    }
}

}  // namespace

LabPlan plan_bulk_formation(const LabSetting& setting) {
  const Sizes sizes = sizes_of(setting.size);
  LabPlan plan;
  for (const Set& set : kSets)
    for (const double scale : {sizes.fine, sizes.coarse}) plan.runs.push_back(bulk_formation_run(set, scale));
  const std::string free = run_name(kFree, sizes.fine), cohesive = run_name(kCohesive, sizes.fine);
  const OfBed peak = [](const results::FillResult& bed) {
    return contact_statistics(bed.powder).peak_overlap;
  };
  plan.quantities = {of_one("K01", free, peak),
                     of_one("K02", cohesive, peak),
                     of_one("K03", free, contacts_of),
                     of_one("K04", cohesive, contacts_of),
                     of_one("K05", cohesive,
                            [](const results::FillResult& bed) {
                              return near_ground(layers_of(bed.powder), bulk_of(bed)).lowest_share;
                            }),
                     of_one("K06", cohesive, [](const results::FillResult& bed) {
                       return near_ground(layers_of(bed.powder), bulk_of(bed)).bulk_reached_at;
                     })};
  add_differences(sizes, plan);
  plan.charts = [sizes](const SeedResults& seed) { return charts_of(seed, sizes); };
  return plan;
}

}  // namespace diefill::process::laboratory
