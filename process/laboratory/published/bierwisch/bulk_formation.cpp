// Bulk formation (Bierwisch 2009, section 3.2.1, Figs. 3.2 to 3.4, Table C.2): beds of two grain sizes on a
// ground of spheres of the grains' own radius. The source has 0.47, 0.94 and 1.88 mm.
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

LabRun run_of(const Set& one, double scale) {
  const double width = std::max(0.005, 5.4 * kReference * scale), half = 0.5 * width;
  LabRun run{run_name(one, scale), "bed.toml", {}};
  std::string& set = run.changes.set;
  set += line("powder.grain_diameter", millimetres(kReference * scale));
  set += line("powder.friction", plain(one.friction));
  if (one.held != std::string_view(kWork.held))
    set += line("powder.work_of_adhesion", '"' + plain(one.work) + " J/m^2\"");
  if (*one.held != '\0') set += line(one.held, '"' + plain(one.value / scale) + ' ' + one.unit + '"');
  set += line("walls.sphere_radius", millimetres(7.84e-5 * scale));
  set += line("pour.from", point_in_millimetres(-half, -half, 0));
  set += line("pour.to", point_in_millimetres(half, half, kSlab));
  set += line("numerics.periodic", "{ x = " + millimetres(width) + ", y = " + millimetres(width) + " }");
  set += line("numerics.time_step", '"' + plain(scale) + " us\"");
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

double mean_overlap_of(const results::FillResult& result) {
  return contact_statistics(result.powder).mean_overlap;
}

/// Coarse less fine contacts a grain.
double rise(const SeedResults& seed, const Set& set, const Sizes& sizes) {
  return contacts_of(seed.of(run_name(set, sizes.coarse))) - contacts_of(seed.of(run_name(set, sizes.fine)));
}

/// Largest difference between the sizes, over what the source's collapse allows.
double lack_of_collapse(const SeedResults& seed, const Set& set, const Sizes& sizes) {
  const auto& fine = seed.of(run_name(set, sizes.fine));
  const auto& coarse = seed.of(run_name(set, sizes.coarse));
  const double overlap = std::abs(mean_overlap_of(coarse) / mean_overlap_of(fine) - 1) / 0.03;
  const double contacts = std::abs(contacts_of(coarse) - contacts_of(fine)) / 0.1;
  const double fraction = std::abs(bulk_of(coarse) - bulk_of(fine)) / 0.005;
  return std::max({overlap, contacts, fraction});
}

std::vector<std::string> both(const Set& set, const Sizes& sizes) {
  return {run_name(set, sizes.fine), run_name(set, sizes.coarse)};
}

LayerProfile layers_of(const results::PowderState& powder) {
  return layer_profile(powder, powder.period[0] * powder.period[1]);
}

std::vector<results::ExperimentChart> charts_of(const std::vector<SeedResults>& seeds, const Sizes& sizes) {
  results::ExperimentChart overlaps, layers;
  overlaps.name = "bulk_formation_overlaps";
  overlaps.title = "Overlaps of contacts in fallen beds";
  overlaps.subtitle = "Model D, slab of 10 mm; one seed; published peaks at 2e-4 and 8e-4";
  overlaps.x = {.label = "Overlap over grain size [1]", .lower = 0, .upper = 2e-3};
  overlaps.y = {.label = "Share of contacts [1]"};
  layers.name = "bulk_formation_layers";
  layers.title = "Solid share over height in fallen beds";
  layers.subtitle = "Model D, slab of 10 mm; one seed; lowest published near the ground: 0.18";
  layers.x = {.label = "Height over grain size [1]", .lower = 0, .upper = 5};
  layers.y = {.label = "Solid share of the plane [1]"};
  for (const Set& set : {kFree, kCohesive})
    for (const double scale : {sizes.fine, sizes.coarse}) {
      const std::string run = run_name(set, scale);
      if (!seeds.front().has(run)) continue;
      const auto& powder = seeds.front().of(run).powder;
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

}  // namespace

LabPlan plan_bulk_formation(const LabSetting& setting) {
  const Sizes sizes = sizes_of(setting.size);
  LabPlan plan;
  for (const Set& set : kSets)
    for (const double scale : {sizes.fine, sizes.coarse}) plan.runs.push_back(run_of(set, scale));
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
  const auto add = [&](const char* id, std::vector<std::string> runs, auto value) {
    plan.quantities.push_back(
        {.id = id, .quantity = "", .unit = "", .runs = std::move(runs), .value = value});
  };
  auto four = both(kFree, sizes);
  for (const auto& run : both(kCohesive, sizes)) four.push_back(run);
  add("K07", four, [sizes](const SeedResults& seed) {
    return std::max(lack_of_collapse(seed, kFree, sizes), lack_of_collapse(seed, kCohesive, sizes));
  });
  add("K08", both(kDamping, sizes), [sizes](const SeedResults& seed) { return rise(seed, kDamping, sizes); });
  auto springs = both(kDamping, sizes);
  for (const auto& run : both(kSpring, sizes)) springs.push_back(run);
  add("K09", springs,
      [sizes](const SeedResults& seed) { return rise(seed, kSpring, sizes) / rise(seed, kDamping, sizes); });
  add("K10", both(kWork, sizes), [sizes](const SeedResults& seed) {
    return mean_overlap_of(seed.of(run_name(kWork, sizes.fine))) /
           mean_overlap_of(seed.of(run_name(kWork, sizes.coarse)));
  });
  plan.charts = [sizes](const std::vector<SeedResults>& seeds) { return charts_of(seeds, sizes); };
  return plan;
}

}  // namespace diefill::process::laboratory
