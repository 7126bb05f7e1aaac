// Steady discharge through slits while the shoe passes (Bierwisch 2009, section 3.2.2, Figs. 3.5 and 3.6,
// Table C.3): solid rate over slit width for several grain sizes; the offset c for which all lie on one curve
// over D - c d, and how far they lie about one over D - 1.4 d.
#include <algorithm>
#include <cmath>
#include <limits>

#include "process/laboratory/published/bierwisch/slit_collapse.h"
#include "process/laboratory/published/bierwisch/slit_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/powder/empty_annulus.h"
#include "process/results/figure_table.h"
#include "process/results/none.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kSpeed = 0.18;  // m/s

/// A case of Table C.3.
struct Case {
  const char* id;
  const char* name;
  const char* preset;
  const char* set;                     ///< changes of the preset
  std::vector<double> scales, widths;  ///< sizes over the calibrated one; m
  bool fixed_work = false;             ///< w of the calibrated size for all sizes
};

std::string run_name(const Case& one, double scale, double width) {
  return std::string(one.name) + ", size " + plain(scale) + ", slit " + plain(1e3 * width) + " mm";
}

std::vector<Case> cases_of(const LabSetting& setting) {
  const bool coarse = setting.size == LabSize::coarse, medium = setting.size == LabSize::medium;
  const std::vector<double> spheres = coarse   ? std::vector{4.0, 6.0}
                                      : medium ? std::vector{2.0, 4.0}
                                               : std::vector{1.0, 1.5, 2.0};
  const std::vector<double> clumps = coarse   ? std::vector{4.0, 6.0}
                                     : medium ? std::vector{2.0, 4.0}
                                              : std::vector{0.5, 1.0, 2.0, 4.0};
  const std::vector<double> widths =
      coarse ? std::vector{9e-3, 11.5e-3, 14e-3} : std::vector{6e-3, 8e-3, 10e-3, 12e-3, 14e-3};
  if (has_own_powder(setting)) return {{"F01", "powder", "", "", clumps, widths}};
  const char* free = "powder.friction = 0.5\npowder.work_of_adhesion = \"0 J/m^2\"\n";
  const char* cohesive = "powder.friction = 1.0\npowder.work_of_adhesion = \"0.01 J/m^2\"\n";
  return {
      {"F01", "A", "ASC100.29 initial A", free, spheres, widths},
      {"F02", "D", "ASC100.29 initial D", free, clumps, widths},
      {"F03", "D cohesive", "ASC100.29 initial D", cohesive, clumps, widths},
      {"F04", "D, w fixed", "ASC100.29 initial D", "powder.friction = 1.0\n", clumps, {widths.back()}, true}};
}

SlitPassage passage_of(const LabSetting& setting, double width) {
  SlitPassage passage{.width = width, .speed = kSpeed};
  passage.past = false;
  if (setting.size == LabSize::coarse) passage.fill = 0.015;
  return passage;
}

LabRun slit_flow_run(const LabSetting& setting, const Case& one, double scale, double width) {
  LabPowder powder = lab_powder(setting, one.preset, scale);
  powder.changes.set += one.set;
  if (one.fixed_work) powder.changes.set += line("powder.work_of_adhesion", with_unit(0.01 / scale, "J/m^2"));
  return {run_name(one, scale, width), "slit.toml",
          slit_changes(setting, powder, passage_of(setting, width))};
}

SlitPoints points_of(const SeedResults& seed, const LabSetting& setting, const Case& one) {
  SlitPoints points;
  for (const double scale : one.scales)
    for (const double width : one.widths) {
      const std::string run = run_name(one, scale, width);
      if (!seed.has(run)) continue;
      points.rate.push_back(steady_solid_rate(seed, run, passage_of(setting, width)));
      points.width.push_back(width);
      points.diameter.push_back(results::figure_of(seed.of(run), "grain_diameter_m"));
    }
  return points;
}

/// Rate (mm^2/s) over D - 1.4 d (mm), a series for each grain size.
std::vector<results::ExperimentSeries> series_of_sizes(const SlitPoints& points) {
  std::vector<results::ExperimentSeries> series;
  for (std::size_t k = 0; k < points.rate.size(); ++k) {
    const std::string name = "d = " + plain(std::round(1e6 * points.diameter[k]) / 1e3) + " mm";
    if (series.empty() || series.back().name != name) series.push_back({.name = name, .x = {}, .y = {}});
    series.back().x.push_back(1e3 * (points.width[k] - kEmptyAnnulus * points.diameter[k]));
    series.back().y.push_back(1e6 * points.rate[k]);
  }
  return series;
}

/// a (D - 1.4 d)^(3/2), with the mean a of all points.
results::ExperimentSeries one_curve(const std::vector<results::ExperimentSeries>& sizes) {
  double sum = 0, count = 0, widest = 0;
  for (const auto& size : sizes)
    for (std::size_t k = 0; k < size.x.size(); ++k) {
      sum += size.y[k] / std::pow(size.x[k], 1.5);
      ++count;
      widest = std::max(widest, size.x[k]);
    }
  results::ExperimentSeries curve{.name = "published: one curve (power 1.5)",
                                  .role = results::ExperimentSeries::Role::predicted,
                                  .x = {},
                                  .y = {}};
  constexpr int kNodes = 60;
  for (int k = 0; k <= kNodes && count > 0; ++k) {
    curve.x.push_back(widest * k / kNodes);
    curve.y.push_back(sum / count * std::pow(curve.x.back(), 1.5));
  }
  return curve;
}

