// Openings that powder runs out of by itself, in scenes without a shoe.
#include "process/estimate/openings/outlet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/process/estimate/estimate_scene.h"

namespace diefill::process::estimate {
namespace {

constexpr double kMm = 1e-3;

TEST(Outlet, OfASiloIsItsRoundOpeningWithTheRateOfBeverloo) {
  const Estimate found = estimated("laboratory/silo.toml");
  ASSERT_TRUE(found.outlet);
  EXPECT_TRUE(found.outlet->round);
  EXPECT_NEAR(found.outlet->width, 60 * kMm, 1 * kMm);
  const double rate =
      0.58 * found.powder.density * std::sqrt(9.81) * std::pow(found.outlet->width - 1.4 * 4 * kMm, 2.5);
  EXPECT_NEAR(found.outlet->rate, rate, 1e-6 * rate);
  EXPECT_EQ(found.outlet->mass, found.powder.in_shoe);
  EXPECT_TRUE(says(answer_said(found), "out of a round opening of 60")) << answer_said(found);
}

TEST(Outlet, OfASlitHasTheRateOfTheSlitLaw) {
  const Estimate found = estimated("slit_plate/discharge_6mm.toml",
                                   {{"role = \"shoe\"", "role = \"plate\""},
                                    {"position = [\"58 mm\"", "position = [\"0 mm\""},
                                    {"from = [\"42 mm\"", "from = [\"-16 mm\""},
                                    {"to = [\"74 mm\"", "to = [\"16 mm\""},
                                    {"[[step]]\nkind = \"passage\"\ntool = \"shoe\"\ndirection = \"-x\"\n"
                                     "velocity = \"0.18 m/s\"\npassages = 1\nacceleration = \"10 m/s^2\"\n"
                                     "travel = \"116 mm\"",
                                     ""}});
  ASSERT_TRUE(found.outlet);
  EXPECT_FALSE(found.outlet->round);
  EXPECT_NEAR(found.outlet->width, 6 * kMm, 0.05 * kMm);
  EXPECT_NEAR(found.outlet->length, 4.32 * kMm, 1e-9);
  const continuum::SlitFlow slit = {
      found.powder.density, found.outlet->width - 1.4 * (found.grain_diameter - 0.4704 * kMm), 4.32 * kMm};
  EXPECT_NEAR(found.outlet->rate, continuum::steady_rate(found.law.numbers, slit), 1e-3 * found.outlet->rate);
}

TEST(Outlet, IsNoneInAClosedVesselNorBelowAShoe) {
  EXPECT_FALSE(estimated("laboratory/bed.toml").outlet);
  EXPECT_FALSE(estimated("small_dies/square.toml").outlet);
}

TEST(Outlet, PowderThatIsOnlyStirredHasNoFormula) {
  EXPECT_TRUE(
      says(answer_said(estimated("laboratory/drum.toml")), "no formula for powder that is only shaken"));
}

}  // namespace
}  // namespace diefill::process::estimate
