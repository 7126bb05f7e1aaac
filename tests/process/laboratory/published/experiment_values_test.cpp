// What experiments read off stored results, and settings of their runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "process/laboratory/published/lactose/shear_cell.h"
#include "process/laboratory/published/scene_experiment.h"
#include "process/results/storage/result_file.h"
#include "process/scene/scene_text.h"
#include "process/scene/snapshot_folder.h"
#include "project_paths.h"
#include "tests/process/results_sample.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::laboratory {
namespace {

LabSetting setting_of(LabSize size) {
  LabSetting setting;
  setting.size = size;
  setting.scenes = std::filesystem::path(DIEFILL_SOURCE_DIR) / "sample_tools/laboratory";
  return setting;
}

LabPlan plan_of(const std::string& name, LabSize size) {
  const auto& all = scene_experiments();
  return std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; })
      ->plan(setting_of(size));
}

double value_of(const LabPlan& plan, const std::string& id, const SeedResults& seed) {
  return std::find_if(plan.quantities.begin(), plan.quantities.end(),
                      [&](const auto& one) { return one.id == id; })
      ->value(seed);
}

Scene scene_of(const LabRun& run, LabSize size) {
  const auto file = setting_of(size).scenes / run.scene;
  return changed_scene(load_scene_text(file), file, run.changes);
}

/// Eight grains, so many of them below z = 0.
results::FillResult ring_with(std::size_t below) {
  auto result = results::sample_result(8);
  for (std::size_t k = 0; k < 8; ++k) result.powder.position[k].z() = k < below ? -0.01 : 0.01;
  return result;
}

void store(const std::filesystem::path& folder, const results::FillResult& result) {
  std::filesystem::create_directories(folder);
  results::write_results(folder, result);
}

TEST(RingMaps, VolumetricFillingIsComparedBeforeTheShoeStrikesOff) {
  const LabPlan plan = plan_of("ring_maps", LabSize::coarse);
  const support::TemporaryFolder folder;
  std::map<std::string, std::filesystem::path> folders;
  for (const auto& [name, below] :
       {std::pair("volumetric, shoe at rest", 2U), std::pair("volumetric, shoe shaken", 8U)}) {
    folders[name] = folder.path() / name;
    store(folders[name], ring_with(8));  // the passage breaks the arch
    store(folders[name] / "snapshots" / snapshot_folder("settled"), ring_with(below));
  }
  EXPECT_DOUBLE_EQ(value_of(plan, "M23", SeedResults(1, folders)), 0.25);
  for (const LabRun& run : plan.runs)
    if (folders.contains(run.name)) {
      const Scene scene = scene_of(run, LabSize::coarse);
      ASSERT_EQ(scene.snapshots.size(), 1U) << run.name;
      EXPECT_EQ(scene.snapshots[0].name, "settled");
    }
}

TEST(HeapSizes, HeapsWithoutASlopeHaveNoVerdict) {
  const LabPlan plan = plan_of("heap_sizes", LabSize::coarse);
  const support::TemporaryFolder folder;
  std::map<std::string, std::filesystem::path> folders;
  for (const LabRun& run : plan.runs) {
    folders[run.name] = folder.path() / run.name;
    store(folders[run.name], results::sample_result());
  }
  EXPECT_TRUE(std::isnan(value_of(plan, "R12", SeedResults(1, folders))));
}

TEST(Drum, TheCoarseSizeTakesStepsTwiceThePublishedOnes) {
  for (const auto& [size, step] : {std::pair(LabSize::coarse, 1.6e-6), std::pair(LabSize::medium, 0.8e-6)})
    EXPECT_DOUBLE_EQ(*scene_of(plan_of("drum", size).runs.front(), size).numerics.time_step, step);
}

TEST(YoungsModulus, SparesGrainsThatAreTooSoftToFall) {
  for (const LabRun& run : plan_of("youngs_modulus", LabSize::coarse).runs)
    EXPECT_GE(scene_of(run, LabSize::coarse).powder.reduced_modulus, 1e6) << run.name;
}

TEST(DiscFriction, IsTheTorqueOverTheLeverOfTheDiscAndItsLoad) {
  constexpr double kFriction = 0.2;
  const FilledCell filled{lh100(), shear_cell(LabSize::coarse)};
  const double disc = filled.radius() - 0.15 * filled.powder.diameter();
  auto result = results::sample_result();
  result.stages = {{"disc", "", 0, 1}};
  results::ProbeSeries probe{"disc", {"time", "force z", "torque z"}, {"s", "N", "N m"}, {}};
  for (int row = 0; row < 10; ++row) {
    const double force = filled.force(row < 5 ? 3e3 : 1e3);
    for (const double value : {0.1 * row, force, -kFriction * 2 / 3 * disc * force})
      probe.values.push_back(value);
  }
  result.probes = {probe};
  const support::TemporaryFolder folder;
  store(folder.path() / "run", result);
  const std::string run = "LH100, mu_s = 0.2";
  const SeedResults seed(1, {{run, folder.path() / "run"}});
  EXPECT_NEAR(value_of(plan_of("disc_friction", LabSize::coarse), run, seed),
              std::atan(kFriction) * 180 / std::numbers::pi, 1e-9);
}

TEST(LogNormalScaling, TakesAFifthOfTheCriticalStep) {
  for (const LabRun& run : plan_of("log_normal_scaling", LabSize::coarse).runs)
    EXPECT_DOUBLE_EQ(scene_of(run, LabSize::coarse).numerics.time_step_fraction, 0.2) << run.name;
}

}  // namespace
}  // namespace diefill::process::laboratory
