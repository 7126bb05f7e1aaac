// The cell of a powder tester: stresses from forces and torques, means and peaks of their curves, and that
// all runs of a shear test begin alike.
#include "process/laboratory/published/lactose/shear_cell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <set>

#include "geometry/cad/read_binary_stl.h"
#include "process/laboratory/published/experiments.h"
#include "project_paths.h"

namespace diefill::process::laboratory {
namespace {

TEST(ShearCell, StressesAreThoseOfADiscUnderUniformStress) {
  const FilledCell filled{lh100(), {}};
  const double radius = 5 * 2 * 66.67e-6;
  EXPECT_NEAR(filled.radius(), radius, 1e-12);
  EXPECT_NEAR(filled.force(3e3), 3e3 * std::numbers::pi * radius * radius, 1e-12);
  // The integral of tau r over the disc, in rings.
  constexpr int kRings = 10000;
  double torque = 0;
  for (int n = 0; n < kRings; ++n) {
    const double r = (n + 0.5) / kRings * radius;
    torque += 1.9e3 * r * 2 * std::numbers::pi * r * radius / kRings;
  }
  EXPECT_NEAR(filled.shear_stress(torque), 1.9e3, 1e-3);
  EXPECT_NEAR(filled.angle(3) * filled.radius(), 3 * filled.powder.diameter(), 1e-15);
  EXPECT_NEAR(filled.turn_speed() * filled.seconds(3), filled.angle(3), 1e-12);
}

TEST(ShearCell, ThePeakIsTheHighestMeanOverItsLength) {
  ShearCurve curve;
  for (int n = 0; n <= 100; ++n) {
    curve.time.push_back(0.01 * n);
    curve.normal.push_back(1e3);
    // A hump of 0.2 s that is higher than one row's spike is on the mean.
    curve.shear.push_back(n == 20 ? 900 : n > 50 && n <= 70 ? 600 : 300);
  }
  const MeanStress peak = highest_stress(curve, 0, 1, 0.1);
  EXPECT_NEAR(peak.shear, 600, 1e-9);
  EXPECT_NEAR(peak.normal, 1e3, 1e-9);
  // What lies outside does not count.
  EXPECT_LT(highest_stress(curve, 0.75, 1, 0.1).shear, 310);
  EXPECT_NEAR(mean_stress(curve, 0.755, 1).shear, 300, 1e-9);
  EXPECT_TRUE(std::isnan(mean_stress(curve, 2, 3).shear));
}

/// Of a drawing, a binary STL file.
geometry::Box box_of(const std::string& drawing) {
  const auto path = std::filesystem::path(DIEFILL_SOURCE_DIR) / "sample_tools/laboratory" / drawing;
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  return geometry::read_binary_stl(bytes).parts.front().mesh.bounding_box();
}

/// Least height of a drawing.
double lowest_of(const std::string& drawing) {
  return box_of(drawing).lower.z();
}

TEST(ShearCell, TheRimOfTheDiscIsAsFarFromTheCellAsDrawn) {
  for (const int bore : {10, 16}) {
    const double rim = box_of("disc_" + std::to_string(bore) + ".stl").upper.x();
    EXPECT_NEAR(rim, 0.5 * bore - ShearCell::kRimGap, 1e-5) << bore;
  }
}

TEST(ShearCell, VanesOfTheSmallerHeadAreScaledWithItsCell) {
  EXPECT_DOUBLE_EQ(ShearCell{16}.vane_depth(), 3);
  EXPECT_DOUBLE_EQ(ShearCell{10}.vane_depth(), 1.875);
  EXPECT_NEAR(lowest_of("shear_head_16.stl"), -3, 1e-5);
  EXPECT_NEAR(lowest_of("shear_head_10.stl"), -1.875, 1e-5);
}

/// Scenes of a plan but for the stress that the head is unloaded to.
std::set<std::string> beginnings_of(const LabPlan& plan) {
  std::set<std::string> beginnings;
  for (const LabRun& run : plan.runs) {
    std::string acts = run.changes.set;
    const auto from = acts.find("step.unload.force"), to = acts.find('\n', from);
    EXPECT_NE(from, std::string::npos);
    beginnings.insert(acts.erase(from, to - from));
  }
  return beginnings;
}

TEST(ShearCell, RunsOfAPowderShareTheirPreShear) {
  const LabPlan plan = plan_shear_tester({});
  EXPECT_EQ(plan.runs.size(), 12U);           // five stresses, and one at half the speed
  EXPECT_EQ(beginnings_of(plan).size(), 4U);  // of two powders at two speeds
}

/// Those of the plan's first runs.
std::set<std::string> beginnings_of_first(LabPlan plan, std::size_t count) {
  plan.runs.resize(count);
  return beginnings_of(plan);
}

TEST(ShearCell, RunsThatAreComputedAtTheSameTimeAreOfDifferentBeds) {
  LabSetting setting;
  setting.scenes = std::filesystem::path(DIEFILL_SOURCE_DIR) / "sample_tools/laboratory";
  EXPECT_EQ(beginnings_of_first(plan_lh220_shear_range(setting), 33).size(), 33U);
  EXPECT_EQ(beginnings_of_first(plan_shear_tester(setting), 2).size(), 2U);
}

TEST(ShearCell, BedsOfADesignAreSharedByTheirNormalStresses) {
  LabSetting setting;
  setting.scenes = std::filesystem::path(DIEFILL_SOURCE_DIR) / "sample_tools/laboratory";
  for (const auto plan_of : {plan_lactose_shear_screening, plan_lactose_shear_range, plan_lh100_shear_range,
                             plan_lh220_shear_range}) {
    const LabPlan plan = plan_of(setting);
    EXPECT_EQ(plan.runs.size(), 66U);
    EXPECT_EQ(beginnings_of(plan).size(), 33U);
  }
}

}  // namespace
}  // namespace diefill::process::laboratory
