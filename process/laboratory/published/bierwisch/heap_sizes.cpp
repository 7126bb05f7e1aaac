// What coarse grains change in heaps (Bierwisch 2009, section 3.2.3, Table 3.1): both angles of repose, the
// toe of the heap on the floor and the peak of that on the slider: model D, mu = 1, cohesion in proportion to
// the grain size. Its seeds are the packings of Table 4.6 (section 4.2.1). Coarse and medium: d = 0.94
// and 1.88 mm; published: also 0.235 and 0.47 mm.
#include <cmath>
#include <limits>
#include <map>

#include "process/laboratory/published/bierwisch/heap_shape.h"
#include "process/laboratory/published/bierwisch/repose_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/run_series.h"

namespace diefill::process::laboratory {
namespace {

constexpr const char* kPreset = "ASC100.29 D2";
std::vector<double> scales(LabSize size) {
  return size == LabSize::published ? std::vector<double>{0.5, 1, 2, 4} : std::vector<double>{2, 4};
}

std::string run_name(const LabPowder& powder) {
  return "d = " + plain(1e3 * powder.size) + " mm";
}

/// m
double toe_on_floor(const SeedResults& seed, const std::string& run, double draw) {
  const Eigen::AlignedBox3d heap = heap_boxes(draw).on_floor;
  return heap_shape(seed.of(run).powder, heap.min(), heap.max(), true).toe;
}

double peak_on_slider(const SeedResults& seed, const std::string& run, double draw) {
  const Eigen::AlignedBox3d heap = heap_boxes(draw).on_slider;
  return heap_shape(seed.of(run).powder, heap.min(), heap.max(), false).peak;
}

/// A run and how far its slider is drawn (m).
struct Heap {
  std::string run;
  double size, draw;
};

/// A chart over the grain size.
results::ExperimentChart chart_over_size(const std::string& name, const std::string& title,
                                         const std::string& quantity) {
  results::ExperimentChart chart;
  chart.name = name;
  chart.title = title;
  chart.x = {.label = "Grain size [mm]", .lower = 0};
  chart.y = {.label = quantity, .lower = 0};
  return chart;
}

std::vector<results::ExperimentChart> heap_sizes_charts(const std::vector<Heap>& heaps,
                                                        const SeedResults& seed) {
  auto lengths = chart_over_size("heap_sizes", "Toe and peak of heaps over grain size", "Length [mm]");
  lengths.subtitle = "Published: longer toe and flatter peak with larger grains";
  auto angles = chart_over_size("heap_angles", "Angles of repose over grain size", "Angle [deg]");
  angles.subtitle = "Model D, mu = 1, cohesion in proportion to the grain size";
  std::vector<PointOfRun> points;
  std::map<std::string, double> draw;
  for (const Heap& heap : heaps) {
    points.push_back({1e3 * heap.size, heap.run});
    draw[heap.run] = heap.draw;
  }
  add_run_series(lengths, seed, "toe of the heap on the floor", points,
                 [&](const std::string& run) { return 1e3 * toe_on_floor(seed, run, draw.at(run)); });
  add_run_series(lengths, seed, "height lacking at the peak on the slider", points,
                 [&](const std::string& run) { return 1e3 * peak_on_slider(seed, run, draw.at(run)); });
  for (const char* heap : {kHeapOnSlider, kHeapOnFloor})
    add_run_series(angles, seed, heap, points,
                   [&](const std::string& run) { return heap_angle(run, heap).value(seed); });
  return {lengths, angles};
}

void add_lengths(const Heap& heap, LabPlan& plan) {
  const auto add = [&](const char* what, double (*value)(const SeedResults&, const std::string&, double)) {
    plan.quantities.push_back(
        {.id = std::string(what) + ", " + heap.run,
         .quantity = std::string(what) + ", " + heap.run,
         .unit = "mm",
         .runs = {heap.run},
         .value = [=](const SeedResults& seed) { return 1e3 * value(seed, heap.run, heap.draw); }});
  };
  add("toe of the heap on the floor", toe_on_floor);
  add("height lacking at the peak on the slider", peak_on_slider);
}

/// R12: share of the statements on toe and peak that hold between the finest and the coarsest grains.
double share_of_trends(const SeedResults& seed, const Heap& fine, const Heap& coarse) {
  const double toe = toe_on_floor(seed, coarse.run, coarse.draw) - toe_on_floor(seed, fine.run, fine.draw),
               peak =
                   peak_on_slider(seed, coarse.run, coarse.draw) - peak_on_slider(seed, fine.run, fine.draw);
  if (!std::isfinite(toe + peak)) return std::numeric_limits<double>::quiet_NaN();
  return 0.5 * (toe > 0) + 0.5 * (peak > 0);
}

}  // namespace

LabPlan plan_heap_sizes(const LabSetting& setting) {
  LabPlan plan;
  std::vector<std::string> runs;
  std::vector<Heap> heaps;
  for (const double scale : scales(setting.size)) {
    const LabPowder powder = lab_powder(setting, kPreset, scale);
    heaps.push_back({run_name(powder), powder.size, slider_draw(powder)});
    runs.push_back(heaps.back().run);
    plan.runs.push_back({runs.back(), "repose.toml", repose_changes(setting, powder)});
    plan.quantities.push_back(heap_angle(runs.back(), kHeapOnSlider));
    plan.quantities.push_back(heap_angle(runs.back(), kHeapOnFloor));
    add_lengths(heaps.back(), plan);
  }
  plan.quantities.push_back(
      {.id = "R12", .quantity = "", .unit = "", .runs = runs, .value = [=](const SeedResults& seed) {
         return share_of_trends(seed, heaps.front(), heaps.back());
       }});
  plan.charts = [=](const SeedResults& seed) { return heap_sizes_charts(heaps, seed); };
  return plan;
}

}  // namespace diefill::process::laboratory
