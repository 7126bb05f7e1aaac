// What else changes the discharge of the moving shoe: depth of the powder (Bierwisch 2009, section 4.1.6,
// Fig. 4.8), and the packing alone (section 4.2.1, Table 4.5). Slits are widened for coarse grains as in
// shoe_discharge.cpp.
#include <cmath>

#include "process/compare/statistics.h"
#include "process/laboratory/published/bierwisch/slit_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/run_series.h"
#include "process/results/figure_table.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kFills[] = {0.010, 0.019, 0.041};   // m
constexpr double kSlowShoe = 0.18, kFastShoe = 0.4;  // m/s
constexpr double kShallowSpeeds[] = {0.18, 0.6};     // m/s, with every depth

struct Model {
  const char* id;
  const char* name;
  const char* preset;
};

constexpr Model kModels[] = {{"G01", "A1", "ASC100.29 A1"},
                             {"G02", "B1", "ASC100.29 B1"},
                             {"G03", "C1", "ASC100.29 C1"},
                             {"G04", "D1", "ASC100.29 D1"},
                             {"G05", "D2", "ASC100.29 D2"}};

/// Without a speed at the slow one, whose runs are those of the published figures.
std::string fill_name(const Model& model, double fill, double speed = kSlowShoe) {
  const std::string at = speed == kSlowShoe ? "" : ", " + plain(speed) + " m/s";
  return std::string(model.name) + ", " + plain(1e3 * fill) + " mm of powder" + at;
}

results::ExperimentChart fill_chart(const std::vector<Model>& models, double speed, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "fill_height_" + plain(speed) + "_m_per_s";
  chart.title = "Discharge over the depth of powder in the shoe at " + plain(speed) + " m/s";
  chart.subtitle =
      speed == kSlowShoe
          ? "Slit of 6 mm; published: A1 and B1 rise for shallow powder, C1 and D1 do not, D2 at 10 mm"
          : "Slit of 6 mm; published: measured discharge does not rise for shallow powder above 0.4 m/s";
  chart.x = {.label = "Depth of the powder [mm]"};
  chart.y = {.label = "Discharged area [mm2]"};
  for (const Model& model : models) {
    std::vector<PointOfRun> points;
    for (const double fill : kFills) points.push_back({1e3 * fill, fill_name(model, fill, speed)});
    add_run_series(chart, seed, model.name, points,
                   [&](const std::string& run) { return 1e6 * discharged_area(seed, run); });
  }
  return chart;
}

std::string packing_name(double speed) {
  return "D2, slit 10 mm, " + plain(speed) + " m/s";
}

/// Published figures of the packings at one speed: each stands there once for every packing; empty: no more.
struct PackingFigures {
  double speed;  ///< m/s
  const char* fractions[3];
  const char* grains[3];
  const char* areas[3];
};

constexpr PackingFigures kPackings[] = {
    {kSlowShoe, {"Q01", "Q04", "Q07"}, {"Q02", "Q05", "Q08"}, {"Q03", "Q06", "Q09"}},
    {kFastShoe, {"Q10", "Q13", ""}, {"Q11", "Q14", ""}, {"Q12", "Q15", ""}}};

/// G05: share of three statements that hold: the shallowest powder discharges more than the deeper two, by
/// what packings scatter, and these agree.
double share_of_d2(const SeedResults& seed, const Model& model) {
  constexpr double kScatter = 0.03;
  double area[3];
  for (std::size_t k = 0; k < 3; ++k) area[k] = discharged_area(seed, fill_name(model, kFills[k]));
  if (!std::isfinite(area[0] + area[1] + area[2])) return NAN;
  return ((area[0] > (1 + kScatter) * area[1]) + (area[0] > (1 + kScatter) * area[2]) +
          (std::abs(area[1] / area[2] - 1) <= kScatter)) /
         3.0;
}

/// %, standard deviation of the discharge over its mean.
double relative_scatter(const std::vector<SeedResults>& seeds, const std::string& run) {
  std::vector<double> areas;
  for (const SeedResults& seed : seeds) areas.push_back(discharged_area(seed, run));
  const Sample sample = sample_of(areas);
  return 100 * sample.scatter / sample.mean;
}

/// Discharge from a depth of powder over that from the deepest.
double rise_of(const SeedResults& seed, const Model& model, double fill, double speed) {
  return discharged_area(seed, fill_name(model, fill, speed)) /
         discharged_area(seed, fill_name(model, kFills[2], speed));
}

