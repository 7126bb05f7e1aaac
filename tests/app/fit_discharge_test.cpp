// diefill fit-discharge as a user meets it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
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
  /// C_B, C_I, C_F and beta of Eq. 5.15 (Bierwisch 2009).
  struct Transient {
    double burst, initial, steady, beta;
  };
  /// What has run out of a slit of 15 x 2.16 mm that opens at 0.1 s of a table up to 0.6 s; nothing more
  /// comes after `empty` (s).
  std::string outflow(const Transient& law, double empty) const {
    std::string text = "time s,mass g\n";
    for (int k = 0; k <= 60; ++k) {
      const double time = 0.01 * k, x = (std::min(time, empty) - 0.1) * std::sqrt(9.81 / 15e-3) - 0.2;
      const double share =
          law.burst + law.steady * x + (law.steady - law.initial) / law.beta * std::expm1(-law.beta * x);
      char line[64];
      std::snprintf(line, sizeof line, "%g,%.6g\n", time,
                    x < 0 ? 0 : 1e3 * 2100 * 2.16e-3 * std::pow(15e-3, 2) * share);
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
  EXPECT_TRUE(json.at("chi_square_per_degree_of_freedom").is_null()) << "without errors there is none";
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

TEST_F(FitDischarge, RemarksOnFactorsThatOnlyAWrongUnitGives) {
  const std::string right = masses(), rest = right.substr(right.find('\n'));
  const auto said_of = [&](const std::string& heading, const char* density) {
    auto arguments = words(heading + rest);
    arguments[3] = density;
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  };
  const std::string remark = "check the units of density, mass and width";
  EXPECT_EQ(said_of("speed m/s,mass g", "3.0 g/cm^3").find(remark), std::string::npos);
  EXPECT_NE(said_of("speed m/s,mass g", "3.0 kg/m^3").find(remark), std::string::npos);
  EXPECT_NE(said_of("speed m/s,mass kg", "3.0 g/cm^3").find(remark), std::string::npos);
  EXPECT_NE(said_of("speed m/s,mass mg", "3.0 g/cm^3").find(remark), std::string::npos);
  const auto json = nlohmann::json::parse(support::contents(out() / "fit.json"));
  EXPECT_NE(json.at("remarks").at(0).get<std::string>().find(remark), std::string::npos);
  EXPECT_EQ(json.at("doubts").at(0), json.at("remarks").at(0));
}

TEST_F(FitDischarge, RemarksOnAFactorOfBeverloosLawThatOnlyAWrongUnitGives) {
  // C = 0.58 at 1 t/m^3.
  const auto file = folder_.write("rates.csv", "rate g/s,diameter mm\n3.2,5\n18.2,10\n50,15\n").string();
  for (const auto& [density, remarked] : {std::pair{"1 g/cm^3", false}, {"1 kg/m^3", true}}) {
    const Outcome outcome =
        run_program({"fit-discharge", file, "--density", density, "--out", out().string()});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("check the units of density, rate and width") != std::string::npos, remarked)
        << outcome.out;
  }
}

TEST_F(FitDischarge, StatesTheFittedFactorOfTheEffectiveOpening) {
  // C = 0.58 and k = 2 with d = 1 mm at 1 t/m^3.
  std::string rates = "rate g/s,diameter mm\n";
  for (const double width : {5e-3, 8e-3, 11e-3, 15e-3}) {
    char line[64];
    std::snprintf(line, sizeof line, "%.8g,%g\n",
                  1e3 * 0.58 * 1000 * std::sqrt(9.81) * std::pow(width - 2e-3, 2.5), 1e3 * width);
    rates += line;
  }
  const auto file = folder_.write("rates.csv", rates).string();
  const Outcome outcome = run_program(
      {"fit-discharge", file, "--density", "1 g/cm^3", "--grain-diameter", "1 mm", "--out", out().string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("openings count as D - 2 d with d = 1 mm"), std::string::npos) << outcome.out;
}

TEST_F(FitDischarge, SaysOfAFactorAtItsLimitWhatThePointsDoNotShow) {
  // As if no grain took anything from the opening: k is at its least value.
  const auto file =
      folder_.write("rates.csv", "rate g/s,diameter mm\n3.21,5\n9.92,8\n21.3,11\n44.8,15\n").string();
  const Outcome outcome = run_program(
      {"fit-discharge", file, "--density", "1 g/cm^3", "--grain-diameter", "1 mm", "--out", out().string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find(
                "k is at the limit of the search range: the points do not show how the flow depends on "
                "the size of the opening"),
            std::string::npos)
      << outcome.out;
}

TEST_F(FitDischarge, LeavesOutWithUntilWhatCameOnceTheHopperWasEmpty) {
  const auto file = folder_.write("outflow.csv", outflow({0.05, 0.39, 0.92, 1.4}, 0.5)).string();
  const std::vector<std::string> whole = {"fit-discharge", file,        "--density", "2.1 g/cm^3",  "--width",
                                          "15 mm",         "--length",  "2.16 mm",   "--opened",    "0.1 s",
                                          "--law",         "transient", "--out",     out().string()};
  expect_refused(whole, "exclude the points after the hopper has emptied (--until)");
  auto flowing = whole;
  flowing.insert(flowing.end(), {"--until", "0.5 s"});
  const Outcome outcome = run_program(flowing);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("hardly rises"), std::string::npos) << outcome.out;
  const auto json = nlohmann::json::parse(support::contents(out() / "fit.json"));
  EXPECT_NEAR(json.at("coefficients").at("C_F").at("value").get<double>(), 0.92, 0.01);
  EXPECT_NEAR(json.at("coefficients").at("beta").at("value").get<double>(), 1.4, 0.05);
}

TEST_F(FitDischarge, RemarksOnAnOutflowThatNoLongerRises) {
  // The rate falls to a fortieth of the first one.
  const auto file = folder_.write("outflow.csv", outflow({0.05, 4, 0.1, 0.5}, 0.6)).string();
  const Outcome outcome =
      run_program({"fit-discharge", file, "--density", "2.1 g/cm^3", "--width", "15 mm", "--length",
                   "2.16 mm", "--opened", "0.1 s", "--law", "transient", "--out", out().string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("hardly rises in the last fifth"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("--until"), std::string::npos) << outcome.out;
}

TEST_F(FitDischarge, SaysWhatToDoOfAnOptionTwiceOrWithoutAValue) {
  expect_refused(words(masses(), {"--density", "2 g/cm^3"}), "--density: found more than one value");
  expect_refused(words(masses(), {"--law"}), "--law: found no value; write one after it");
}

TEST_F(FitDischarge, RefusesBadInputInOneLineAndWritesNothing) {
  expect_refused(words("speed m/s,mass g\n0.1,24\n"), "found 1 point;");
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
  expect_refused(words(masses(), {"--until", "0.3 s"}), "--until: found 0.3 s, but law 5.17 has no times");
  expect_refused(words(masses(), {"--until", "3"}), "--until: found \"3\"");
}

TEST_F(FitDischarge, KeepsAnEarlierFitAndForeignFiles) {
  std::filesystem::create_directories(out());
  std::ofstream(out() / "fit.json") << "mine";
  ASSERT_EQ(run_program(words(masses())).exit_code, 0);
  EXPECT_EQ(support::contents(out() / "previous-1/fit.json"), "mine");
  ASSERT_EQ(run_program(words(masses())).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(out() / "previous-2"));  // the same fit
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
