// Compression and tension of the beds of the designs of Kottlan 2018: screening of twelve parameters (Table
// 17, sections 3.2.1 to 3.2.3), calibration designs (Tables 18 and 8): extremes, effects, errors of the
// regression (Tables 9, 10, 19 and 20). 33 beds each, spheres of one size, periodic; coarse: 6 d wide, 10 d
// of powder.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lactose/lactose_designs.h"
#include "process/laboratory/published/lactose/pressed_bed.h"

namespace diefill::process::laboratory {
namespace {

constexpr const char* kFile = "lactose_designs.csv";
constexpr double kMeasuredStrength = 64.6;  // Pa, of LH220 (Table 6)

struct Study {
  std::vector<DesignRun> runs;
  std::vector<PressedBed> beds;

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const PressedBed& bed : beds) names.push_back(bed.name);
    return names;
  }
};

Study study_of(const LabSetting& setting, const std::string& table) {
  const AdhesiveBed bed = setting.size == LabSize::coarse ? AdhesiveBed{6, 10} : AdhesiveBed{10, 20};
  Study study;
  study.runs = design_runs(setting.scenes / kFile, table);
  for (std::size_t k = 0; k < study.runs.size(); ++k)
    study.beds.push_back({"run " + std::to_string(k), study.runs[k].powder, bed});
  return study;
}

using Metric = double (*)(const BedMetrics&);

struct Named {
  const char* name;  ///< as ids have it
  Metric value;
};
/// In the units of the published figures.
constexpr std::array<Named, 4> kMetrics = {
    {{"beta", [](const BedMetrics& of) { return 100 * of.stiffness.beta; }},
     {"k_load", [](const BedMetrics& of) { return 1e-6 * of.stiffness.loading; }},
     {"k_unload", [](const BedMetrics& of) { return 1e-6 * of.stiffness.unloading; }},
     {"sigma_tens", [](const BedMetrics& of) { return 1e-3 * of.strength; }}}};
constexpr Metric kInitial = [](const BedMetrics& of) { return of.initial_fraction; };
constexpr Metric kFinal = [](const BedMetrics& of) { return of.final_fraction; };

std::vector<double> values_of(const Study& study, const SeedResults& seed, Metric metric) {
  std::vector<double> values;
  for (const PressedBed& bed : study.beds) values.push_back(metric(metrics_of(seed, bed)));
  return values;
}

LabQuantity quantity(const Study& study, const std::string& id,
                     const std::function<double(const SeedResults&)>& value) {
  return {.id = id, .quantity = "", .unit = "", .runs = study.names(), .value = value};
}

/// Effects of all factors on a metric.
std::array<double, kFactors> effects(const Study& study, const SeedResults& seed, Metric metric) {
  const auto values = values_of(study, seed, metric);
  std::array<double, kFactors> all{};
  for (std::size_t k = 0; k < kFactors; ++k) all[k] = effect_of(study.runs, values, static_cast<Factor>(k));
  return all;
}

double of(const std::array<double, kFactors>& all, Factor factor) {
  return all[static_cast<std::size_t>(factor)];
}

/// The largest size of an effect but for these factors'.
double largest_other(const std::array<double, kFactors>& all, std::initializer_list<Factor> but) {
  double largest = 0;
  for (std::size_t k = 0; k < kFactors; ++k)
    if (std::find(but.begin(), but.end(), static_cast<Factor>(k)) == but.end())
      largest = std::max(largest, std::abs(all[k]));
  return largest;
}

/// Share of factors whose effect has the published sign.
double agreeing(const std::array<double, kFactors>& all, const std::vector<std::pair<Factor, int>>& signs) {
  double count = 0;
  for (const auto& [factor, sign] : signs) count += sign * of(all, factor) > 0 ? 1 : 0;
  return count / static_cast<double>(signs.size());
}

/// Correlation of the effects on two metrics, but for static friction.
double likeness(const std::array<double, kFactors>& one, const std::array<double, kFactors>& other) {
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
  for (const Named& metric : kMetrics) {
    const auto all = effects(study, seed, metric.value);
    for (const Factor factor :
         {Factor::restitution, Factor::damping_ratio, Factor::tangential_ratio, Factor::dynamic_ratio})
      largest = std::max(largest, std::abs(of(all, factor)) / largest_other(all, {}));
  }
  return largest;
}