/// The runs of a model at one speed, and the ratios of its discharges.
void add_fills(const LabSetting& setting, const Model& model, double speed, LabPlan& plan) {
  const LabPowder powder = lab_powder(setting, model.preset, setting.scale());
  std::vector<std::string> runs;
  for (const double fill : kFills) {
    const SlitPassage passage{.width = adjusted_slit(0.006, powder), .speed = speed, .fill = fill};
    runs.push_back(fill_name(model, fill, speed));
    plan.runs.push_back({runs.back(), "slit.toml", slit_changes(setting, powder, passage)});
  }
  if (speed == kSlowShoe)
    plan.quantities.push_back(
        {.id = model.id, .quantity = "", .unit = "", .runs = runs, .value = [=](const SeedResults& seed) {
           const bool d2 = std::string(model.id) == "G05";
           return d2 ? share_of_d2(seed, model) : rise_of(seed, model, kFills[0], speed);
         }});
  for (const double fill : {kFills[0], kFills[1]}) {
    const std::string name = "discharge, " + plain(1e3 * fill) + " mm over 41 mm, " + model.name +
                             (speed == kSlowShoe ? "" : ", " + plain(speed) + " m/s");
    plan.quantities.push_back(
        {.id = name, .quantity = name, .unit = "1", .runs = runs, .value = [=](const SeedResults& seed) {
           return rise_of(seed, model, fill, speed);
         }});
  }
}

results::ExperimentChart packing_scatter_chart(const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "packing_scatter";
  chart.title = "Discharge of several packings of the same powder";
  chart.x = {.label = "Speed of the shoe [m/s]", .lower = 0};
  chart.y = {.label = "Discharged area [mm2]", .lower = 0};
  add_run_series(chart, seed, "packing " + std::to_string(seed.seed()),
                 {{kSlowShoe, packing_name(kSlowShoe)}, {kFastShoe, packing_name(kFastShoe)}},
                 [&](const std::string& run) { return 1e6 * discharged_area(seed, run); });
  return chart;
}

}  // namespace

LabPlan plan_fill_height(const LabSetting& setting) {
  std::vector<Model> models(std::begin(kModels), std::end(kModels));
  if (has_own_powder(setting)) models = {{"G01", "powder", ""}};
  LabPlan plan;
  for (const Model& model : models)
    for (const double speed : kShallowSpeeds) add_fills(setting, model, speed, plan);
  plan.charts = [models](const SeedResults& seed) {
    std::vector<results::ExperimentChart> charts;
    for (const double speed : kShallowSpeeds) charts.push_back(fill_chart(models, speed, seed));
    return charts;
  };
  return plan;
}

LabPlan plan_packing_scatter(const LabSetting& setting) {
  using Value = std::function<double(const SeedResults&)>;
  LabPlan plan;
  const LabPowder powder = lab_powder(setting, "ASC100.29 D2", setting.scale());
  for (const PackingFigures& one : kPackings) {
    const std::string run = packing_name(one.speed);
    const SlitPassage passage{.width = adjusted_slit(0.010, powder), .speed = one.speed};
    plan.runs.push_back({run, "slit.toml", slit_changes(setting, powder, passage)});
    const auto add = [&](const char* const(&ids)[3], const Value& value) {
      for (const char* id : ids)
        if (*id != '\0')
          plan.quantities.push_back({.id = id, .quantity = "", .unit = "", .runs = {run}, .value = value});
    };
    add(one.fractions, [run](const SeedResults& seed) {
      return results::figure_of(seed.at(run, "settled"), "bulk_solid_fraction");
    });
    add(one.grains, [=](const SeedResults& seed) { return published_grains(seed, run, powder); });
    add(one.areas, [run](const SeedResults& seed) { return 1e6 * discharged_area(seed, run); });
  }
  const std::string slow = packing_name(kSlowShoe);
  plan.quantities.push_back({.id = "Q16",
                             .quantity = "",
                             .unit = "",
                             .runs = {slow},
                             .value = {},
                             .over_seeds = [slow](const std::vector<SeedResults>& seeds) {
                               return relative_scatter(seeds, slow);
                             }});
  plan.charts = [](const SeedResults& seed) { return std::vector{packing_scatter_chart(seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
