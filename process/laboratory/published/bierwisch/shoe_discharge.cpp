// Discharge of the moving shoe through slits of 6 and 10 mm over its speed (Bierwisch 2009, sections 4.1.1
// and 4.1.2, Figs. 4.4 and 4.5): area A_sim (Eq. 4.2) against the measured curve (Eq. 4.1), residual as
// Eqs. 4.3 and 4.4, and each point's deviation. Coarse grains have slits widened by 1.4 times what they are
// larger.
#include <algorithm>
#include <cmath>

#include "process/laboratory/published/bierwisch/discharge_residual.h"
#include "process/laboratory/published/bierwisch/slit_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/run_series.h"

namespace diefill::process::laboratory {
namespace {

struct Model {
  const char* name;
  const char* preset;
  const char* residual;    ///< figure at 6 mm; empty: none
  const char* prediction;  ///< figure at 10 mm
  bool initial = false;    ///< parameters before the fit
};

constexpr Model kModels[] = {{"A1", "ASC100.29 A1", "S01", "S05"},
                             {"B1", "ASC100.29 B1", "S02", "S06"},
                             {"C1", "ASC100.29 C1", "S03", "S07"},
                             {"D1", "ASC100.29 D1", "S04", "S08"},
                             {"A2", "ASC100.29 A2", "", ""},
                             {"D2", "ASC100.29 D2", "", ""},
                             {"A initial", "ASC100.29 initial A", "", "", true},
                             {"B initial", "ASC100.29 initial B", "", "", true},
                             {"C initial", "ASC100.29 initial C", "", "", true},
                             {"D initial", "ASC100.29 initial D", "", "", true}};

constexpr double kNarrow = 0.006, kWide = 0.010;  // m
constexpr double kFastest = 0.8;                  // m/s
constexpr double kSmallResidual = 1e-3;           // that of a powder which follows the curve

std::vector<Model> models_of(const LabSetting& setting) {
  if (has_own_powder(setting)) return {{"powder", "", "residual", "prediction"}};
  return {std::begin(kModels), std::end(kModels)};
}

std::vector<double> speeds_of(const LabSetting& setting) {
  if (setting.size == LabSize::coarse) return {0.18, 0.4, 0.8};
  return {0.1, 0.15, 0.18, 0.25, 0.4, 0.6, 0.8};
}

std::string run_name(const Model& model, double width, double speed) {
  return std::string(model.name) + ", slit " + plain(1e3 * width) + " mm, " + plain(speed) + " m/s";
}

std::vector<std::string> runs_of(const Model& model, double width, const std::vector<double>& speeds) {
  std::vector<std::string> runs;
  for (const double speed : speeds) runs.push_back(run_name(model, width, speed));
  return runs;
}

std::vector<PassagePoint> points_of(const SeedResults& seed, const Model& model, double width,
                                    const std::vector<double>& speeds) {
  std::vector<PassagePoint> points;
  for (const double speed : speeds)
    points.push_back({speed, discharged_area(seed, run_name(model, width, speed))});
  return points;
}

/// S01 to S04: the residual, or so many thousandths as a point deviates by more than what agrees.
double lack_of_agreement(const std::vector<PassagePoint>& points) {
  const double residual = discharge_residual(points, kNarrow),
               deviation = kSmallResidual * largest_deviation(points, kNarrow);
  return std::isfinite(residual + deviation) ? std::max(residual, deviation) : NAN;
}

/// S05 to S08: area over the measured one at the speed that is farthest from agreement, 5 % below and 20 %
/// above the curve. NaN where a speed has no area.
double farthest_ratio(const SeedResults& seed, const Model& model, double width,
                      const std::vector<double>& speeds) {
  constexpr double kBelow = 0.05, kAbove = 0.20;
  double farthest = 1, most = -1;
  for (const double speed : speeds) {
    const double ratio = discharged_area(seed, run_name(model, width, speed)) / measured_area(width, speed);
    if (!std::isfinite(ratio)) return NAN;
    const double deviation = ratio < 1 ? (1 - ratio) / kBelow : (ratio - 1) / kAbove;
    if (deviation > most) most = deviation, farthest = ratio;
  }
  return farthest;
}

/// Share of points at which D2 discharges more than measured and less than A2, by 3 % at least (S09).
double share_between(const SeedResults& seed, const std::vector<double>& speeds) {
  constexpr double kScatter = 1.03;
  double between = 0, all = 0;
  for (const double width : {kNarrow, kWide})
    for (const double speed : speeds) {
      const double d2 = discharged_area(seed, run_name(kModels[5], width, speed));
      const double a2 = discharged_area(seed, run_name(kModels[4], width, speed));
      between += d2 > kScatter * measured_area(width, speed) && a2 > kScatter * d2 ? 1 : 0;
      ++all;
    }
  return between / all;
}

/// Of the fitted parameters, or of the `initial` ones.
results::ExperimentChart shoe_discharge_chart(const std::vector<Model>& models, bool initial, double width,
                                              const std::vector<double>& speeds, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "shoe_discharge_" + plain(1e3 * width) + "mm" + (initial ? "_before_the_fit" : "");
  chart.title = "Discharge of the shoe through a slit of " + plain(1e3 * width) + " mm";
  chart.subtitle = std::string(initial ? "Parameters before the fit; slits" : "Slits") +
                   " widened by 1.4 (d' - d) for grains of size d' in place of d";
  chart.x = {.label = "Speed of the shoe [m/s]"};
  chart.y = {.label = "Discharged area [mm2]", .logarithmic = true};
  results::ExperimentSeries curve{.name = "measured, ASC100.29 (Eq. 4.1)",
                                  .role = results::ExperimentSeries::Role::predicted,
                                  .x = {},
                                  .y = {}};
  for (double speed = speeds.front(); speed <= kFastest + 1e-9; speed += 0.01) {
    curve.x.push_back(speed);
    curve.y.push_back(1e6 * measured_area(width, speed));
  }
  chart.series.push_back(curve);
  for (const Model& model : models) {
    if (model.initial != initial) continue;
    std::vector<PointOfRun> points;
    for (const double speed : speeds) points.push_back({speed, run_name(model, width, speed)});
    add_run_series(chart, seed, model.name, points, [&](const std::string& run) {
      const double area = 1e6 * discharged_area(seed, run);
      return area > 0 ? area : NAN;
    });
  }
  return chart;
}

void add_agreement(const Model& model, const std::vector<double>& speeds, LabPlan& plan) {
  const auto add = [&](const std::string& id, const std::string& quantity, double width,
                       const std::function<double(const SeedResults&)>& value) {
    plan.quantities.push_back({.id = id,
                               .quantity = quantity,
                               .unit = quantity.empty() ? "" : "1",
                               .runs = runs_of(model, width, speeds),
                               .value = value});
  };
  add(model.residual, "", kNarrow,
      [=](const SeedResults& seed) { return lack_of_agreement(points_of(seed, model, kNarrow, speeds)); });
  const std::string alone = "residual, " + std::string(model.name);
  add(alone, alone, kNarrow, [=](const SeedResults& seed) {
    return discharge_residual(points_of(seed, model, kNarrow, speeds), kNarrow);
  });
  add(model.prediction, "", kWide,
      [=](const SeedResults& seed) { return farthest_ratio(seed, model, kWide, speeds); });
}

void add_model(const LabSetting& setting, const Model& model, const std::vector<double>& speeds,
               LabPlan& plan) {
  const LabPowder powder = lab_powder(setting, model.preset, setting.scale());
  for (const double width : {kNarrow, kWide})
    for (const double speed : speeds) {
      const SlitPassage passage{.width = adjusted_slit(width, powder), .speed = speed};
      plan.runs.push_back(
          {run_name(model, width, speed), "slit.toml", slit_changes(setting, powder, passage)});
      const std::string run = plan.runs.back().name;
      plan.quantities.push_back({.id = "area-" + run,
                                 .quantity = "discharged area over the measured one",
                                 .unit = "1",
                                 .runs = {run},
                                 .value = [=](const SeedResults& seed) {
                                   return discharged_area(seed, run) / measured_area(width, speed);
                                 }});
    }
  if (*model.residual == '\0') return;
  add_agreement(model, speeds, plan);
}

}  // namespace

LabPlan plan_shoe_discharge(const LabSetting& setting) {
  const auto models = models_of(setting);
  const auto speeds = speeds_of(setting);
  LabPlan plan;
  for (const Model& model : models) add_model(setting, model, speeds, plan);
  if (!has_own_powder(setting)) {
    LabQuantity order{.id = "S09", .quantity = "", .unit = "", .runs = {}, .value = {}};
    for (const Model* model : {&kModels[4], &kModels[5]})
      for (const double width : {kNarrow, kWide})
        for (const auto& run : runs_of(*model, width, speeds)) order.runs.push_back(run);
    order.value = [speeds](const SeedResults& seed) { return share_between(seed, speeds); };
    plan.quantities.push_back(order);
  }
  plan.charts = [models, speeds](const SeedResults& seed) {
    std::vector<results::ExperimentChart> charts;
    for (const bool initial : {false, true})
      for (const double width : {kNarrow, kWide})
        if (!initial || models.back().initial)
          charts.push_back(shoe_discharge_chart(models, initial, width, speeds, seed));
    return charts;
  };
  return plan;
}

}  // namespace diefill::process::laboratory
