// Poured beds, far coarser than those that are held against the source.
#include <gtest/gtest.h>

#include "process/laboratory/bulk_density/poured_bed.h"
#include "process/laboratory/bulk_density/registry.h"

namespace diefill::process::laboratory {
namespace {

TEST(BulkDensity, ACoarseBedHoldsAllThatWasPouredAndComesToRest) {
  PouredBed bed;
  bed.scale = 10;  // spheres of 5 mm
  bed.pouring_time = 0.4;
  const PouredBedFigures figures = pour_bed(bed);
  EXPECT_EQ(figures.spheres, 257U);  // 16.8 g of 65.4 mg each
  EXPECT_LT(figures.kinetic, 1e-3);
  // 16.8 g on 441 mm^2: 60 mm at the densest packing of equal spheres, 95 mm at a very loose one.
  EXPECT_GT(figures.height, 0.052);
  EXPECT_LT(figures.height, 0.11);
  EXPECT_GT(figures.density, 350);
  EXPECT_LT(figures.density, 640);  // random close packing
  EXPECT_GT(figures.coordination, 3);
  EXPECT_LT(figures.coordination, 8);
}

TEST(BulkDensity, ModuliAreThoseOfTwoEqualSpheres) {
  EXPECT_NEAR(poured_modulus(), 1e7 / (2 * (1 - 0.09)), 1);
  EXPECT_NEAR(poured_shear_modulus(), 1e7 / (4 * (2 - 0.3) * (1 + 0.3)), 1);
}

TEST(BulkDensity, ExperimentsHaveNamesAndQuestions) {
  ASSERT_FALSE(bulk_density_experiments().empty());
  EXPECT_EQ(bulk_density_experiments().front().name, "mono_disperse");
}

}  // namespace
}  // namespace diefill::process::laboratory
