// What the powder's uncertainty does, and whether that can be distinguished from the scatter over seeds.
#include "process/results/studies/powder_spread.h"

#include <gtest/gtest.h>

#include <limits>

#include "process/results/studies/quantiles.h"

namespace diefill::results {
namespace {

TEST(PowderSpread, IsANumberOnlyWhereItIsSignificant) {
  SpreadFigure figure{"filled_mass_kg", "filled mass", "g", {}, {}, 12.1, 0.1, 12.1, 0.32, 0.3, true};
  EXPECT_EQ(spread_text(figure), "filled mass 12.1 g: +-0.3 g by the powder, +-0.1 g over seeds");
  figure.significant = false;
  EXPECT_EQ(spread_text(figure),
            "filled mass 12.1 g: +-0.1 g over seeds; the effect of the powder cannot be distinguished from "
            "the scatter over seeds");
  figure.powder = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(spread_text(figure), "filled mass 12.1 g: +-unknown g by the powder, +-0.1 g over seeds");
}

TEST(PowderSpread, VarianceRatiosOfChanceAreThoseOfFishersTable) {
  EXPECT_NEAR(variance_ratio_exceeded(2, 1, 0.1), 49.5, 0.01);
  EXPECT_NEAR(variance_ratio_exceeded(11, 3, 0.1), 5.222, 0.01);
  EXPECT_NEAR(variance_ratio_exceeded(4, 10, 0.1), 2.605, 0.001);
}

}  // namespace
}  // namespace diefill::results
