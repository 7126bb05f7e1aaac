// What a calibration makes of the runs there are: which values it fits, what it says of the others.
#include "process/calibration/fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "process/calibration/calibration_results.h"
#include "tests/process/calibration/made_up_runs.h"
#include "tests/process/calibration/normal.h"

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

TEST(FittedValues, FinishedSeedsOfASetWithAFailedRunAreFittedAndTheRemarkSaysSo) {
  MadeUpCalibration made_up;
  made_up.add("slit", {4}, 0.1);
  SimulatedPoints simulated;
  for (const double x : {0.05, 0.3, 0.5, 0.9}) {
    add_point(simulated, "start", x, {{10 * x}});
    simulated.outcomes.back().state = "failed";  // its other seed
  }
  const auto fit = fit_points(made_up.plan, simulated);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->region.best[0], 0.4, 0.03);
  EXPECT_TRUE(has_line(calibration_results(made_up.plan, simulated, fit).remarks,
                       "4 of 4 sets of parameters have failed runs or runs without a value; their other runs "
                       "are used"));
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

/// Friction is fitted, a heap was run for the check: its runs scatter by 3 over seeds, and rise by `slope`
/// over the range of friction.
results::Calibration with_heap_of_slope(double slope, int seeds) {
  MadeUpCalibration made_up;
  made_up.add("slit", {4}, 0.2);
  made_up.add("heap", {30}, 0.5, false);
  SimulatedPoints simulated;
  for (int k = 0; k < 8; ++k) add_point(simulated, "start", 0.05 + 0.12 * k, {{0.5 + 1.2 * k}, {}});
  Normal normal(11);
  for (const double place : {0.4, 0.36, 0.44}) {
    add_point(simulated, place == 0.4 ? "best" : "edge", place, {{4}, {}});
    for (int k = 0; k < seeds; ++k)
      simulated.outcomes.back().values[1].push_back({30 + slope * (place - 0.4) + 3 * normal()});
  }
  return calibration_results(made_up.plan, simulated, fit_points(made_up.plan, simulated));
}

TEST(CalibrationWords, AMeasurementThatChangesByChanceAloneIsNotAdvised) {
  const auto chance = with_heap_of_slope(0, 4);
  ASSERT_EQ(chance.worth.size(), 1U);
  EXPECT_EQ(chance.worth[0].name, "slit, once more");
  EXPECT_TRUE(
      has_line(chance.remarks,
               "what \"heap\" would add to the fit is not estimated: it changes over the powders that "
               "agree by no more than chance explains (10 %); more seeds would tell"));
  EXPECT_EQ(with_heap_of_slope(400, 4).worth.size(), 2U);
}

/// A check that was measured as 10 +- 0.1 g.
std::string verdict(double simulated, double lower, double upper) {
  results::CalibratedMeasurement row;
  row.name = "die";
  row.unit = "g";
  row.fitted = false;
  row.data = {{kNoValue, kNoValue, 10, 0.1, simulated, 0.05, 0.05, lower, upper, kNoValue, 5}};
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

/// A check of so many values, measured with a deviation of 1 g, whose runs at the best powder and at four of
/// the edge have these seeds and this scatter. All powders are the true one.
class CheckedTruth {
 public:
  CheckedTruth(std::size_t values, std::size_t seeds, double scatter)
      : values_(values), seeds_(seeds), scatter_(scatter) {
    made_up_.add("die", std::vector<double>(values, 0), 1, false);
  }
  std::string verdict() {
    for (double& value : made_up_.plan.measurements[0].data.value.values) value = normal_();
    SimulatedPoints simulated;
    for (const char* role : {"best", "edge", "edge", "edge", "edge"}) {
      add_point(simulated, role, 0.4, {{}});
      for (std::size_t k = 0; k < seeds_; ++k) {
        std::vector<double> row;
        for (std::size_t q = 0; q < values_; ++q) row.push_back(scatter_ * normal_());
        simulated.outcomes.back().values[0].push_back(row);
      }
    }
    results::Calibration account;
    add_measurements(account, made_up_.plan, simulated, Fit{});
    return check_verdict(account.measurements.at(0));
  }
  /// Share of many checks that are not predicted within their deviation.
  double share_not_predicted() {
    constexpr int kTrials = 4000;
    int missed = 0;
    for (int trial = 0; trial < kTrials; ++trial)
      missed += verdict().find("is predicted within its deviation") == std::string::npos ? 1 : 0;
    return static_cast<double>(missed) / kTrials;
  }

 private:
  MadeUpCalibration made_up_;
  std::size_t values_, seeds_;
  double scatter_;
  Normal normal_{5};
};

TEST(CheckVerdict, ATruePowderMissesInOnePercentOfCasesWhateverTheSeedsScatter) {
  for (const double scatter : {0.25, 1.0, 4.0})
    EXPECT_NEAR(CheckedTruth(1, 2, scatter).share_not_predicted(), 0.01, 0.005) << scatter;
  for (const double scatter : {0.25, 4.0})
    EXPECT_LT(CheckedTruth(4, 2, scatter).share_not_predicted(), 0.015) << scatter;
}

TEST(CheckVerdict, SaysThatOneSeedLeavesTheScatterUnknown) {
  const std::string unknown = "its scatter over seeds is not known and counts as 0";
  EXPECT_NE(CheckedTruth(1, 1, 0.1).verdict().find(unknown), std::string::npos);
  EXPECT_NE(CheckedTruth(1, 1, 1000).verdict().find(unknown), std::string::npos);
  EXPECT_EQ(CheckedTruth(1, 2, 0.1).verdict().find(unknown), std::string::npos);
}

}  // namespace
}  // namespace diefill::process::calibration
