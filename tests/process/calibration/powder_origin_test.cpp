// What a calibration says about its powder: in powder.toml, and where the agreement means little.
#include "process/calibration/powder_origin.h"

#include <gtest/gtest.h>

#include "process/calibration/calibration_results.h"
#include "tests/process/calibration/made_up_runs.h"

namespace diefill::process::calibration {
namespace {

/// The faultless scene with other grains.
std::string scene_with_finer_grains() {
  return support::exchanged(faultless_scene(), "1.88 mm", "1.4 mm");
}

/// Points with the values that `rows` gives for their place.
template <class OfPlace>
SimulatedPoints start_points(const OfPlace& rows) {
  SimulatedPoints simulated;
  for (int k = 0; k < 8; ++k) add_point(simulated, "start", 0.05 + 0.12 * k, rows(0.05 + 0.12 * k));
  return simulated;
}

using Rows = std::vector<std::vector<double>>;

TEST(PowderAccount, SaysOfEachMeasurementWhatWasMeasuredAndWhetherItIsMet) {
  MadeUpCalibration made_up;
  made_up.add("slit", {4, 2, 2.2}, 0.1);
  made_up.add("die", {1}, 0.1, false);
  auto simulated = start_points([](double x) { return Rows{{10 * x, 5 * x, 3 - 2 * x}, {}}; });
  const auto fit = fit_points(made_up.plan, simulated);
  ASSERT_TRUE(fit);
  add_point(simulated, "best", 0.4, {{4, 2, 2.2}, {1.05}});
  const auto account = calibration_results(made_up.plan, simulated, fit);
  const toml::table written = toml::parse(powder_calibration_table(account, made_up.plan));
  const auto& measurements = *written["calibration"]["measurement"].as_array();
  ASSERT_EQ(measurements.size(), 2U);
  const toml::table &slit = *measurements[0].as_table(), &die = *measurements[1].as_table();
  const auto text = [](const toml::table& table, const char* key) {
    return table[key].value<std::string>().value_or("");
  };
  EXPECT_EQ(text(slit, "use"), "fit");
  EXPECT_EQ(text(slit, "quantity"), "mass");
  EXPECT_EQ(text(slit, "scene"), "scene.toml");
  EXPECT_EQ(slit["values"].value<int>(), 3);
  EXPECT_EQ(text(slit, "first_value"), "4 g");
  EXPECT_EQ(text(slit, "last_value"), "2.2 g");
  EXPECT_EQ(text(slit, "last_deviation"), "0.1 g");
  EXPECT_EQ(text(slit, "verdict"), "agrees");
  EXPECT_EQ(text(die, "value"), "1 g");
  EXPECT_EQ(text(die, "deviation"), "0.1 g");
  EXPECT_TRUE(text(die, "verdict").starts_with("is predicted within its deviation")) << text(die, "verdict");
}

TEST(PowderAccount, NamesAnExperimentInPlaceOfAScene) {
  MadeUpCalibration made_up;
  made_up.add("funnel", {30}, 1).experiment = "powder_sheet";
  results::Calibration account;
  account.measurements.push_back({});
  account.measurements[0].name = "funnel";
  const std::string table = powder_calibration_table(account, made_up.plan);
  EXPECT_NE(table.find("experiment = \"powder_sheet\"\n"), std::string::npos) << table;
  EXPECT_EQ(table.find("scene = "), std::string::npos) << table;
}

TEST(PowderAccount, NamesMeasurementsThatWereFittedWithOtherGrains) {
  MadeUpCalibration made_up;
  made_up.add("slit", {4}, 0.1);
  made_up.add("heap", {2}, 0.1).runs[0].text = scene_with_finer_grains();
  const auto simulated = start_points([](double x) { return Rows{{10 * x}, {5 * x}}; });
  const auto fit = fit_points(made_up.plan, simulated);
  ASSERT_TRUE(fit);
  const auto account = calibration_results(made_up.plan, simulated, fit);
  for (const char* name : {"(\"slit\")", "(\"heap\")"})
    EXPECT_NE(account.grains.find(name), std::string::npos) << account.grains;
  EXPECT_TRUE(has_line(account.remarks, "fitted with different grains, walls or stiffness: grain model D"));
  const std::string comment = powder_comment(account, made_up.plan, *fit);
  EXPECT_NE(comment.find("\n# Note: the measurements were fitted with different grains"), std::string::npos)
      << comment;

  made_up.plan.measurements[1].runs[0].text = faultless_scene();
  const auto alike = calibration_results(made_up.plan, simulated, fit);
  EXPECT_FALSE(has_line(alike.remarks, "different grains"));
  EXPECT_EQ(alike.grains.find("\"slit\""), std::string::npos) << alike.grains;
  EXPECT_EQ(powder_comment(alike, made_up.plan, *fit).find("Note"), std::string::npos);
}

TEST(CalibrationWords, AgreementWithoutADegreeOfFreedomProvesNothing) {
  MadeUpCalibration one;
  one.add("slit", {4}, 0.1);
  const auto of_one = start_points([](double x) { return Rows{{10 * x}}; });
  const auto untested = calibration_results(one.plan, of_one, fit_points(one.plan, of_one));
  EXPECT_TRUE(untested.agrees);
  EXPECT_TRUE(
      has_line(untested.insights, "proves nothing: no degree of freedom is left (1 value, 1 parameter)"));
  MadeUpCalibration two;
  two.add("slit", {4, 2}, 0.1);
  const auto of_two = start_points([](double x) { return Rows{{10 * x, 5 * x}}; });
  const auto tested = calibration_results(two.plan, of_two, fit_points(two.plan, of_two));
  EXPECT_TRUE(tested.agrees);
  EXPECT_FALSE(has_line(tested.insights, "proves nothing"));
}

TEST(CalibrationWords, FinerGrainsHaveAVerdictOnEachMeasurement) {
  MadeUpCalibration made_up;
  made_up.plan.finer_grains = "1.4 mm";
  made_up.add("slit", {4}, 0.1);
  auto simulated = start_points([](double x) { return Rows{{10 * x}}; });
  const auto fit = fit_points(made_up.plan, simulated);
  ASSERT_TRUE(fit);
  EXPECT_FALSE(has_line(calibration_results(made_up.plan, simulated, fit).insights, "finer grains"));
  add_point(simulated, "finer", 0.4, {{5}});
  EXPECT_TRUE(has_line(calibration_results(made_up.plan, simulated, fit).insights,
                       "with finer grains (1.4 mm) \"slit\" is 5 g instead of 4"));
}

TEST(CalibrationWords, DeviationsThatExceedTheirValuesAreRemarkedOn) {
  MadeUpCalibration made_up;
  made_up.add("slit", {0.1}, 4);
  const auto account = calibration_results(made_up.plan, {}, std::nullopt);
  EXPECT_NE(account.measurements.at(0).remark.find("its deviation exceeds its value; check that value and"),
            std::string::npos)
      << account.measurements[0].remark;
}

}  // namespace
}  // namespace diefill::process::calibration
