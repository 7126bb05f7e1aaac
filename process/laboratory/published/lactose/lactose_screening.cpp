// Compression and tension of the beds of the designs of Kottlan 2018: screening of twelve parameters (Table
// 17, sections 3.2.1 to 3.2.3), calibration designs (Tables 18 and 8): extremes, effects, errors of the
// regression (Tables 9, 10, 19 and 20). 33 beds each, spheres of one size, periodic; coarse: 6 d wide, 10 d
// of powder.
#include <algorithm>
#include <cmath>
#include <limits>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_folder.h"
#include "process/laboratory/published/lactose/design_study.h"
#include "process/laboratory/published/lactose/pressed_bed.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kMeasuredStrength = 64.6;                     // Pa, of LH220 (Table 6)
enum : std::size_t { kBeta, kLoading, kUnloading, kTension };  // of a study's metrics

struct Study : DesignStudy {
  std::vector<PressedBed> beds;
  DesignMetric initial, last;  ///< solid fractions
};

Study study_of(const LabSetting& setting, const std::string& table) {
  const AdhesiveBed bed = setting.size == LabSize::coarse ? AdhesiveBed{6, 10} : AdhesiveBed{10, 20};
  Study study;
  study.design = design_runs(setting.scenes / kLactoseDesigns, table);
  for (std::size_t k = 0; k < study.design.size(); ++k) {
    study.beds.push_back({"run " + std::to_string(k), study.design[k].powder, bed});
    study.runs.push_back(study.beds.back().name);
  }
  const auto metric = [beds = study.beds](double (*value)(const BedMetrics&)) -> DesignMetric {
    return [=](const SeedResults& seed, std::size_t k) { return value(metrics_of(seed, beds[k])); };
  };
  study.metrics = {
      {"beta", "%", metric([](const BedMetrics& of) { return 100 * of.stiffness.beta; })},
      {"k_load", "MPa", metric([](const BedMetrics& of) { return 1e-6 * of.stiffness.loading; })},
      {"k_unload", "MPa", metric([](const BedMetrics& of) { return 1e-6 * of.stiffness.unloading; })},
      {"sigma_tens", "kPa", metric([](const BedMetrics& of) { return 1e-3 * of.strength; })}};
  study.initial = metric([](const BedMetrics& of) { return of.initial_fraction; });
  study.last = metric([](const BedMetrics& of) { return of.final_fraction; });
  return study;
}

/// Correlation of the effects on two metrics, but for static friction.
double likeness(const Effects& one, const Effects& other) {
  double products = 0, ones = 0, others = 0;
  for (std::size_t k = 0; k < kFactors; ++k) {
    if (static_cast<Factor>(k) == Factor::friction) continue;
    products += one[k] * other[k], ones += one[k] * one[k], others += other[k] * other[k];
  }
  return products / std::sqrt(ones * others);
}

/// The largest effect of damping, tangential stiffness and dynamic friction over the largest of all, of the
/// metric where it is largest.
double of_negligible(const Study& study, const SeedResults& seed) {
  double largest = 0;
  for (const NamedMetric& metric : study.metrics) {
    const auto all = effects_of(study, seed, metric.value);
    if (!std::isfinite(all.front())) return std::numeric_limits<double>::quiet_NaN();
    for (const Factor factor :
         {Factor::restitution, Factor::damping_ratio, Factor::tangential_ratio, Factor::dynamic_ratio})
      largest = std::max(largest, std::abs(of(all, factor)) / largest_other(all, {}));
  }
  return largest;
}

LabPlan plan_of(const Study& study) {
  LabPlan plan;
  for (const PressedBed& bed : study.beds) plan.runs.push_back(run_of(bed));
  plan.charts = study_charts(study, {});
  return plan;
}

/// Least gain of the interactions over the metrics: error without over that with them.
double least_gain(const Study& study, const SeedResults& seed) {
  double least = std::numeric_limits<double>::infinity();
  for (const NamedMetric& metric : study.metrics) {
    const auto values = values_of(study, seed, metric.value);
    least = std::min(
        least, regression_error(study.design, values, false) / regression_error(study.design, values, true));
  }
  return least;
}

void add_fraction_effects(LabPlan& plan, const Study& study) {
  plan.quantities.push_back(study_quantity(study, "SCR-phi0", [=](const SeedResults& seed) {
    const auto all = effects_of(study, seed, study.initial);
    return std::min(of(all, Factor::radius), -of(all, Factor::hamaker)) /
           largest_other(all, {Factor::radius, Factor::hamaker});
  }));
  plan.quantities.push_back(study_quantity(study, "SCR-beta", [=](const SeedResults& seed) {
    return likeness(effects_of(study, seed, study.initial),
                    effects_of(study, seed, study.metrics[kBeta].value));
  }));
  plan.quantities.push_back(study_quantity(study, "SCR-phif", [=](const SeedResults& seed) {
    const auto all = effects_of(study, seed, study.last);
    return std::min(std::abs(of(all, Factor::friction)), std::abs(of(all, Factor::young))) /
           largest_other(all, {Factor::friction, Factor::young});
  }));
}

}  // namespace

LabPlan plan_lactose_screening(const LabSetting& setting) {
  const Study study = study_of(setting, "T17");
  LabPlan plan = plan_of(study);
  add_fraction_effects(plan, study);
  std::vector<SignedFactor> signs = {
      {Factor::young, 1}, {Factor::unloading_ratio, 1}, {Factor::depth, -1}, {Factor::friction, -1}};
  plan.quantities.push_back(study_quantity(study, "SCR-kunload", [=](const SeedResults& seed) {
    return agreeing(effects_of(study, seed, study.metrics[kUnloading].value), signs);
  }));
  signs.emplace_back(Factor::tangential_ratio, 1);
  plan.quantities.push_back(study_quantity(study, "SCR-kload", [=](const SeedResults& seed) {
    return agreeing(effects_of(study, seed, study.metrics[kLoading].value), signs);
  }));
  plan.quantities.push_back(study_quantity(study, "SCR-tens", [=](const SeedResults& seed) {
    double above = 0;
    for (const double value : values_of(study, seed, study.metrics[kTension].value))
      above += value > 1e-3 * kMeasuredStrength ? 1 : 0;
    return above / static_cast<double>(study.beds.size());
  }));
  plan.quantities.push_back(
      study_quantity(study, "SCR-neg", [=](const SeedResults& seed) { return of_negligible(study, seed); }));
  return plan;
}

LabPlan plan_lactose_large_range(const LabSetting& setting) {
  const Study study = study_of(setting, "T18");
  LabPlan plan = plan_of(study);
  add_errors(plan, study, "9");
  plan.quantities.push_back(
      study_quantity(study, "CAL-err", [=](const SeedResults& seed) { return least_gain(study, seed); }));
  return plan;
}

LabPlan plan_lh100_range(const LabSetting& setting) {
  const Study study = study_of(setting, "T8-LH100");
  LabPlan plan = plan_of(study);
  add_ranges(plan, study, "L100");
  add_errors(plan, study, "19");
  plan.charts = study_charts(study, setting.scenes / kPublishedFigures, "L100");
  return plan;
}

LabPlan plan_lh220_range(const LabSetting& setting) {
  const Study study = study_of(setting, "T8-LH220");
  LabPlan plan = plan_of(study);
  add_ranges(plan, study, "L220");
  add_errors(plan, study, "20");
  plan.charts = study_charts(study, setting.scenes / kPublishedFigures, "L220");
  return plan;
}

}  // namespace diefill::process::laboratory
