// Angles of repose with the slider (Bierwisch 2009, sections 4.1.3 and 4.1.4, Table 4.3): theta_O of the
// powder that stays on the slider, theta_H of the heap on the floor, and how far surfaces still creep from
// two to four seconds after the draw.
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
  const char* on_slider;  ///< figures, of which R03 to R08 are published; empty: none
  const char* on_floor;
  const char* creep;
};

constexpr Model kModels[] = {{"A1", "ASC100.29 A1", "theta_O, A1", "theta_H, A1", ""},
                             {"A2", "ASC100.29 A2", "R03", "R04", ""},
                             {"D2", "ASC100.29 D2", "R05", "R06", ""},
                             {"D1", "ASC100.29 D1", "R07", "R08", ""},
                             {"B1", "ASC100.29 B1", "", "", "R09"},
                             {"C1", "ASC100.29 C1", "", "", "R10"}};

constexpr const char* kSecond = "second";  // snapshot, 4 s after the draw

std::vector<Model> models_of(const LabSetting& setting) {
  if (has_own_powder(setting)) return {{"powder", "", "theta_O", "theta_H", ""}};
  return {std::begin(kModels), std::end(kModels)};
}

/// Whether its heaps go on moving, so that they are looked at after a given time.
bool creeps(const Model& model) {
  return *model.creep != '\0';
}

/// Of a published figure the figure says what it is.
LabQuantity angle_of(const LabSetting& setting, const Model& model, const char* heap) {
  const std::string id = std::string(heap) == kHeapOnSlider ? model.on_slider : model.on_floor;
  const bool published = id.rfind("theta_", 0) != 0;
  const std::string of = has_own_powder(setting) ? "" : " of " + std::string(model.name);
  LabQuantity angle = heap_angle(model.name, heap, creeps(model) ? kSecond : "");
  angle.id = id;
  angle.quantity = published ? "" : "angle of repose" + of + ", " + heap;
  if (published) angle.unit = "";
  return angle;
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

std::vector<Eigen::AlignedBox3d> heaps_of(const LabSetting& setting, const Model& model) {
  const HeapBoxes heaps = heap_boxes(slider_draw(lab_powder(setting, model.preset, setting.scale())));
  return {heaps.on_floor, heaps.on_slider};
}

results::ExperimentChart angle_of_repose_chart(const std::vector<Model>& models, const LabSetting& setting,
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
    const auto& powder = creeps(model) ? seed.at(model.name, kSecond).powder : seed.of(model.name).powder;
    results::ExperimentSeries surfaces{.name = model.name, .x = {}, .y = {}};
    for (const auto& heap : heaps_of(setting, model)) add_surface(powder, heap, surfaces);
    chart.series.push_back(surfaces);
  }
  return chart;
}

}  // namespace

LabPlan plan_angle_of_repose(const LabSetting& setting) {
  const auto models = models_of(setting);
  LabPlan plan;
  for (const Model& model : models) {
    const std::string run = model.name;
    plan.runs.push_back({run, "repose.toml", repose_changes(setting, model.preset, creeps(model))});
    if (*model.creep == '\0') {
      plan.quantities.push_back(angle_of(setting, model, kHeapOnSlider));
      plan.quantities.push_back(angle_of(setting, model, kHeapOnFloor));
      continue;
    }
    plan.quantities.push_back({.id = model.creep,
                               .quantity = "",
                               .unit = "",
                               .runs = {run},
                               .value = [run, heaps = heaps_of(setting, model)](const SeedResults& seed) {
                                 return surface_drift(seed.at(run, "first").powder,
                                                      seed.at(run, kSecond).powder, heaps);
                               }});
  }
  if (!has_own_powder(setting)) add_effect_of_cohesion(plan);
  plan.charts = [models, setting](const SeedResults& seed) {
    return std::vector{angle_of_repose_chart(models, setting, seed)};
  };
  return plan;
}

}  // namespace diefill::process::laboratory
