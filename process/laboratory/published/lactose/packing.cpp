// Initial packing in four ways and without attraction, over the diameter (Kottlan 2018, sections 2.6
// and 3.1): parameters of the screening's centre, spheres of one size, periodic beds. Coarse: three
// diameters, beds 6 d wide and 10 d deep, and no falling in air of small spheres, which takes too long.
#include <cmath>
#include <string>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/laboratory/published/lactose/pressed_bed.h"
#include "process/laboratory/published/run_series.h"

namespace diefill::process::laboratory {
namespace {

struct Way {
  const char* name;
  Packing packing;
};
constexpr Way kWays[] = {{"clusters", Packing::clusters},
                         {"motion", Packing::motion},
                         {"slow", Packing::slow},
                         {"plain", Packing::plain},
                         {"free", Packing::free}};
constexpr double kSmallestSlow = 3e-5;  // m, falls in air within the time of free falling

/// Run 32 of Table 17.
AdhesivePowder centre_of_screening(double diameter) {
  AdhesivePowder powder{80e-19, 11, 0.2, 30e6, 0.11, 0.5 * diameter, 0.11, 2.75};
  powder.dynamic_ratio = 0.75;
  return powder;
}

std::vector<double> diameters(LabSize size) {
  if (size == LabSize::coarse) return {8e-6, 32e-6, 128e-6};
  return size == LabSize::medium ? std::vector<double>{4e-6, 8e-6, 16e-6, 32e-6, 64e-6, 128e-6}
                                 : std::vector<double>{2e-6, 4e-6, 8e-6, 16e-6, 32e-6, 64e-6, 128e-6};
}

bool is_run(const Way& way, double diameter) {
  return way.packing != Packing::slow || diameter >= kSmallestSlow;
}

std::string run_name(const Way& way, double diameter) {
  return std::string(way.name) + ", d = " + plain(1e6 * diameter) + " um";
}

LabRun packing_run(const Way& way, double diameter, LabSize size) {
  AdhesiveBed bed = size == LabSize::coarse ? AdhesiveBed{6, 10} : AdhesiveBed{10, 20};
  bed.packing = way.packing;
  return {run_name(way, diameter),
          "adhesive_bed.toml",
          {packed_bed_lines(centre_of_screening(diameter), bed) + unpressed_lines(), {}}};
}

double fraction(const SeedResults& seed, const Way& way, double diameter) {
  return middle_fraction(packed_bed(seed, run_name(way, diameter)));
}

/// How much less the smallest spheres fill than the largest.
double drop(const SeedResults& seed, const Way& way, const std::vector<double>& sizes) {
  return fraction(seed, way, sizes.back()) - fraction(seed, way, sizes.front());
}

results::ExperimentChart packing_chart(const LabSetting& setting, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "packing";
  chart.title = "Solid fraction of beds packed in different ways";
  chart.subtitle = "Spheres of one size, centre of the screening (Kottlan 2018)";
  chart.x = {.label = "Diameter [um]", .logarithmic = true};
  chart.y = {.label = "Solid fraction [1]"};
  for (const Way& way : kWays) {
    std::vector<PointOfRun> points;
    for (const double diameter : diameters(setting.size))
      if (is_run(way, diameter)) points.push_back({1e6 * diameter, run_name(way, diameter)});
    add_run_series(chart, seed, way.name, points,
                   [&](const std::string& run) { return middle_fraction(packed_bed(seed, run)); });
  }
  return chart;
}

}  // namespace

LabPlan plan_packing(const LabSetting& setting) {
  const std::vector<double> sizes = diameters(setting.size);
  LabPlan plan;
  for (const Way& way : kWays)
    for (const double diameter : sizes) {
      if (!is_run(way, diameter)) continue;
      const std::string run = run_name(way, diameter);
      plan.runs.push_back(packing_run(way, diameter, setting.size));
      plan.quantities.push_back(
          {.id = run,
           .quantity = "solid fraction, " + run,
           .unit = "1",
           .runs = {run},
           .value = [=](const SeedResults& seed) { return fraction(seed, way, diameter); }});
    }
  const Way &clusters = kWays[0], &plain_way = kWays[3];
  plan.quantities.push_back({.id = "PACK-1",
                             .quantity = "",
                             .unit = "",
                             .runs = {run_name(clusters, sizes.front()), run_name(clusters, sizes.back()),
                                      run_name(plain_way, sizes.front()), run_name(plain_way, sizes.back())},
                             .value = [=](const SeedResults& seed) {
                               return drop(seed, clusters, sizes) - drop(seed, plain_way, sizes);
                             }});
  plan.charts = [setting](const SeedResults& seed) { return std::vector{packing_chart(setting, seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
