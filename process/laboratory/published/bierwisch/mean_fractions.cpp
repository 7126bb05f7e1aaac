// Mean solid fractions of powder in the shoe (Bierwisch 2009, section 4.1.5, Table 4.4): settled, and while
// the shoe moves at 0.18 m/s over a closed plate. Solid over cell volume of all grains at least 2 d below the
// surface (OP-11).
#include <cmath>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/results/figure_table.h"

namespace diefill::process::laboratory {
namespace {

struct Model {
  const char* name;
  const char* preset;
  const char* settled;  ///< published figure; empty: none
  const char* moving;
  double at_rest, in_motion;  ///< as published, for the chart; NaN: no value
};

constexpr Model kModels[] = {{"A initial", "ASC100.29 initial A", "N01", "N02", 0.59, 0.59},
                             {"A1", "ASC100.29 A1", "N03", "N04", 0.48, 0.49},
                             {"A2", "ASC100.29 A2", "N05", "N06", 0.57, 0.58},
                             {"B initial", "ASC100.29 initial B", "", "", NAN, NAN},
                             {"B1", "ASC100.29 B1", "", "", NAN, NAN},
                             {"C initial", "ASC100.29 initial C", "", "", NAN, NAN},
                             {"C1", "ASC100.29 C1", "", "", NAN, NAN},
                             {"D initial", "ASC100.29 initial D", "N07", "N08", 0.38, 0.38},
                             {"D1", "ASC100.29 D1", "N09", "N10", 0.30, 0.31},
                             {"D2", "ASC100.29 D2", "N11", "N12", 0.32, 0.33}};

std::vector<Model> models_of(const LabSetting& setting) {
  if (has_own_powder(setting)) return {{"powder", "", "settled", "moving", NAN, NAN}};
  return {std::begin(kModels), std::end(kModels)};
}

SceneChanges changes_of(const LabSetting& setting, const Model& model) {
  const LabPowder powder = lab_powder(setting, model.preset, setting.scale());
  const double half = 2.3 * powder.size;
  SceneChanges changes = powder.changes;
  changes.set += line("pour.from", point_in_millimetres(0.004, -half, 0));
  changes.set += line("pour.to", point_in_millimetres(0.036, half, 0.046));
  changes.set += line("numerics.periodic", "{ y = " + millimetres(2 * half) + " }");
  if (!has_own_powder(setting))
    changes.set += line("numerics.time_step", with_unit(2 * powder.size / powder.own_size, "us"));
  return changes;
}

/// `id`: of the published figure, which says what it is; of the user's own powder its name; empty: none.
LabQuantity fraction_of(const LabSetting& setting, const std::string& id, const std::string& run,
                        const std::string& snapshot) {
  const std::string of = has_own_powder(setting) ? "" : ", " + run;
  const std::string name = "solid fraction of powder in the shoe, " + snapshot + of;
  const bool published = !has_own_powder(setting) && !id.empty();
  return {.id = id.empty() ? name : id,
          .quantity = published ? "" : name,
          .unit = published ? "" : "1",
          .runs = {run},
          .value = [=](const SeedResults& seed) {
            return results::figure_of(seed.at(run, snapshot), "bulk_solid_fraction");
          }};
}

results::ExperimentChart mean_fractions_chart(const std::vector<Model>& models, const SeedResults& seed) {
  using Role = results::ExperimentSeries::Role;
  results::ExperimentChart chart;
  chart.name = "mean_fractions";
  chart.title = "Solid fraction of powder in the shoe";
  chart.x = {.label = "Powder, in the order of the subtitle",
             .lower = 0,
             .upper = 1.0 + static_cast<double>(models.size())};
  chart.y = {.label = "Solid fraction [1]"};
  for (std::size_t k = 0; k < models.size(); ++k)
    chart.subtitle += (k == 0 ? "" : ", ") + std::to_string(k + 1) + ": " + models[k].name;
  for (const bool at_rest : {true, false}) {
    const std::string state = at_rest ? "settled" : "moving";
    results::ExperimentSeries published{
        .name = state + ", published", .role = Role::published, .x = {}, .y = {}};
    results::ExperimentSeries here{.name = state + ", here", .role = Role::points, .x = {}, .y = {}};
    for (std::size_t k = 0; k < models.size(); ++k) {
      const double place = static_cast<double>(k) + (at_rest ? 0.92 : 1.08);
      const double value = at_rest ? models[k].at_rest : models[k].in_motion;
      if (std::isfinite(value)) published.x.push_back(place), published.y.push_back(value);
      if (!seed.has(models[k].name)) continue;
      here.x.push_back(place);
      here.y.push_back(results::figure_of(seed.at(models[k].name, state), "bulk_solid_fraction"));
    }
    for (const auto& series : {published, here})
      if (!series.x.empty()) chart.series.push_back(series);
  }
  return chart;
}

}  // namespace

LabPlan plan_mean_fractions(const LabSetting& setting) {
  const auto models = models_of(setting);
  LabPlan plan;
  for (const Model& model : models) {
    plan.runs.push_back({model.name, "shoe.toml", changes_of(setting, model)});
    plan.quantities.push_back(fraction_of(setting, model.settled, model.name, "settled"));
    plan.quantities.push_back(fraction_of(setting, model.moving, model.name, "moving"));
  }
  plan.charts = [models](const SeedResults& seed) { return std::vector{mean_fractions_chart(models, seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
