// Angles of repose with the slider (Bierwisch 2009, sections 4.1.3 and 4.1.4, Table 4.3): theta_O of the
// powder that stays on the slider, theta_H of the heap on the floor, and how far surfaces still creep from
// two to four seconds after the draw. The coarse size has the set-up of half the lengths
// (sample_tools/tradeoff).
#include <cmath>
#include <limits>

#include "process/laboratory/published/bierwisch/heap_shape.h"
#include "process/laboratory/published/bierwisch/repose_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/measure/figures/heap_slope.h"
#include "process/results/figure_table.h"

namespace diefill::process::laboratory {
namespace {

struct Model {
  const char* name;
  const char* preset;
  const char* on_slider;  ///< published figures; empty: none
  const char* on_floor;
  const char* creep;
};

constexpr Model kModels[] = {{"A2", "ASC100.29 A2", "R03", "R04", ""},
                             {"D2", "ASC100.29 D2", "R05", "R06", ""},
                             {"D1", "ASC100.29 D1", "R07", "R08", ""},
                             {"B1", "ASC100.29 B1", "", "", "R09"},
                             {"C1", "ASC100.29 C1", "", "", "R10"}};

std::vector<Model> models_of(const LabSetting& setting) {
  if (has_own_powder(setting)) return {{"powder", "", "theta_O", "theta_H", ""}};
  return {std::begin(kModels), std::end(kModels)};
}

/// m, boxes around the heaps on floor and slider; of repose.toml, or of half its lengths.
std::vector<Eigen::AlignedBox3d> heaps_of(bool half_lengths) {
  using Box = Eigen::AlignedBox3d;
  using Place = Eigen::Vector3d;
  constexpr double kWide = 1;  // the slice is all there is
  if (!half_lengths)
    return {Box(Place(-0.078, -kWide, -0.042), Place(0.030, kWide, -0.002)),
            Box(Place(-0.010, -kWide, 0), Place(0.020, kWide, 0.060))};
  return {Box(Place(-0.048, -kWide, -0.024), Place(0.020, kWide, -0.002)),
          Box(Place(-0.010, -kWide, 0), Place(0.010, kWide, 0.040))};
}

std::string heap_lines(const char* heap, const Eigen::AlignedBox3d& box, double half) {
  const std::string key = std::string("measure.heap.\"") + heap + "\".";
  return line(key + "from", point_in_millimetres(box.min().x(), -half, box.min().z())) +
         line(key + "to", point_in_millimetres(box.max().x(), half, box.max().z()));
}

/// Half the lengths of the published set-up, with the tools of sample_tools/tradeoff.
std::string half_size(double half) {
  std::string set;
  set += line("tool.floor.file", "\"../tradeoff/floor.stl\"");
  set += line("tool.\"side wall\".file", "\"../tradeoff/side_wall.stl\"");
  set += line("tool.slider.file", "\"../tradeoff/slider.stl\"");
  set += line("pour.from", point_in_millimetres(0.0001, -half, 0));
  set += line("pour.to", point_in_millimetres(0.0199, half, 0.040));
  set += line("pour.fill_height", "\"16 mm\"");
  const auto heaps = heaps_of(true);
  return set + heap_lines(kHeapOnFloor, heaps[0], half) + heap_lines(kHeapOnSlider, heaps[1], half);
}

std::string full_size(double half) {
  std::string set;
  set += line("pour.from", point_in_millimetres(0.0001, -half, 0));
  set += line("pour.to", point_in_millimetres(0.0299, half, 0.060));
  return set;
}

/// Where a heap creeps: two snapshots, 2 and 4 s after the draw, then it is cleared away, as it never comes
/// to rest.
std::string creep_steps() {
  return "step.\"heaps form\".duration = \"4.1 s\"\n"
         "step.end.kind = \"clear\"\n"
         "numerics.max_time = \"15 s\"\n"
         "[[snapshot]]\nname = \"first\"\nwhen = { after = \"draw\", delay = \"2 s\" }\n"
         "[[snapshot]]\nname = \"second\"\nwhen = { after = \"draw\", delay = \"4 s\" }\n";
}

/// Of a published model the published figure says what it is.
LabQuantity angle_of(bool published, const std::string& id, const std::string& run, const char* heap) {
  return {
      .id = id,
      .quantity = published ? "" : "angle of repose, " + std::string(heap),
      .unit = published ? "" : "deg",
      .runs = {run},
      .value = [=](const SeedResults& seed) { return results::figure_of(seed.of(run), heap_figure(heap)); }};
}

/// deg, angle of D1 less that of D2.
double rise_with_cohesion(const SeedResults& seed, const char* heap) {
  return results::figure_of(seed.of("D1"), heap_figure(heap)) -
         results::figure_of(seed.of("D2"), heap_figure(heap));
}

/// R11: theta_O rises with cohesion, theta_H does not; both parts as rows of their own.
void add_effect_of_cohesion(LabPlan& plan) {
  constexpr double kRises = 12, kStays = 5;  // deg
  const auto add = [&](const char* id, const char* quantity, const char* unit,
                       const std::function<double(const SeedResults&)>& value) {
    plan.quantities.push_back(
        {.id = id, .quantity = quantity, .unit = unit, .runs = {"D1", "D2"}, .value = value});
  };
  add("R11", "", "", [](const SeedResults& seed) {
    const double slider = rise_with_cohesion(seed, kHeapOnSlider),
                 floor = rise_with_cohesion(seed, kHeapOnFloor);
    if (!std::isfinite(slider + floor)) return std::numeric_limits<double>::quiet_NaN();
    return 0.5 * (slider > kRises) + 0.5 * (std::abs(floor) < kStays);
  });
  add("theta_O, D1 less D2", "theta_O of D1 less that of D2", "deg",
      [](const SeedResults& seed) { return rise_with_cohesion(seed, kHeapOnSlider); });
  add("theta_H, D1 less D2", "theta_H of D1 less that of D2", "deg",
      [](const SeedResults& seed) { return rise_with_cohesion(seed, kHeapOnFloor); });
}

/// Appends the highest grain of columns 2 d wide in a heap's box, mm; the line breaks where a column has
/// none.
void add_surface(const results::PowderState& powder, const Eigen::AlignedBox3d& heap,
                 results::ExperimentSeries& series) {
  const double width = 2 * powder.grain_diameter;
  std::map<long, double> top;
  for (const auto& place : powder.position) {
    if (!heap.contains(Eigen::Vector3d(place[0], place[1], place[2]))) continue;
    auto& highest = top.try_emplace(std::lround(place[0] / width), place[2]).first->second;
    highest = std::max(highest, place[2]);
  }
  long before = std::numeric_limits<long>::min() / 2;
  for (const auto& [column, height] : top) {
    if (column > before + 1 && !series.x.empty()) {
      series.x.push_back(1e3 * static_cast<double>(column - 1) * width);
      series.y.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    before = column;
    series.x.push_back(1e3 * static_cast<double>(column) * width);
    series.y.push_back(1e3 * height);
  }
}

results::ExperimentChart angle_of_repose_chart(const std::vector<Model>& models,
                                               const std::vector<Eigen::AlignedBox3d>& heaps,
                                               const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "angle_of_repose";
  chart.title = "Surfaces of the heaps on slider and floor";
  chart.subtitle =
      "Highest grain in columns of 2 d; slider above 0 mm; heaps that creep 4 s after the draw; "
      "published angles in the table";
  chart.x = {.label = "x [mm]"};
  chart.y = {.label = "Height above the slider [mm]"};
  for (const Model& model : models) {
    if (!seed.has(model.name)) continue;
    const bool creeps = *model.creep != '\0';
    const auto& powder = creeps ? seed.at(model.name, "second").powder : seed.of(model.name).powder;
    results::ExperimentSeries surfaces{.name = model.name, .x = {}, .y = {}};
    for (const auto& heap : heaps) add_surface(powder, heap, surfaces);
    chart.series.push_back(surfaces);
  }
  return chart;
}

}  // namespace

SceneChanges repose_changes(const LabSetting& setting, const LabPowder& powder, bool half_lengths,
                            bool creeps) {
  const double half = 2.5 * powder.size;
  SceneChanges changes = powder.changes;
  changes.set += half_lengths ? half_size(half) : full_size(half);
  changes.set += line("step.draw.distance", powder.size >= 0.9e-3 ? "\"10 mm\"" : "\"5 mm\"");
  changes.set += line("numerics.periodic", "{ y = " + millimetres(2 * half) + " }");
  if (!has_own_powder(setting))
    changes.set += line("numerics.time_step", with_unit(2 * powder.size / powder.own_size, "us"));
  if (creeps) changes.set += creep_steps();
  return changes;
}

SceneChanges repose_changes(const LabSetting& setting, const std::string& preset, bool creeps) {
  return repose_changes(setting, lab_powder(setting, preset, setting.scale()),
                        setting.size == LabSize::coarse, creeps);
}

LabPlan plan_angle_of_repose(const LabSetting& setting) {
  const auto models = models_of(setting);
  const auto heaps = heaps_of(setting.size == LabSize::coarse);
  LabPlan plan;
  for (const Model& model : models) {
    const std::string run = model.name;
    plan.runs.push_back({run, "repose.toml", repose_changes(setting, model.preset, *model.creep != '\0')});
    if (*model.on_slider != '\0') {
      const bool published = !has_own_powder(setting);
      plan.quantities.push_back(angle_of(published, model.on_slider, run, kHeapOnSlider));
      plan.quantities.push_back(angle_of(published, model.on_floor, run, kHeapOnFloor));
    }
    if (*model.creep != '\0')
      plan.quantities.push_back({.id = model.creep,
                                 .quantity = "",
                                 .unit = "",
                                 .runs = {run},
                                 .value = [run, heaps](const SeedResults& seed) {
                                   return surface_drift(seed.at(run, "first").powder,
                                                        seed.at(run, "second").powder, heaps);
                                 }});
  }
  if (!has_own_powder(setting)) add_effect_of_cohesion(plan);
  plan.charts = [models, heaps](const SeedResults& seed) {
    return std::vector{angle_of_repose_chart(models, heaps, seed)};
  };
  return plan;
}

}  // namespace diefill::process::laboratory
