// Poured beds, far coarser than those that are held against the source.
#include <gtest/gtest.h>

#include <cmath>

#include "process/laboratory/bulk_density/log_normal_bed.h"
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

TEST(BulkDensity, ACoarseBedOfManySizesHoldsItsMassAndSettles) {
  LogNormalBed bed;
  bed.variation = 0.4;
  bed.scale = 16;
  bed.share_of_width = 0.12;
  const LogNormalBedFigures figures = settle_log_normal_bed(bed);
  EXPECT_GT(figures.spheres, 100U);
  EXPECT_GT(figures.largest, 2 * figures.smallest);
  EXPECT_LT(figures.kinetic, 1e-3);
  EXPECT_GT(figures.density, 350);
  EXPECT_LT(figures.density, 700);
  EXPECT_GT(figures.coordination, 3);
  // 57.4 kg on every square metre: 90 mm at the densest, 164 mm very loose.
  EXPECT_GT(figures.height, 0.08);
  EXPECT_LT(figures.height, 0.2);
}

TEST(BulkDensity, FiguresOfABedAreThoseOfItsSpheres) {
  engine::SimulationSettings settings;
  settings.types = {{sticky_sphere(0.01)}};
  const auto law = sticky_law(0, engine::laws::JkrLoad::corrected, {});
  settings.contact = engine::one_powder(law, law);
  settings.period = {0.1, 0.1};
  settings.time_step = 1e-6;
  engine::Simulation simulation(settings, {plane_floor()});
  // Wholly inside; half inside; outside.
  simulation.add_grains({engine::NewGrain{.position = {0, 0, 0.04}},
                         engine::NewGrain{.position = {0.04, 0, 0.06}},
                         engine::NewGrain{.position = {0, 0.04, 0.09}}});
  const SphereBedFigures figures = figures_of_bed(simulation);
  const double sphere = 4.0 / 3.0 * M_PI * 1e-6;
  EXPECT_NEAR(figures.density, kStickyDensity * 1.5 * sphere / (0.1 * 0.1 * 0.04), 1e-9);
  EXPECT_NEAR(figures.height, 0.1, 1e-12);
  EXPECT_EQ(figures.coordination, 0);
  EXPECT_EQ(figures.spheres, 3U);
}

TEST(BulkDensity, ModuliAreThoseOfTwoEqualSpheres) {
  EXPECT_NEAR(sticky_modulus(), 1e7 / (2 * (1 - 0.09)), 1);
  EXPECT_NEAR(sticky_shear_modulus(), 1e7 / (4 * (2 - 0.3) * (1 + 0.3)), 1);
}

TEST(BulkDensity, ExperimentsHaveNamesAndQuestions) {
  ASSERT_FALSE(bulk_density_experiments().empty());
  EXPECT_EQ(bulk_density_experiments().front().name, "mono_disperse");
}

}  // namespace
}  // namespace diefill::process::laboratory
