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
  expect_refused(words("speed m/s,mass g\n0.1,x\n"), "masses.csv:2: column mass: found \"x\"");
  expect_refused(words(masses(), {"--law", "5.1"}), "--law: found \"5.1\"");
  expect_refused(words(masses(), {"--grain-diameter", "3"}), "--grain-diameter: found \"3\"");
  expect_refused(words(masses(), {"--law", "transient"}), "needs time");
  expect_refused({"fit-discharge", "/nowhere.csv"}, "/nowhere.csv");
}

}  // namespace
}  // namespace diefill::app