void add_ranges(LabPlan& plan, const Study& study, const std::string& powder) {
  for (const Named& metric : kMetrics)
    for (const bool most : {false, true})
      plan.quantities.push_back(quantity(study, powder + "-range-" + (most ? "max-" : "min-") + metric.name,
                                         [=](const SeedResults& seed) {
                                           const auto values = values_of(study, seed, metric.value);
                                           return most ? *std::max_element(values.begin(), values.end())
                                                       : *std::min_element(values.begin(), values.end());
                                         }));
}

void add_errors(LabPlan& plan, const Study& study, const std::string& table) {
  for (const bool pairs : {false, true})
    for (const Named& metric : kMetrics)
      plan.quantities.push_back(quantity(
          study, "ERR-" + table + (pairs ? "-with-" : "-no-") + metric.name, [=](const SeedResults& seed) {
            return regression_error(study.runs, values_of(study, seed, metric.value), pairs);
          }));
}

LabPlan plan_of(const Study& study) {
  LabPlan plan;
  for (const PressedBed& bed : study.beds) plan.runs.push_back(run_of(bed));
  return plan;
}

/// Least gain of the interactions over the metrics: error without over that with them.
double least_gain(const Study& study, const SeedResults& seed) {
  double least = std::numeric_limits<double>::infinity();
  for (const Named& metric : kMetrics) {
    const auto values = values_of(study, seed, metric.value);
    least = std::min(
        least, regression_error(study.runs, values, false) / regression_error(study.runs, values, true));
  }
  return least;
}

void add_fraction_effects(LabPlan& plan, const Study& study) {
  plan.quantities.push_back(quantity(study, "SCR-phi0", [=](const SeedResults& seed) {
    const auto all = effects(study, seed, kInitial);
    return std::min(of(all, Factor::radius), -of(all, Factor::hamaker)) /
           largest_other(all, {Factor::radius, Factor::hamaker});
  }));
  plan.quantities.push_back(quantity(study, "SCR-beta", [=](const SeedResults& seed) {
    return likeness(effects(study, seed, kInitial), effects(study, seed, kMetrics[0].value));
  }));
  plan.quantities.push_back(quantity(study, "SCR-phif", [=](const SeedResults& seed) {
    const auto all = effects(study, seed, kFinal);
    return std::min(std::abs(of(all, Factor::friction)), std::abs(of(all, Factor::young))) /
           largest_other(all, {Factor::friction, Factor::young});
  }));
}

}  // namespace

LabPlan plan_lactose_screening(const LabSetting& setting) {
  const Study study = study_of(setting, "T17");
  LabPlan plan = plan_of(study);
  add_fraction_effects(plan, study);
  std::vector<std::pair<Factor, int>> signs = {
      {Factor::young, 1}, {Factor::unloading_ratio, 1}, {Factor::depth, -1}, {Factor::friction, -1}};
  plan.quantities.push_back(quantity(study, "SCR-kunload", [=](const SeedResults& seed) {
    return agreeing(effects(study, seed, kMetrics[2].value), signs);
  }));
  signs.emplace_back(Factor::tangential_ratio, 1);
  plan.quantities.push_back(quantity(study, "SCR-kload", [=](const SeedResults& seed) {
    return agreeing(effects(study, seed, kMetrics[1].value), signs);
  }));
  plan.quantities.push_back(quantity(study, "SCR-tens", [=](const SeedResults& seed) {
    double above = 0;
    for (const double value : values_of(study, seed, kMetrics[3].value))
      above += value > 1e-3 * kMeasuredStrength ? 1 : 0;
    return above / static_cast<double>(study.beds.size());
  }));
  plan.quantities.push_back(
      quantity(study, "SCR-neg", [=](const SeedResults& seed) { return of_negligible(study, seed); }));
  return plan;
}

LabPlan plan_lactose_large_range(const LabSetting& setting) {
  const Study study = study_of(setting, "T18");
  LabPlan plan = plan_of(study);
  add_errors(plan, study, "9");
  plan.quantities.push_back(
      quantity(study, "CAL-err", [=](const SeedResults& seed) { return least_gain(study, seed); }));
  return plan;
}

LabPlan plan_lh100_range(const LabSetting& setting) {
  const Study study = study_of(setting, "T8-LH100");
  LabPlan plan = plan_of(study);
  add_ranges(plan, study, "L100");
  add_errors(plan, study, "19");
  return plan;
}

LabPlan plan_lh220_range(const LabSetting& setting) {
  const Study study = study_of(setting, "T8-LH220");
  LabPlan plan = plan_of(study);
  add_ranges(plan, study, "L220");
  add_errors(plan, study, "20");
  return plan;
}

}  // namespace diefill::process::laboratory
