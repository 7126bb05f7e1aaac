// What a calibration writes: JSON and CSV, with holes where there is no value.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "process/results/studies/calibration.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

results::Calibration small_account() {
  results::Calibration account;
  account.title = "A \"plant\" powder";
  account.fitted = true;
  account.parameters.push_back({"powder.friction", "1", 0.1, 1, false, 0.4, 0.35, 0.45, {0.1, 1}, {20, 30}});
  results::CalibratedMeasurement slit;
  slit.name = "slit, wide";
  slit.kind = "figure";
  slit.quantity = "mass";
  slit.unit = "g";
  slit.x_name = "speed";
  slit.x_unit = "m/s";
  slit.data.push_back({0.1, NAN, 12, 0.3, 11.8, 0.1, 0.2, 11.5, 12.1});
  slit.residual = NAN;
  account.measurements.push_back(slit);
  account.points.push_back({"start", {0.4}, "failed", "too soft", NAN, 12.5});
  return account;
}

TEST(CalibrationResult, JsonHasNullsForWhatIsNotKnown) {
  const support::TemporaryFolder folder;
  results::write_calibration(folder.path(), small_account());
  const auto json = nlohmann::json::parse(support::contents(folder.path() / "calibration.json"));
  EXPECT_EQ(json.at("title"), "A \"plant\" powder");
  EXPECT_EQ(json.at("parameters").at(0).at("lower_90"), 0.35);
  EXPECT_TRUE(json.at("measurements").at(0).at("perpendicular_residual").is_null());
  EXPECT_EQ(json.at("measurements").at(0).at("data").at(0).at("measured"), 12);
  EXPECT_FALSE(json.at("measurements").at(0).at("data").at(0).contains("second"));
  EXPECT_TRUE(json.at("points").at(0).at("chi_square").is_null());
  EXPECT_EQ(json.at("points").at(0).at("reason"), "too soft");
  EXPECT_FALSE(json.contains("screening"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "screening.csv"));
}

TEST(CalibrationResult, CsvHasALineForEachValueAndEachPoint) {
  const support::TemporaryFolder folder;
  results::write_calibration(folder.path(), small_account());
  const std::string data = support::contents(folder.path() / "calibration.csv"),
                    points = support::contents(folder.path() / "calibration_points.csv");
  EXPECT_NE(data.find("\"slit, wide\",fit,\"mass\",\"g\",0.1,\"m/s\",,\"\",12,0.3,11.8,0.1,0.2,11.5,12.1\n"),
            std::string::npos)
      << data;
  EXPECT_NE(points.find("\"start\",\"failed\",0.4,,12.5\n"), std::string::npos) << points;
}

TEST(CalibrationResult, AScreeningHasItsEffectsAndTheirMargin) {
  const support::TemporaryFolder folder;
  results::Calibration account = small_account();
  account.screening.runs = 4;
  account.screening.quantities.push_back({"mass", "g", 10, 0.1, 0.3, 5, 1});
  account.screening.effects.push_back({"A", "powder.friction", true, {-1.5}});
  account.screening.quantities[0].regression = {{"A", -0.75}};
  results::write_calibration(folder.path(), account);
  const std::string csv = support::contents(folder.path() / "screening.csv");
  EXPECT_EQ(csv,
            "effect,parameters,\"mass [g]\"\n\"A\",\"powder.friction\",-1.5\n\"standard error\",,0.1\n\"95 % "
            "margin\",,0.3\n");
  const auto json = nlohmann::json::parse(support::contents(folder.path() / "calibration.json"));
  EXPECT_EQ(json.at("screening").at("quantities").at(0).at("effects").at("A"), -1.5);
  const auto& coefficients = json.at("screening").at("quantities").at(0).at("regression_coefficients");
  EXPECT_EQ(coefficients.at("mean"), 10);
  EXPECT_EQ(coefficients.at("A"), -0.75);
}

}  // namespace
}  // namespace diefill::process
