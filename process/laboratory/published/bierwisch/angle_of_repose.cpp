// Angles of repose with the slider (Bierwisch 2009, sections 4.1.3 and 4.1.4, Table 4.3): theta_O of the
// powder that stays on the slider, theta_H of the heap on the floor, and how far surfaces still creep from
// two seconds on. The coarse size has the set-up of half the lengths (sample_tools/tradeoff).
#include <cmath>
#include <limits>

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

/// Half the lengths of the published set-up, with the tools of sample_tools/tradeoff.
std::string half_size(double half) {
  std::string set;
  set += line("tool.floor.file", "\"../tradeoff/floor.stl\"");
  set += line("tool.\"side wall\".file", "\"../tradeoff/side_wall.stl\"");
  set += line("tool.slider.file", "\"../tradeoff/slider.stl\"");
  set += line("pour.from", point_in_millimetres(0.0001, -half, 0));
  set += line("pour.to", point_in_millimetres(0.0199, half, 0.040));
  set += line("pour.fill_height", "\"16 mm\"");
  set += line("measure.heap.\"heap on the floor\".from", point_in_millimetres(-0.048, -half, -0.024));
  set += line("measure.heap.\"heap on the floor\".to", point_in_millimetres(0.020, half, -0.002));
  set += line("measure.heap.\"heap on the slider\".from", point_in_millimetres(-0.010, -half, 0));
  set += line("measure.heap.\"heap on the slider\".to", point_in_millimetres(0.010, half, 0.040));
  return set;
}

std::string full_size(double half) {
  std::string set;
  set += line("pour.from", point_in_millimetres(0.0001, -half, 0));
  set += line("pour.to", point_in_millimetres(0.0299, half, 0.060));
  return set;
}

/// Where a heap creeps: two snapshots a second apart, then it is cleared away, as it never comes to rest.
std::string creep_steps() {
  return "step.\"heaps form\".duration = \"2 s\"\n"
         "step.end.kind = \"clear\"\n"
         "[[snapshot]]\nname = \"first\"\nwhen = { with = \"draw\", delay = \"1 s\" }\n"
         "[[snapshot]]\nname = \"second\"\nwhen = { with = \"draw\", delay = \"2 s\" }\n";
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

/// d/s, mean change of height of the grains between two instants a second apart.
double drift(const SeedResults& seed, const std::string& run) {
  const auto& first = seed.at(run, "first").powder;
  const auto& second = seed.at(run, "second").powder;
  std::map<std::uint64_t, double> height;
  for (std::size_t k = 0; k < first.id.size(); ++k) height[first.id[k]] = first.position[k][2];
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < second.id.size(); ++k) {
    const auto before = height.find(second.id[k]);
    if (before == height.end()) continue;
    sum += std::abs(second.position[k][2] - before->second);
    ++count;
  }
  if (count == 0) return std::numeric_limits<double>::quiet_NaN();
  return sum / count / first.grain_diameter / (second.time - first.time);
}

/// Highest grain in columns 2 d wide, mm; the line breaks where a column has none.
results::ExperimentSeries surface_of(const std::string& name, const results::PowderState& powder) {
  const double width = 2 * powder.grain_diameter;
  std::map<long, double> top;
  for (const auto& place : powder.position) {
    auto& highest = top.try_emplace(std::lround(place[0] / width), place[2]).first->second;
    highest = std::max(highest, place[2]);
  }
  results::ExperimentSeries series{.name = name, .x = {}, .y = {}};
  long before = top.empty() ? 0 : top.begin()->first;
  for (const auto& [column, height] : top) {
    if (column > before + 1) {
      series.x.push_back(1e3 * static_cast<double>(column - 1) * width);
      series.y.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    before = column;
    series.x.push_back(1e3 * static_cast<double>(column) * width);
    series.y.push_back(1e3 * height);
  }
  return series;
}

results::ExperimentChart chart_of(const std::vector<Model>& models, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "angle_of_repose";
  chart.title = "Surfaces of the heaps on slider and floor";
  chart.subtitle =
      "Highest grain in columns of 2 d, one seed; slider above 0 mm; heaps that creep 2 s after the draw; "
      "published angles in the table";
  chart.x = {.label = "x [mm]"};
  chart.y = {.label = "Height over the slider [mm]"};
  for (const Model& model : models) {
    if (!seed.has(model.name)) continue;
    const bool creeps = *model.creep != '\0';
    const auto& powder = creeps ? seed.at(model.name, "second").powder : seed.of(model.name).powder;
    chart.series.push_back(surface_of(model.name, powder));
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
    changes.set += line("numerics.time_step", '"' + plain(2 * powder.size / powder.own_size) + " us\"");
  if (creeps) changes.set += creep_steps();
  return changes;
}

SceneChanges repose_changes(const LabSetting& setting, const std::string& preset, bool creeps) {
  return repose_changes(setting, lab_powder(setting, preset, setting.scale()),
                        setting.size == LabSize::coarse, creeps);
}

LabPlan plan_angle_of_repose(const LabSetting& setting) {
  const auto models = models_of(setting);
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
                                 .value = [run](const SeedResults& seed) { return drift(seed, run); }});
  }
  if (!has_own_powder(setting))
    plan.quantities.push_back(
        {.id = "R11", .quantity = "", .unit = "", .runs = {"D1", "D2"}, .value = [](const SeedResults& seed) {
           return results::figure_of(seed.of("D1"), heap_figure(kHeapOnSlider)) -
                  results::figure_of(seed.of("D2"), heap_figure(kHeapOnSlider));
         }});
  plan.charts = [models](const std::vector<SeedResults>& seeds) {
    return std::vector{chart_of(models, seeds.front())};
  };
  return plan;
}

}  // namespace diefill::process::laboratory
