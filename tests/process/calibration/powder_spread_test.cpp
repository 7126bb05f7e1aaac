// What the powder's uncertainty does, and whether that can be distinguished from the scatter over seeds.
#include "process/results/studies/powder_spread.h"

#include <gtest/gtest.h>

#include <cmath>

#include "process/calibration/powder_samples.h"
#include "process/results/none.h"
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
}

TEST(PowderSpread, SaysHowManyRunsHaveAValueWhereSomeLackIt) {
  SpreadFigure figure{"fill_height_mm",
                      "fill height",
                      "mm",
                      {12, kNone},
                      {12.1, kNone, 12.1},
                      12,
                      kNone,
                      12.1,
                      0.2,
                      kNone,
                      false};
  EXPECT_EQ(
      spread_text(figure),
      "fill height 12.1 mm: too few values to tell the effect of the powder; values of 1 of 2 runs of the "
      "best powder and of 2 of 3 powders");
  figure.of_powders = {kNone, kNone, kNone};
  figure.mean = figure.spread = kNone;
  EXPECT_EQ(
      spread_text(figure),
      "fill height: no value with the powders that were drawn; values of 1 of 2 runs of the best powder "
      "and of 0 of 3 powders");
}

TEST(PowderSpread, ThatIsRoundingAloneIsNone) {
  std::vector<ComparedRun> runs(5);
  for (std::size_t k = 0; k < runs.size(); ++k) runs[k].values["share"] = k % 2 == 0 ? 0.3 : 0.1 + 0.2;
  const SpreadFigure figure = process::calibration::spread_of({"share", "share", "1", {}}, runs, 2);
  EXPECT_EQ(figure.scatter, 0);
  EXPECT_EQ(figure.spread, 0);
  EXPECT_FALSE(figure.significant);
  EXPECT_EQ(spread_text(figure), "share 0.3: the same in all runs");
}

TEST(PowderSpread, OfAnglesCountsRoundTheCircle) {
  const auto spread_of = [](const std::string& key, const std::vector<double>& values) {
    std::vector<ComparedRun> runs(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) runs[k].values[key] = values[k];
    return process::calibration::spread_of({key, key, "deg", {}}, runs, 2);
  };
  const SpreadFigure first = spread_of("solid_fraction_harmonic_1_azimuth_deg", {359, 1, 358, 0, 2});
  EXPECT_NEAR(first.scatter, std::sqrt(2), 1e-9);
  EXPECT_NEAR(first.spread, 2, 1e-9);
  EXPECT_NEAR(std::remainder(first.mean, 360), 0, 1e-9);
  EXPECT_FALSE(first.significant);
  const SpreadFigure second = spread_of("solid_fraction_harmonic_2_azimuth_deg", {179, 1, 178, 0, 2});
  EXPECT_NEAR(second.spread, 2, 1e-9);
  EXPECT_NEAR(spread_of("slope_of_heap_deg", {30, 32, 28, 30, 32}).mean, 30, 1e-9);
}

TEST(PowderSpread, VarianceRatiosOfChanceAreThoseOfFishersTable) {
  EXPECT_NEAR(variance_ratio_exceeded(2, 1, 0.1), 49.5, 0.01);
  EXPECT_NEAR(variance_ratio_exceeded(11, 3, 0.1), 5.222, 0.01);
  EXPECT_NEAR(variance_ratio_exceeded(4, 10, 0.1), 2.605, 0.001);
}

}  // namespace
}  // namespace diefill::results
