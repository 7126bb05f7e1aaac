// Published designs: planted effects come back, and the regression describes what it can.
#include "process/laboratory/published/lactose/lactose_designs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "process/input/scene_error.h"
#include "process/laboratory/published/lactose/design_study.h"
#include "project_paths.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::laboratory {
namespace {

std::vector<DesignRun> runs_of(const std::string& table) {
  return design_runs(
      std::filesystem::path(DIEFILL_SOURCE_DIR) / "sample_tools/laboratory/lactose_designs.csv", table);
}

int level(const DesignRun& run, Factor factor) {
  return run.levels[static_cast<std::size_t>(factor)];
}

TEST(LactoseDesigns, HaveHighAndLowInHalfTheRunsAndACentre) {
  for (const auto& [table, factors] :
       std::vector<std::pair<std::string, int>>{{"T17", 12}, {"T18", 8}, {"T8-LH100", 8}, {"T8-LH220", 8}}) {
    const auto runs = runs_of(table);
    ASSERT_EQ(runs.size(), 33U) << table;
    EXPECT_EQ(std::count(runs.back().levels.begin(), runs.back().levels.end(), 0), 12) << table;
    int varied = 0;
    for (std::size_t factor = 0; factor < kFactors; ++factor) {
      int sum = 0, size = 0;
      for (const auto& run : runs) sum += run.levels[factor], size += std::abs(run.levels[factor]);
      EXPECT_EQ(sum, 0) << table << ' ' << factor;
      varied += size > 0 ? 1 : 0;
      EXPECT_TRUE(size == 0 || size == 32) << table << ' ' << factor;
    }
    EXPECT_EQ(varied, factors) << table;
  }
  EXPECT_NEAR(runs_of("T8-LH100")[0].powder.radius, 66.67e-6, 1e-12);
}

TEST(LactoseDesigns, PlantedEffectsComeBack) {
  for (const char* table : {"T17", "T18", "T8-LH100", "T8-LH220"}) {
    const auto runs = runs_of(table);
    std::vector<double> plain, bent;
    for (const auto& run : runs) {
      const int hamaker = level(run, Factor::hamaker), young = level(run, Factor::young);
      plain.push_back(20 + 3 * hamaker - 2 * young);
      bent.push_back(plain.back() + 1.5 * hamaker * young);
    }
    EXPECT_NEAR(effect_of(runs, plain, Factor::hamaker), 6, 1e-12) << table;
    EXPECT_NEAR(effect_of(runs, plain, Factor::young), -4, 1e-12) << table;
    EXPECT_NEAR(regression_error(runs, plain, false), 0, 1e-10) << table;
    EXPECT_NEAR(regression_error(runs, bent, true), 0, 1e-10) << table;
    // 1.5 of 20 or so in all runs but the centre.
    EXPECT_GT(regression_error(runs, bent, false), 5) << table;
    EXPECT_LT(regression_error(runs, bent, false), 12) << table;
  }
}

TEST(LactoseDesigns, AWrongFileIsNamed) {
  const support::TemporaryFolder folder;
  const auto file = folder.write("designs.csv", "table,run\nT17,0,1\n");
  try {
    design_runs(file, "T17");
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("designs.csv:2: found 3 fields, expected 14"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(design_runs(folder.path() / "none.csv", "T17"), SceneError);
}

/// A number that rises by 2 from low to high Hamaker constant and falls by 6 with friction.
DesignStudy planted() {
  DesignStudy study;
  study.design = runs_of("T17");
  study.metrics = {{"planted", "1", [design = study.design](const SeedResults&, std::size_t k) {
                      return 10.0 + level(design[k], Factor::hamaker) -
                             3 * level(design[k], Factor::friction);
                    }}};
  return study;
}

TEST(DesignStudy, SaysWhichFactorsLeadAndWithWhichSign) {
  const DesignStudy study = planted();
  const SeedResults seed(1, {});
  const Effects all = effects_of(study, seed, study.metrics.front().value);
  EXPECT_NEAR(of(all, Factor::hamaker), 2, 1e-9);
  EXPECT_NEAR(of(all, Factor::friction), -6, 1e-9);
  EXPECT_NEAR(largest_other(all, {Factor::friction}), 2, 1e-9);
  EXPECT_NEAR(agreeing(all, {{Factor::hamaker, 1}, {Factor::friction, 1}}), 0.5, 1e-12);
}

TEST(DesignStudy, HasExtremesAndErrorsOfEachMetric) {
  LabPlan plan;
  const DesignStudy study = planted();
  add_ranges(plan, study, "P");
  add_errors(plan, study, "1");
  ASSERT_EQ(plan.quantities.size(), 4U);
  const SeedResults seed(1, {});
  EXPECT_EQ(plan.quantities[0].id, "P-range-min-planted");
  EXPECT_EQ(plan.quantities[0].value(seed), 6);
  EXPECT_EQ(plan.quantities[1].value(seed), 14);
  EXPECT_EQ(plan.quantities[2].id, "ERR-1-no-planted");
  EXPECT_NEAR(plan.quantities[2].value(seed), 0, 1e-9);
}

}  // namespace
}  // namespace diefill::process::laboratory
