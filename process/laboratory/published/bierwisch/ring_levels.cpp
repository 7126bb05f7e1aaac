// Filling level of a narrow ring over the azimuth after one passage at 0.2 m/s, for grains of two sizes: in
// one ring, and in rings widened by 1.4 d (Bierwisch 2009, section 6.1, Fig. 6.3). Coarse: d = 1.88 and 2.35
// mm; medium: 0.94 and 1.88 mm; published: 0.47 and 0.94 mm.
#include <cmath>
#include <limits>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

/// Names of the CAD files (sample_tools/narrow_ring) for grains of two sizes, mm.
struct Sizes {
  const char *fine, *coarse;
};

Sizes sizes_of(LabSize size) {
  if (size == LabSize::coarse) return {"1.88", "2.35"};
  return size == LabSize::medium ? Sizes{"0.94", "1.88"} : Sizes{"0.47", "0.94"};
}

constexpr const char* kFixed = "0.94";  // whose ring is 3.146 mm wide

std::string name_of(const char* diameter, const char* ring) {
  return std::string("d = ") + diameter + " mm, ring for " + ring + " mm";
}

LabRun ring_levels_run(const char* diameter, const char* ring) {
  LabRun run{name_of(diameter, ring), "../narrow_ring/fill.toml", {}};
  std::string& set = run.changes.set;
  set += line("powder.grain_diameter", std::string("\"") + diameter + " mm\"");
  set += line("tool.die.file", std::string("\"die_d") + ring + ".stl\"");
  set += line("tool.\"lower punch\".file", std::string("\"punch_d") + ring + ".stl\"");
  set += line("walls.spacing", "1.6");  // tight for the finest grains, too
  set += line("tool.shoe.file", "\"shoe.stl\"");
  set += line("pour.to", point_in_millimetres(0.0514, 0.0145, 0.060));
  return run;
}

const results::Profile* level_of(const SeedResults& seed, const std::string& run) {
  for (const results::Profile& profile : seed.of(run).profiles)
    if (profile.quantity == "fill level") return &profile;
  return nullptr;
}

/// mm, mean over the azimuth; an empty bin counts as 0.
double mean_level(const SeedResults& seed, const std::string& run) {
  const results::Profile* level = level_of(seed, run);
  if (level == nullptr || level->y.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (const double value : level->y) sum += std::isfinite(value) ? value : 0;
  return sum / static_cast<double>(level->y.size());
}

results::ExperimentChart ring_levels_chart(const std::vector<std::string>& runs, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "ring_levels";
  chart.title = "Fill level of a narrow ring over the azimuth";
  chart.subtitle =
      "One passage at 0.2 m/s; published: lower for larger d in one ring, equal in widened rings";
  chart.x = {.label = "Azimuth [deg]", .lower = 0, .upper = 360};
  chart.y = {.label = "Fill level [mm]", .lower = 0};
  for (const std::string& run : runs) {
    if (!seed.has(run)) continue;
    if (const results::Profile* level = level_of(seed, run))
      chart.series.push_back({.name = run, .x = level->x, .y = level->y});
  }
  return chart;
}

}  // namespace

LabPlan plan_ring_levels(const LabSetting& setting) {
  const Sizes sizes = sizes_of(setting.size);
  LabPlan plan;
  for (const char* diameter : {sizes.fine, sizes.coarse}) {
    plan.runs.push_back(ring_levels_run(diameter, kFixed));
    if (std::string(diameter) != kFixed) plan.runs.push_back(ring_levels_run(diameter, diameter));
  }
  const std::string fine = name_of(sizes.fine, kFixed), coarse = name_of(sizes.coarse, kFixed),
                    wide_fine = name_of(sizes.fine, sizes.fine),
                    wide_coarse = name_of(sizes.coarse, sizes.coarse);
  plan.quantities.push_back(
      {.id = "M01",
       .quantity = "",
       .unit = "",
       .runs = {fine, coarse},
       .value = [=](const SeedResults& seed) { return mean_level(seed, fine) - mean_level(seed, coarse); }});
  plan.quantities.push_back({.id = "M02",
                             .quantity = "",
                             .unit = "",
                             .runs = {wide_fine, wide_coarse},
                             .value = [=](const SeedResults& seed) {
                               const double one = mean_level(seed, wide_fine),
                                            other = mean_level(seed, wide_coarse);
                               return std::abs(one - other) / (0.5 * (one + other));
                             }});
  std::vector<std::string> runs;
  for (const LabRun& run : plan.runs) {
    runs.push_back(run.name);
    plan.quantities.push_back(
        {.id = "level, " + run.name,
         .quantity = "mean level, " + run.name,
         .unit = "mm",
         .runs = {run.name},
         .value = [name = run.name](const SeedResults& seed) { return mean_level(seed, name); }});
  }
  plan.charts = [runs](const SeedResults& seed) { return std::vector{ring_levels_chart(runs, seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
