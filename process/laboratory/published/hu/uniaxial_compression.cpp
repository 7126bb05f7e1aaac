// Uniaxial compression of a bed of spheres enlarged l times, three methods of scaling forces (Hu 2024,
// section 4.2): stress on the plate over strain from the first 100 Pa. The coarse size has beds of 50 mm;
// sizes are l = 4 against 2, as l = 1 takes 1.6e11 sphere-steps.
#include <algorithm>
#include <cmath>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/results/none.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kDiameter = 5e-4, kWidth = 0.014;  // m, original spheres; period
constexpr double kTouch = 100;                      // Pa, where strain begins
constexpr double kAbove = 1.02;                     // fill heights: above the bed, denser than it is poured

struct Sizes {
  double reference, enlarged;  ///< l
  double fill;                 ///< m
};

Sizes sizes_of(LabSize size) {
  if (size == LabSize::coarse) return {2, 4, 0.050};
  return size == LabSize::medium ? Sizes{2, 4, 0.100} : Sizes{1, 2, 0.100};
}

std::string run_name(int method, double enlargement) {
  return "method " + std::to_string(method) + ", l = " + plain(enlargement);
}

LabRun uniaxial_compression_run(int method, double enlargement, double fill) {
  LabRun run{run_name(method, enlargement), "compression.toml", {}};
  std::string& set = run.changes.set;
  set += line("powder.grain_diameter", millimetres(kDiameter * enlargement));
  set += line("contact.coarse_graining", "\"Hu chapter 4 method " + std::to_string(method) + '"');
  set += line("pour.to", point_in_millimetres(0.5 * kWidth, 0.5 * kWidth, fill + 0.01));
  set += line("pour.fill_height", millimetres(fill));
  set += line("tool.plate.position", point_in_millimetres(0, 0, 4.4 * fill + 0.022));
  set += line("step.approach.distance", millimetres((4.4 - kAbove) * fill + 0.02));
  set += line("step.touch.distance", millimetres(0.2 * fill));
  set += line("step.press.distance", millimetres(0.12 * fill));
  return run;
}

/// Stress (Pa) over strain, from the first 100 Pa on.
struct Curve {
  std::vector<double> strain, stress;
};

Curve curve_of(const SeedResults& seed, const std::string& run, double fill) {
  constexpr double kSpeed = 5e-3;  // m/s, of the plate
  const auto& result = seed.of(run);
  const auto stage = std::find_if(result.stages.rbegin(), result.stages.rend(),
                                  [](const auto& one) { return one.tool == "plate"; });
  Curve curve;
  if (stage == result.stages.rend()) return curve;
  double touched = -1;
  for (const auto& probe : result.probes)
    for (std::size_t k = 0; k < probe.values.size(); k += probe.columns.size()) {
      const double time = probe.values[k], stress = std::abs(probe.values[k + 3]) / (kWidth * kWidth);
      if (time < stage->start || time > stage->end) continue;
      if (touched < 0 && stress >= kTouch) touched = time;
      if (touched < 0) continue;
      curve.strain.push_back((time - touched) * kSpeed / fill);
      curve.stress.push_back(stress);
    }
  return curve;
}

/// Pa at a strain, mean over 0.002 about it; NaN beyond the curve.
double stress_at(const Curve& curve, double strain) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < curve.strain.size(); ++k)
    if (std::abs(curve.strain[k] - strain) < 1e-3) sum += curve.stress[k], ++count;
  return count > 0 ? sum / count : kNone;
}

/// Mean of |relative difference| over strains 0.03 to 0.1.
double mean_difference(const Curve& curve, const Curve& reference) {
  double sum = 0, count = 0;
  for (double strain = 0.03; strain <= 0.1; strain += 0.0025) {
    const double difference = stress_at(curve, strain) / stress_at(reference, strain) - 1;
    if (!std::isfinite(difference)) continue;
    sum += std::abs(difference);
    ++count;
  }
  return count > 0 ? sum / count : kNone;
}

results::ExperimentChart uniaxial_compression_chart(const Sizes& sizes, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "uniaxial_compression";
  chart.title = "Stress of a bed under uniaxial compression";
  chart.subtitle = "Published: method 1 is the same for all l; methods 2 and 3 overestimate";
  chart.x = {.label = "Strain from 100 Pa [1]"};
  chart.y = {.label = "Stress on the plate [kPa]"};
  const auto add = [&](const std::string& run) {
    if (!seed.has(run)) return;
    Curve curve = curve_of(seed, run, sizes.fill);
    for (double& stress : curve.stress) stress *= 1e-3;
    chart.series.push_back({run, results::ExperimentSeries::Role::predicted, curve.strain, curve.stress});
  };
  add(run_name(1, sizes.reference));
  for (const int method : {1, 2, 3}) add(run_name(method, sizes.enlarged));
  return chart;
}

}  // namespace

LabPlan plan_uniaxial_compression(const LabSetting& setting) {
  const Sizes sizes = sizes_of(setting.size);
  LabPlan plan;
  plan.runs.push_back(uniaxial_compression_run(1, sizes.reference, sizes.fill));
  for (const int method : {1, 2, 3})
    plan.runs.push_back(uniaxial_compression_run(method, sizes.enlarged, sizes.fill));
  const std::string reference = run_name(1, sizes.reference);
  const auto curve = [sizes](const SeedResults& seed, const std::string& run) {
    return curve_of(seed, run, sizes.fill);
  };
  plan.quantities.push_back({.id = "UNI-1",
                             .quantity = "mean difference of stress from l = " + plain(sizes.reference) +
                                         ", M1, strain 0.03 to 0.1",
                             .unit = "1",
                             .runs = {reference, run_name(1, sizes.enlarged)},
                             .value = [=](const SeedResults& seed) {
                               return mean_difference(curve(seed, run_name(1, sizes.enlarged)),
                                                      curve(seed, reference));
                             }});
  const double l = sizes.enlarged;
  for (const int method : {2, 3})
    plan.quantities.push_back({.id = "UNI-" + std::to_string(method),
                               .quantity = "",
                               .unit = "",
                               .runs = {run_name(1, l), run_name(method, l)},
                               .value = [=](const SeedResults& seed) {
                                 const double ratio = stress_at(curve(seed, run_name(method, l)), 0.1) /
                                                      stress_at(curve(seed, run_name(1, l)), 0.1);
                                 return ratio / (method == 2 ? std::pow(l, 1.5) : l);
                               }});
  plan.charts = [sizes](const SeedResults& seed) {
    return std::vector{uniaxial_compression_chart(sizes, seed)};
  };
  return plan;
}

}  // namespace diefill::process::laboratory
