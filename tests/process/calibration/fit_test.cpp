// What a calibration makes of the runs there are: which values it fits, what it says of the others.
#include "process/calibration/fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "process/calibration/calibration_results.h"
#include "tests/process/calibration/made_up_runs.h"

namespace diefill::process::calibration {
namespace {

TEST(FittedValues, PlacesThatMostRunsLackAreLeftOutAndTheOthersFitted) {
  MadeUpCalibration made_up;
  made_up.add("slit", {4, 2, 2.2}, 0.1);
  SimulatedPoints simulated;
  for (int k = 0; k < 8; ++k) {
    const double x = 0.05 + 0.12 * k;
    add_point(simulated, "start", x, {{10 * x, k % 4 == 0 ? 5 * x : kNoValue, 3 - 2 * x}});
  }
  const auto fit = fit_points(made_up.plan, simulated);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->places, (std::vector<std::vector<std::size_t>>{{0, 2}}));
  EXPECT_EQ(fit->likelihood->data(), 2U);
  EXPECT_NEAR(fit->region.best[0], 0.4, 0.03);
  const auto account = calibration_results(made_up.plan, simulated, fit);
  EXPECT_EQ(account.data, 2U);
  const auto& slit = account.measurements.at(0);
  EXPECT_NE(slit.remark.find("1 of its 3 values are left out"), std::string::npos) << slit.remark;
  EXPECT_NEAR(slit.data[0].simulated, 4, 0.2);
  EXPECT_TRUE(std::isnan(slit.data[1].simulated));
  EXPECT_TRUE(std::isnan(slit.data[1].lower));
  EXPECT_NEAR(slit.data[2].simulated, 2.2, 0.1);
  EXPECT_TRUE(std::isfinite(slit.residual));
  EXPECT_TRUE(std::isfinite(account.points.at(1).chi_square));
}

TEST(FittedValues, AValueThatOnlySomeRunsHaveIsFittedFromThese) {
  MadeUpCalibration made_up;
  made_up.add("heap", {4}, 0.1);
  SimulatedPoints simulated;
  for (int k = 0; k < 8; ++k) {
    const double x = 0.05 + 0.12 * k;
    add_point(simulated, "start", x,
              {k % 2 == 0 ? std::vector<double>{10 * x} : std::vector<double>()});  // the others left no heap
  }
  const auto fit = fit_points(made_up.plan, simulated);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->region.best[0], 0.4, 0.03);
}

TEST(FittedValues, TheMeasurementWithTooFewOfThemIsNamed) {
  MadeUpCalibration made_up;
  made_up.add("slit", {4}, 0.1);
  made_up.add("heap", {30}, 1);
  SimulatedPoints simulated;
  for (const double x : {0.1, 0.4, 0.6, 0.9})
    add_point(simulated, "start", x,
              {{10 * x}, x < 0.5 ? std::vector<double>{30 + x} : std::vector<double>()});
  EXPECT_FALSE(fit_points(made_up.plan, simulated));
  EXPECT_EQ(why_no_fit(made_up.plan, simulated),
            "too few runs gave values of \"heap\": 2 sets of parameters have them, at least 3 are needed");
}

TEST(CalibrationWords, SimulationsThatAreTooFewAreNamedBesideTheAgreement) {
  MadeUpCalibration made_up;
  made_up.add("slit", {9}, 1e-3);
  SimulatedPoints simulated;
  for (const double x : {0.1, 0.5, 0.9}) add_point(simulated, "start", x, {{100 * x * x}});
  const auto few = calibration_results(made_up.plan, simulated, fit_points(made_up.plan, simulated));
  EXPECT_TRUE(has_line(few.remarks, "the simulations are too few: they add"));
  SimulatedPoints many;
  made_up.plan.measurements[0].data.deviation.values = {5};
  for (int k = 0; k < 12; ++k)
    add_point(many, "start", 0.04 + 0.08 * k, {{100 * std::pow(0.04 + 0.08 * k, 2)}});
  const auto enough = calibration_results(made_up.plan, many, fit_points(made_up.plan, many));
  EXPECT_FALSE(has_line(enough.remarks, "too few"));
}

TEST(Profiles, OfACalibrationAreLeastAtItsBestPowder) {
  MadeUpCalibration made_up;
  made_up.add("slit", {4}, 0.05);
  SimulatedPoints simulated;
  for (const double x : {0.05, 0.2, 0.3, 0.38, 0.43, 0.6})
    add_point(simulated, "start", x, {{10 * x + 0.2 * std::sin(40 * x)}});
  const auto fit = fit_points(made_up.plan, simulated);
  ASSERT_TRUE(fit);
  const auto account = calibration_results(made_up.plan, simulated, fit);
  const auto& along = account.parameters.at(0);
  const auto least = std::min_element(along.profile.begin(), along.profile.end());
  const auto at = along.profile_at.at(static_cast<std::size_t>(least - along.profile.begin()));
  const double node = along.profile_at[1] - along.profile_at[0];
  EXPECT_NEAR(at, along.best, node);
  EXPECT_GE(*least, account.chi_square);
}

TEST(CalibrationWords, ACheckHasAVerdictAndAWorthWhereItWasRunOftenEnough) {
  MadeUpCalibration made_up;
  made_up.add("slit", {4}, 0.1);
  made_up.add("die", {1}, 0.1, false);
  SimulatedPoints simulated;
  for (int k = 0; k < 8; ++k) add_point(simulated, "start", 0.05 + 0.12 * k, {{0.5 + 1.2 * k}, {}});
  const auto account = [&] {
    return calibration_results(made_up.plan, simulated, fit_points(made_up.plan, simulated));
  };
  EXPECT_FALSE(has_line(account().insights, "the check"));  // it was not run
  add_point(simulated, "best", 0.4, {{4}, {1.05}});
  add_point(simulated, "edge", 0.37, {{}, {0.97}});
  const auto twice = account();
  EXPECT_TRUE(has_line(twice.insights, "the check \"die\" is predicted within its deviation"));
  EXPECT_TRUE(has_line(twice.remarks, "what \"die\" would add to the fit is not estimated"));
  add_point(simulated, "edge", 0.43, {{}, {1.1}});
  const auto enough = account();
  EXPECT_FALSE(has_line(enough.remarks, "not estimated"));
  ASSERT_EQ(enough.worth.size(), 2U);
  EXPECT_TRUE(enough.worth[0].name == "die, used to fit" || enough.worth[1].name == "die, used to fit");
}

/// A check that was measured as 10 +- 0.1 g.
std::string verdict(double simulated, double lower, double upper) {
  results::CalibratedMeasurement row;
  row.name = "die";
  row.unit = "g";
  row.fitted = false;
  row.data = {{kNoValue, kNoValue, 10, 0.1, simulated, 0.05, 0.05, lower, upper}};
  return check_verdict(row);
}

TEST(CheckVerdict, SaysWhetherTheMeasurementIsPredicted) {
  EXPECT_EQ(verdict(10.1, 9.9, 10.3), "the check \"die\" is predicted within its deviation");
  EXPECT_EQ(verdict(10.6, 9.9, 11.2),
            "the check \"die\" is predicted within the region's range, but not by the best powder within its "
            "deviation");
  EXPECT_EQ(
      verdict(12, 11.9, 12.1),
      "the check \"die\" is missed: measured 10 +- 0.1 g, simulated 12 g (11.9 to 12.1 g over the powders "
      "that agree)");
  EXPECT_NE(verdict(kNoValue, kNoValue, kNoValue).find("has no value at the best parameters"),
            std::string::npos);
}

}  // namespace
}  // namespace diefill::process::calibration
