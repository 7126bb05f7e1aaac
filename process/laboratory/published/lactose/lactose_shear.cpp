// Shear tests of the beds of the designs of Kottlan 2018: screening (Table 17, section 3.2.4), large range
// (Table 18, section 3.3.1) and the ranges of LH100 and LH220 (Table 8): pre-shear stress, intercept and
// slope of the yield locus, their extremes, effects and errors of the regression (Tables 9, 10, 13, 19 and
// 20). Coarse: two normal stresses, 700 spheres in a cell of 10 d, twice the speed of the shear tester, 10 d
// of pre-shear at most; the other sizes: the cell of that size and the published five stresses.
#include <algorithm>
#include <cmath>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_folder.h"
#include "process/laboratory/published/lactose/design_study.h"
#include "process/laboratory/published/lactose/sheared_bed.h"

namespace diefill::process::laboratory {
namespace {

enum : std::size_t { kPreshear, kIntercept, kSlope };  // of a study's metrics

struct Study : DesignStudy {
  std::vector<ShearTest> tests;
};

ShearTest test_of(LabSize size, const std::string& name, const AdhesivePowder& powder) {
  if (size != LabSize::coarse) return {name, {powder, shear_cell(size)}, {2e3, 1.75e3, 1.5e3, 1.25e3, 1e3}};
  return {name, {powder, {10, 700, 0.04}}, {2e3, 1e3}, 10, 2};
}

Study study_of(const LabSetting& setting, const std::string& table) {
  Study study;
  study.design = design_runs(setting.scenes / kLactoseDesigns, table);
  for (std::size_t k = 0; k < study.design.size(); ++k) {
    study.tests.push_back(test_of(setting.size, "run " + std::to_string(k), study.design[k].powder));
    for (const auto& run : study.tests.back().run_names()) study.runs.push_back(run);
  }
  const auto metric = [tests = study.tests](double (*value)(const SeedResults&, const ShearTest&)) {
    return DesignMetric([=](const SeedResults& seed, std::size_t k) { return value(seed, tests[k]); });
  };
  study.metrics = {{"tau_pre", "kPa", metric([](const SeedResults& seed, const ShearTest& test) {
                      return 1e-3 * preshear_of(seed, test).shear;
                    })},
                   {"tau_0", "kPa", metric([](const SeedResults& seed, const ShearTest& test) {
                      return 1e-3 * locus_of(seed, test).cohesion;
                    })},
                   {"k_YL", "-", metric([](const SeedResults& seed, const ShearTest& test) {
                      return locus_of(seed, test).slope;
                    })}};
  return study;
}

LabPlan plan_of(const Study& study) {
  LabPlan plan;
  plan.runs = runs_of(study.tests);
  plan.charts = study_charts(study, {});
  return plan;
}

LabPlan range_plan(const LabSetting& setting, const std::string& design, const std::string& powder,
                   const std::string& table) {
  const Study study = study_of(setting, design);
  LabPlan plan = plan_of(study);
  add_ranges(plan, study, powder);
  add_errors(plan, study, table);
  plan.charts = study_charts(study, setting.scenes / kPublishedFigures, powder);
  return plan;
}

/// What makes powder more cohesive, and with which sign.
std::vector<SignedFactor> cohesive() {
  return {
      {Factor::hamaker, 1}, {Factor::radius, -1}, {Factor::unloading_ratio, 1}, {Factor::cohesion_ratio, 1}};
}

/// The smallest of the effects of these, toward more cohesion or of either sign, over the largest of the
/// others.
double leading(const Effects& all, bool either_sign) {
  double smallest = std::abs(of(all, Factor::hamaker));
  std::vector<Factor> factors;
  for (const auto& [factor, sign] : cohesive()) {
    smallest = std::min(smallest, either_sign ? std::abs(of(all, factor)) : sign * of(all, factor));
    factors.push_back(factor);
  }
  return smallest / largest_other(all, factors);
}

}  // namespace

LabPlan plan_lactose_shear_screening(const LabSetting& setting) {
  const Study study = study_of(setting, "T17");
  LabPlan plan = plan_of(study);
  const auto add = [&](const char* id, std::size_t metric, double (*value)(const Effects&)) {
    plan.quantities.push_back(study_quantity(study, id, [=](const SeedResults& seed) {
      return value(effects_of(study, seed, study.metrics[metric].value));
    }));
  };
  add("SCR-taupre", kPreshear, [](const Effects& all) { return leading(all, false); });
  add("SCR-tau0", kIntercept, [](const Effects& all) { return leading(all, true); });
  add("SCR-kYL", kSlope, [](const Effects& all) {
    auto falling = cohesive();
    for (auto& [factor, sign] : falling) sign = -sign;
    return agreeing(all, falling);
  });
  return plan;
}

LabPlan plan_lactose_shear_range(const LabSetting& setting) {
  const Study study = study_of(setting, "T18");
  LabPlan plan = plan_of(study);
  add_errors(plan, study, "9");
  plan.quantities.push_back(study_quantity(study, "CAL-mus", [=](const SeedResults& seed) {
    return of(effects_of(study, seed, study.metrics[kPreshear].value), Factor::friction);
  }));
  return plan;
}

LabPlan plan_lh100_shear_range(const LabSetting& setting) {
  return range_plan(setting, "T8-LH100", "L100", "19");
}

LabPlan plan_lh220_shear_range(const LabSetting& setting) {
  return range_plan(setting, "T8-LH220", "L220", "20");
}

}  // namespace diefill::process::laboratory
