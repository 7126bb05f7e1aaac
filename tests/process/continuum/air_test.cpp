// Air in the way of powder, against its own equations.
#include "process/continuum/air.h"

#include <gtest/gtest.h>

#include <cmath>

namespace diefill::process::continuum {
namespace {

TEST(Air, ArchimedesNumberOfIron) {
  EXPECT_NEAR(archimedes_number(1e-4, 7870), 1.2 * 7868.8 * 9.81 * 1e-12 / (1.8e-5 * 1.8e-5), 1e-6);
  EXPECT_NEAR(air_number(2e-4, 7870) / air_number(1e-4, 7870), 8, 1e-9);
}

TEST(Air, LeavesACavityAsFastAsPowderIsCarried) {
  const double flux = carrying_flux(1e-10, 3000, 1.8e-5, 9.81);
  EXPECT_NEAR(flux * 1.8e-5 / 1e-10, 3000 * 9.81, 1e-6);  // Darcy's gradient is the weight
  EXPECT_NEAR(escape_time(0.02, flux), 0.02 / flux, 1e-12);
}

TEST(Air, SuctionSolvesItsEquation) {
  for (const double own : {0.01, 0.05, 0.19})
    for (const double flux : {0.001, 0.1, 100.0}) {
      const double punch = 0.2, u = suction_speed(own, punch, flux);
      EXPECT_NEAR(u * u, own * own * (1 + (punch - u) / flux), 1e-10);
      EXPECT_GE(u, own);
      EXPECT_LE(u, punch);
    }
  EXPECT_EQ(suction_speed(0.3, 0.2, 0.1), 0.2);            // follows by itself
  EXPECT_NEAR(suction_speed(0.05, 0.2, 1e6), 0.05, 1e-6);  // air passes without pulling
  EXPECT_NEAR(suction_speed(0.05, 0.2, 1e-6), 0.2, 1e-4);  // as a piston in a syringe
}

TEST(Air, SuctionDrawsNothingThroughAnOpeningThatLetsNoGrainPass) {
  for (const double flux : {1e-6, 0.1, 1e6}) {
    EXPECT_EQ(suction_speed(0, 0.2, flux), 0);
    EXPECT_EQ(suction_speed(0, 0, flux), 0);
  }
}

}  // namespace
}  // namespace diefill::process::continuum
