// A small hopper with coarse grains, from settling to the end.
#include "process/laboratory/flow/hopper_run.h"

#include <gtest/gtest.h>

#include <cmath>

#include "process/scene/powder/powder_presets.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kMm = 1e-3;

TEST(Hopper, PartsOfSpheresBelowTheSlitCount) {
  // Two spheres of 1 mm radius on an upright axis, touching.
  results::PowderState powder;
  powder.grain_diameter = 4 * kMm;
  powder.sphere_radius = 1 * kMm;
  powder.sphere_offsets = {{0, 0, 1 * kMm}, {0, 0, -1 * kMm}};
  powder.orientation = {{1, 0, 0, 0}};
  const auto below = [&](double z) {
    powder.position = {{0, 0, z}};
    return grains_below_slit(powder);
  };
  EXPECT_NEAR(below(2 * kMm), 0, 1e-12);  // stands on the slit's plane
  EXPECT_NEAR(below(1 * kMm), 0.25, 1e-12);
  EXPECT_NEAR(below(0), 0.5, 1e-12);
  // A cap of half a radius: (1/2)^2 (1 - 1/6) of 4/3.
  EXPECT_NEAR(below(1.5 * kMm), 0.5 * 0.25 * (5.0 / 6) * 0.75, 1e-12);
  EXPECT_NEAR(below(-3 * kMm), 1, 1e-12);
}

HopperSetup small_hopper() {
  HopperSetup setup;
  setup.powder = powder_preset("ASC100.29 initial D");
  setup.powder.friction = 0.5;
  setup.powder.grain_diameter = 4 * kMm;
  setup.slit = setup.equivalent_slit = 18 * kMm;
  setup.width = 32 * kMm;
  setup.depth = 16 * kMm;
  setup.fill = 44 * kMm;
  setup.from = 44 * kMm;
  setup.to = 24 * kMm;
  return setup;
}

TEST(Hopper, LetsPowderOutThroughItsSlitAlone) {
  const HopperSetup setup = small_hopper();
  double done = 0;
  const auto fields = run_hopper(setup, [&](double share) { done = share; });
  EXPECT_GT(done, 0.9);
  // Powder that got out sideways would leave a bed too thin.
  EXPECT_NEAR(fields.bulk_fraction, 0.37, 0.04);
  const double shut_in = static_cast<double>(fields.grains) * 7 * 4 / 3 * M_PI * std::pow(4 * kMm / 6, 3) /
                         (fields.bulk_fraction * setup.depth * setup.width);
  EXPECT_NEAR(shut_in, setup.fill, 0.15 * setup.fill);
  ASSERT_FALSE(fields.discharged.empty());
  EXPECT_NEAR(fields.discharged.front(), 0, 0.01 * setup.fill * setup.width);
  EXPECT_GT(fields.discharged.back(), 0.2 * setup.fill * setup.width);
  EXPECT_GT(fields.outflow, 0);
}

TEST(Hopper, HasNoOutflowWhereItsLevelNeverCameToTheFieldsOnes) {
  HopperSetup setup = small_hopper();
  setup.fill = 30 * kMm;
  setup.from = 10 * kMm;
  setup.to = 26 * kMm;
  const auto fields = run_hopper(setup, [](double) {});
  ASSERT_FALSE(fields.discharged.empty());
  EXPECT_EQ(fields.samples, 0U);
  EXPECT_TRUE(std::isnan(fields.outflow));
}

TEST(Hopper, MeanOutflowIsThatOfThePackingsThatFlowed) {
  std::vector<HopperFields> packings(3);
  packings[0].outflow = 2;
  packings[1].outflow = std::nan("");
  packings[2].outflow = 4;
  EXPECT_DOUBLE_EQ(mean_of(packings).outflow, 3);
  packings[0].outflow = packings[2].outflow = std::nan("");
  EXPECT_TRUE(std::isnan(mean_of(packings).outflow));
}

}  // namespace
}  // namespace diefill::process::laboratory