results::ExperimentChart slit_flow_chart(const LabSetting& setting, const Case& one,
                                         const SeedResults& seed) {
  const SlitPoints points = points_of(seed, setting, one);
  const SlitOffset offset = fitted_offset(points);
  results::ExperimentChart chart;
  chart.name = "slit_flow_" + std::string(one.id);
  chart.title = "Steady discharge through slits: " + std::string(one.name);
  chart.subtitle = "Shoe at 0.18 m/s; published: all sizes on one curve over D - 1.4 d";
  char note[120];
  std::snprintf(note, sizeof note,
                "Fitted offset: (%.2f +- %.2f) d. Line: a (D - 1.4 d)^1.5 through the mean.", offset.value,
                offset.error);
  chart.note = note;
  chart.x = {.label = "Slit width minus 1.4 grain sizes [mm]"};
  chart.y = {.label = "Solid volume flow over slice depth [mm2/s]"};
  chart.series = series_of_sizes(points);
  chart.series.push_back(one_curve(chart.series));
  return chart;
}

/// F04: the smallest, over sizes, of the rate with w held over that with w in proportion to the size, through
/// the same slit; the inverse for grains finer than the calibrated size, where w is the same.
double effect_of_fixed_work(const SeedResults& seed, const LabSetting& setting, const Case& fixed,
                            const Case& scaled) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const double scale : fixed.scales) {
    if (scale == 1) continue;
    const double width = fixed.widths.back();
    const auto rate = [&](const Case& one) {
      return steady_solid_rate(seed, run_name(one, scale, width), passage_of(setting, width));
    };
    const double ratio = rate(fixed) / rate(scaled);
    if (!std::isfinite(ratio)) return kNone;
    smallest = std::min(smallest, scale > 1 ? ratio : 1 / ratio);
  }
  return smallest;
}

/// F04: the rate with w held against that of the case before it.
void add_fixed_work(const LabSetting& setting, const std::vector<Case>& cases, LabPlan& plan) {
  const auto fixed = std::find_if(cases.begin(), cases.end(), [](const Case& one) { return one.fixed_work; });
  if (fixed == cases.end()) return;
  const Case held = *fixed, scaled = *std::prev(fixed);
  LabQuantity quantity{.id = held.id, .quantity = "", .unit = "", .runs = {}, .value = {}};
  for (const Case& one : {held, scaled})
    for (const double scale : held.scales) quantity.runs.push_back(run_name(one, scale, held.widths.back()));
  quantity.value = [=](const SeedResults& seed) { return effect_of_fixed_work(seed, setting, held, scaled); };
  plan.quantities.push_back(quantity);
}

/// F01 to F03: how the sizes collapse, and what that is made of.
void add_collapse(const LabSetting& setting, const Case& one, const std::vector<std::string>& runs,
                  LabPlan& plan) {
  const auto add = [&](const std::string& id, const std::string& quantity,
                       double (*value)(const SlitPoints&)) {
    plan.quantities.push_back(
        {.id = id,
         .quantity = quantity,
         .unit = quantity.empty() ? "" : "1",
         .runs = runs,
         .value = [=](const SeedResults& seed) { return value(points_of(seed, setting, one)); }});
  };
  const std::string name = one.name, id = one.id;
  add(id, "", lack_of_slit_collapse);
  add(id + "-offset", "offset of the slit width over d, " + name,
      [](const SlitPoints& points) { return fitted_offset(points).value; });
  add(id + "-error", "standard error of the offset, " + name,
      [](const SlitPoints& points) { return fitted_offset(points).error; });
  add(id + "-spread", "spread of the rate about one curve over D - 1.4 d, " + name, spread_about_one_curve);
}

/// F05: the solid fraction of D1.
void add_bulk_fraction(const LabSetting& setting, LabPlan& plan) {
  const std::string run = "D1, slit 10 mm";
  const LabPowder powder = lab_powder(setting, "ASC100.29 D1", setting.scale());
  plan.runs.push_back({run, "slit.toml", slit_changes(setting, powder, passage_of(setting, 0.010))});
  plan.quantities.push_back(
      {.id = "F05", .quantity = "", .unit = "", .runs = {run}, .value = [run](const SeedResults& seed) {
         return results::figure_of(seed.at(run, "settled"), "bulk_solid_fraction");
       }});
}

}  // namespace

LabPlan plan_slit_flow(const LabSetting& setting) {
  const auto cases = cases_of(setting);
  LabPlan plan;
  for (const Case& one : cases) {
    std::vector<std::string> runs;
    for (const double scale : one.scales)
      for (const double width : one.widths) {
        plan.runs.push_back(slit_flow_run(setting, one, scale, width));
        runs.push_back(plan.runs.back().name);
      }
    if (!one.fixed_work) add_collapse(setting, one, runs, plan);
  }
  add_fixed_work(setting, cases, plan);
  if (!has_own_powder(setting)) add_bulk_fraction(setting, plan);
  plan.charts = [cases, setting](const SeedResults& seed) {
    std::vector<results::ExperimentChart> charts;
    for (const Case& one : cases)
      if (!one.fixed_work) charts.push_back(slit_flow_chart(setting, one, seed));
    return charts;
  };
  return plan;
}

}  // namespace diefill::process::laboratory
