// What coarse grains change in heaps: the toe of the heap on the floor and the peak of that on the slider
// (Bierwisch 2009, section 3.2.3): model D, mu = 1, cohesion in proportion to the grain size. Coarse: d =
// 0.94 and 1.88 mm, half the lengths of the set-up; medium: the same sizes in the whole one; published: also
// 0.47 mm.
#include <cmath>
#include <limits>

#include "process/laboratory/published/bierwisch/heap_shape.h"
#include "process/laboratory/published/bierwisch/repose_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/run_series.h"

namespace diefill::process::laboratory {
namespace {

constexpr const char* kPreset = "ASC100.29 D2";
constexpr double kSlider = 0.010;  // m, that the slider is drawn by

std::vector<double> scales(LabSize size) {
  return size == LabSize::published ? std::vector<double>{1, 2, 4} : std::vector<double>{2, 4};
}

std::string run_name(const LabPowder& powder) {
  return "d = " + plain(1e3 * powder.size) + " mm";
}

/// m, parts of the box that the heaps stand in, of the whole set-up or half of it.
struct Reach {
  double floor, side_wall, floor_end, slider_end;
};

Reach reach_of(LabSize size) {
  if (size == LabSize::coarse) return {-0.024, 0.020, -0.048, 0.010};
  return {-0.042, 0.030, -0.078, 0.020};
}

/// m
double toe_on_floor(const SeedResults& seed, const std::string& run, const Reach& reach) {
  return heap_shape(seed.of(run).powder, {reach.floor_end, -1, reach.floor}, {reach.side_wall, 1, -0.002},
                    true)
      .toe;
}

double peak_on_slider(const SeedResults& seed, const std::string& run, const Reach& reach) {
  return heap_shape(seed.of(run).powder, {-kSlider, -1, 0}, {reach.slider_end, 1, 1}, false).peak;
}

results::ExperimentChart heap_sizes_chart(const std::vector<PointOfRun>& runs, const Reach& reach,
                                          const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "heap_sizes";
  chart.title = "Toe and peak of heaps over grain size";
  chart.subtitle = "Published: longer toe and flatter peak with larger grains";
  chart.x = {.label = "Grain size [mm]", .lower = 0};
  chart.y = {.label = "Length [mm]", .lower = 0};
  add_run_series(chart, seed, "toe of the heap on the floor", runs,
                 [&](const std::string& run) { return 1e3 * toe_on_floor(seed, run, reach); });
  add_run_series(chart, seed, "height lacking at the peak on the slider", runs,
                 [&](const std::string& run) { return 1e3 * peak_on_slider(seed, run, reach); });
  return chart;
}

}  // namespace

LabPlan plan_heap_sizes(const LabSetting& setting) {
  const Reach reach = reach_of(setting.size);
  LabPlan plan;
  std::vector<std::string> runs;
  std::vector<PointOfRun> points;
  for (const double scale : scales(setting.size)) {
    const LabPowder powder = lab_powder(setting, kPreset, scale);
    const std::string run = run_name(powder);
    runs.push_back(run);
    points.push_back({1e3 * powder.size, run});
    plan.runs.push_back(
        {run, "repose.toml", repose_changes(setting, powder, setting.size == LabSize::coarse, false)});
    const auto add = [&](const char* what,
                         double (*value)(const SeedResults&, const std::string&, const Reach&)) {
      plan.quantities.push_back(
          {.id = std::string(what) + ", " + run,
           .quantity = std::string(what) + ", " + run,
           .unit = "mm",
           .runs = {run},
           .value = [=](const SeedResults& seed) { return 1e3 * value(seed, run, reach); }});
    };
    add("toe of the heap on the floor", toe_on_floor);
    add("height lacking at the peak on the slider", peak_on_slider);
  }
  plan.quantities.push_back(
      {.id = "R12", .quantity = "", .unit = "", .runs = runs, .value = [=](const SeedResults& seed) {
         const std::string &fine = runs.front(), &coarse = runs.back();
         const double toe = toe_on_floor(seed, coarse, reach) - toe_on_floor(seed, fine, reach),
                      peak = peak_on_slider(seed, coarse, reach) - peak_on_slider(seed, fine, reach);
         if (!std::isfinite(toe + peak)) return std::numeric_limits<double>::quiet_NaN();
         return 0.5 * (toe > 0) + 0.5 * (peak > 0);
       }});
  plan.charts = [=](const SeedResults& seed) { return std::vector{heap_sizes_chart(points, reach, seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
