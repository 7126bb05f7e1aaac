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

std::string fill_name(const Model& model, double fill) {
  return std::string(model.name) + ", " + plain(1e3 * fill) + " mm of powder";
}

results::ExperimentChart fill_chart(const std::vector<Model>& models, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "fill_height";
  chart.title = "Discharge over the depth of powder in the shoe";
  chart.subtitle =
      "Slit of 6 mm, 0.18 m/s; published: A1 and B1 rise for shallow powder, C1 and D1 do not, D2 at 10 mm";
  chart.x = {.label = "Depth of the powder [mm]"};
  chart.y = {.label = "Discharged area [mm2]"};
  for (const Model& model : models) {
    std::vector<PointOfRun> points;
    for (const double fill : kFills) points.push_back({1e3 * fill, fill_name(model, fill)});
    add_run_series(chart, seed, model.name, points,
                   [&](const std::string& run) { return 1e6 * discharged_area(seed, run); });
  }
  return chart;
}

std::string packing_name(double speed) {
  return "D2, slit 10 mm, " + plain(speed) + " m/s";
}

/// The same figure stands once for each published packing.
void add_packing(const char* ids[], int count, const std::string& run,
                 const std::function<double(const SeedResults&)>& value, LabPlan& plan) {
  for (int k = 0; k < count; ++k)
    plan.quantities.push_back({.id = ids[k], .quantity = "", .unit = "", .runs = {run}, .value = value});
}

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

/// Grains of the published size through a slice of the published depth (2.16 mm) that fill the same area.
double published_grains(const SeedResults& seed, const std::string& run) {
  constexpr double kDepth = 2.16e-3;                                                        // m
  constexpr double kSolid = 7 * 4.0 / 3 * 3.141592653589793 * 7.84e-5 * 7.84e-5 * 7.84e-5;  // m^3
  const double fraction = results::figure_of(seed.at(run, "settled"), "bulk_solid_fraction");
  return discharged_area(seed, run) * fraction * kDepth / kSolid;
}

/// %, standard deviation of the discharge over its mean.
double relative_scatter(const std::vector<SeedResults>& seeds, const std::string& run) {
  std::vector<double> areas;
  for (const SeedResults& seed : seeds) areas.push_back(discharged_area(seed, run));
  const Sample sample = sample_of(areas);
  return 100 * sample.scatter / sample.mean;
}

/// The published figure `quantity` of a model, and the ratios of its discharges as rows of their own.
void add_ratios(const Model& model, LabQuantity quantity, LabPlan& plan) {
  const auto ratio = [model](double fill, double other) {
    return [=](const SeedResults& seed) {
      return discharged_area(seed, fill_name(model, fill)) / discharged_area(seed, fill_name(model, other));
    };
  };
  const std::string id = quantity.id;
  quantity.value = ratio(kFills[0], kFills[2]);
  if (id == "G05") quantity.value = [model](const SeedResults& seed) { return share_of_d2(seed, model); };
  plan.quantities.push_back(quantity);
  for (const double fill : {kFills[0], kFills[1]}) {
    const std::string name = plain(1e3 * fill) + " mm over 41 mm, " + model.name;
    plan.quantities.push_back({.id = "discharge, " + name,
                               .quantity = "discharge, " + name,
                               .unit = "1",
                               .runs = quantity.runs,
                               .value = ratio(fill, kFills[2])});
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
  for (const Model& model : models) {
    const LabPowder powder = lab_powder(setting, model.preset, setting.scale());
    LabQuantity quantity{.id = model.id, .quantity = "", .unit = "", .runs = {}, .value = {}};
    for (const double fill : kFills) {
      const SlitPassage passage{.width = adjusted_slit(0.006, powder), .speed = kSlowShoe, .fill = fill};
      plan.runs.push_back({fill_name(model, fill), "slit.toml", slit_changes(setting, powder, passage)});
      quantity.runs.push_back(plan.runs.back().name);
    }
    add_ratios(model, quantity, plan);
  }
  plan.charts = [models](const SeedResults& seed) { return std::vector{fill_chart(models, seed)}; };
  return plan;
}

LabPlan plan_packing_scatter(const LabSetting& setting) {
  LabPlan plan;
  const LabPowder powder = lab_powder(setting, "ASC100.29 D2", setting.scale());
  for (const double speed : {kSlowShoe, kFastShoe}) {
    const SlitPassage passage{.width = adjusted_slit(0.010, powder), .speed = speed};
    plan.runs.push_back({packing_name(speed), "slit.toml", slit_changes(setting, powder, passage)});
  }
  const auto fraction_of = [](const std::string& run) {
    return [run](const SeedResults& seed) {
      return results::figure_of(seed.at(run, "settled"), "bulk_solid_fraction");
    };
  };
  const auto grains_of = [](const std::string& run) {
    return [run](const SeedResults& seed) { return published_grains(seed, run); };
  };
  const auto area_of = [](const std::string& run) {
    return [run](const SeedResults& seed) { return 1e6 * discharged_area(seed, run); };
  };
  const std::string slow = packing_name(kSlowShoe), fast = packing_name(kFastShoe);
  const char* slow_fractions[] = {"Q01", "Q04", "Q07"};
  const char* slow_grains[] = {"Q02", "Q05", "Q08"};
  const char* slow_areas[] = {"Q03", "Q06", "Q09"};
  const char* fast_fractions[] = {"Q10", "Q13"};
  const char* fast_grains[] = {"Q11", "Q14"};
  const char* fast_areas[] = {"Q12", "Q15"};
  add_packing(slow_fractions, 3, slow, fraction_of(slow), plan);
  add_packing(slow_grains, 3, slow, grains_of(slow), plan);
  add_packing(slow_areas, 3, slow, area_of(slow), plan);
  add_packing(fast_fractions, 2, fast, fraction_of(fast), plan);
  add_packing(fast_grains, 2, fast, grains_of(fast), plan);
  add_packing(fast_areas, 2, fast, area_of(fast), plan);
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
