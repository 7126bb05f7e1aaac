// diefill fit-discharge as a user meets it.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"
#include "tests/support/temporary_folder.h"

namespace diefill::app {
namespace {

class FitDischarge : public testing::Test {
 protected:
  /// Masses of the published power law (Bierwisch 2009, Table 5.3), in grams to four digits.
  std::string masses() const {
    std::string text = "speed m/s,mass g\n";
    for (const double speed : {0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 0.8}) {
      const double mass = 0.25 * 3000 * 6e-3 * 33e-3 * 32e-3 * std::pow(std::sqrt(9.81 * 6e-3) / speed, 1.2);
      char line[64];
      std::snprintf(line, sizeof line, "%g,%.4g\n", speed, 1e3 * mass);
      text += line;
    }
    return text;
  }
  std::vector<std::string> words(const std::string& text, const std::vector<std::string>& more = {}) const {
    folder_.write("masses.csv", text);
    std::vector<std::string> all = {"fit-discharge", (folder_.path() / "masses.csv").string(),
                                    "--density",     "3.0 g/cm^3",
                                    "--width",       "6 mm",
                                    "--length",      "33 mm",
                                    "--shoe-length", "32 mm",
                                    "--out",         out().string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  std::filesystem::path out() const { return folder_.path() / "fit"; }
  void expect_refused(const std::vector<std::string>& arguments, const std::string& part) const {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(out()));
  }

  support::TemporaryFolder folder_;
};

TEST_F(FitDischarge, GivesNumbersWithUncertaintyTableAndChart) {
  const Outcome outcome = run_program(words(masses(), {"--law", "5.18"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\nn = 0.19996 ± "), std::string::npos) << outcome.out;
  const auto json = nlohmann::json::parse(support::contents(out() / "fit.json"));
  EXPECT_NEAR(json.at("coefficients").at("C_S").at("value").get<double>(), 0.25, 1e-3);
  EXPECT_NEAR(json.at("coefficients").at("n").at("value").get<double>(), 0.20, 1e-3);
  EXPECT_LT(json.at("coefficients").at("n").at("deviation").get<double>(), 1e-3);
  EXPECT_EQ(json.at("covariance").size(), 2U);
  EXPECT_EQ(support::contents(out() / "fit.png").substr(1, 3), "PNG");
  const std::string table = support::contents(out() / "fit.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 8);
}

TEST_F(FitDischarge, ItsLawServesAnEstimate) {
  ASSERT_EQ(run_program(words(masses())).exit_code, 0);  // by its columns: 5.17
  const auto json = nlohmann::json::parse(support::contents(out() / "fit.json"));
  EXPECT_EQ(json.at("law"), "5.17");
  EXPECT_GT(json.at("largest_x").get<double>(), 2);
}

TEST_F(FitDischarge, RefusesBadInputInOneLineAndWritesNothing) {
  expect_refused(words("speed m/s,mass g\n0.1,24\n"), "found 1 points");
  expect_refused(words("speed m/s,mass g\n0.1,x\n"), "masses.csv:2:5: column mass: found \"x\"");
  // Masses that grow with the speed: no flow.
  expect_refused(words("speed m/s,mass g\n0.1,1\n0.2,2\n0.3,3\n0.4,4\n0.5,9\n"), "C_F = -");
  expect_refused(words(masses(), {"--grain-diameter", "5 mm"}), "allowed: more than 1.4 grain diameters");
  expect_refused(words(masses(), {"--law", "5.1"}), "--law: found \"5.1\"");
  expect_refused(words(masses(), {"--grain-diameter", "3"}), "--grain-diameter: found \"3\"");
  expect_refused(words(masses(), {"--law", "transient"}), "needs time");
  expect_refused({"fit-discharge", "/nowhere.csv"}, "/nowhere.csv");
  expect_refused(words(masses(), {"--law", "transent"}), "did you mean \"transient\"?");
  expect_refused(words(masses(), {"--grain-diameter", "0 mm"}), "allowed: more than 0");
  expect_refused(words(masses(), {"--grain-diameter", "1e9 m"}), "--grain-diameter: found \"1e9 m\"");
}

TEST_F(FitDischarge, OverwritesNoMeasurements) {
  folder_.write("fit.csv", masses());
  const Outcome outcome =
      run_program({"fit-discharge", (folder_.path() / "fit.csv").string(), "--out", folder_.path().string()});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("whose fit.csv the command reads"), std::string::npos) << outcome.err;
  EXPECT_EQ(support::contents(folder_.path() / "fit.csv"), masses());
}

TEST_F(FitDischarge, NamesAFileWhoseNameIsNoText) {
  auto arguments = words(masses(), {"--json"});
  const std::string name = (folder_.path() / "me\xdf.csv").string();
  folder_.write("me\xdf.csv", masses());
  arguments[1] = name;
  const Outcome outcome = run_program(arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(support::contents(out() / "fit.json"));
  EXPECT_TRUE(json.at("measurements").get<std::string>().ends_with("me\xef\xbf\xbd.csv"));
  EXPECT_EQ(nlohmann::json::parse(outcome.out), json);
}

}  // namespace
}  // namespace diefill::app
