// Cost against error through the real program.
#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

std::vector<std::string> arguments_for(const SmallDie& die, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"tradeoff", die.scene().string(), "--out", die.out().string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

const std::vector<std::string> kTwoParameters = {"--vary", "grain_diameter=0.8 mm", "--vary",
                                                 "time_step=0.3,0.25"};

nlohmann::json tradeoff_of(const SmallDie& die) {
  return nlohmann::json::parse(contents(die.out() / "tradeoff.json"));
}

nlohmann::json setting_of(const nlohmann::json& tradeoff, const std::string& name) {
  for (const auto& setting : tradeoff.at("settings"))
    if (setting.at("setting") == name) return setting;
  return {};
}

TEST(Tradeoff, ChartsCostsAndErrorsOfEverySetting) {
  const SmallDie die;
  // Fine enough for as many grains deep in the pocket as a mean solid fraction takes.
  die.exchange("grain_diameter = \"1 mm\"", "grain_diameter = \"0.68 mm\"");
  auto arguments = arguments_for(die, kTwoParameters);
  arguments.insert(arguments.end(), {"--seeds", "2", "--tolerance", "100", "--reference", "base"});
  const Outcome outcome = run_program(arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  SCOPED_TRACE(outcome.out);
  const auto tradeoff = tradeoff_of(die);
  EXPECT_EQ(tradeoff.at("title"), "Small die, one passage");
  const auto base = setting_of(tradeoff, "base"), coarse = setting_of(tradeoff, "grain_diameter=0.8 mm");
  EXPECT_EQ(base.at("seeds"), 2);
  EXPECT_EQ(base.at("error"), 0);
  EXPECT_TRUE(base.at("reference").get<bool>());
  double mass = 0;
  for (const std::string seed : {"1", "2"}) {
    const auto folder = die.out() / "base" / ("seed-" + seed);
    mass += 500 * nlohmann::json::parse(contents(folder / "report.json")).at("filled_mass_kg").get<double>();
    EXPECT_FALSE(std::filesystem::exists(folder / "density_map.png"));  // nothing is drawn for one number
  }
  EXPECT_NEAR(base.at("values").at("filled_mass").at("mean").get<double>(), mass, 1e-9);
  EXPECT_GT(base.at("core_seconds").get<double>(), 0);
  EXPECT_GT(base.at("core_seconds_per_simulated_second").get<double>(),
            base.at("core_seconds").get<double>());
  EXPECT_GT(base.at("peak_memory_bytes").get<double>(), 1e6);
  EXPECT_LT(base.at("peak_memory_bytes").get<double>(), 1e10);
  EXPECT_LT(coarse.at("core_seconds").get<double>(), base.at("core_seconds").get<double>());
  ASSERT_TRUE(coarse.at("error").is_number());
  EXPECT_GT(coarse.at("error").get<double>(), 0);
  // Everything is accepted here: all parameters that save time are turned together, and that is the cheapest.
  const auto combined = setting_of(tradeoff, "combined");
  ASSERT_FALSE(combined.is_null()) << outcome.out;
  EXPECT_EQ(combined.at("changes").at("grain_diameter"), "0.8 mm");
  EXPECT_EQ(combined.at("seeds"), 2);
  for (const char* picture : {"tradeoff.png", "parameter_grain_diameter.png", "parameter_time_step.png"})
    EXPECT_EQ(contents(die.out() / picture).substr(0, 8), "\x89PNG\r\n\x1a\n") << picture;
  EXPECT_EQ(contents(die.out() / "tradeoff.csv").substr(0, 27), "setting,state,seeds,core_se");
  EXPECT_NE(outcome.out.find("recommended"), std::string::npos) << outcome.out;
}

TEST(Tradeoff, KeepsWhatStandsAndRunsOnlyWhatIsNew) {
  const SmallDie die;
  const auto first = arguments_for(die, {"--vary", "grain_diameter=1.5 mm", "--seeds", "1"});
  ASSERT_EQ(run_program(first).exit_code, 0);
  const std::string csv = contents(die.out() / "tradeoff.csv");
  const Outcome again = run_program(first);
  EXPECT_NE(again.err.find("2 of 2 runs are already done"), std::string::npos) << again.err;
  EXPECT_EQ(contents(die.out() / "tradeoff.csv"), csv);  // measured costs and all
  const Outcome more =
      run_program(arguments_for(die, {"--vary", "grain_diameter=1.5 mm,1.8 mm", "--seeds", "1"}));
  EXPECT_EQ(more.exit_code, 0) << more.err;
  EXPECT_NE(more.err.find("2 of 3 runs are already done"), std::string::npos) << more.err;
  EXPECT_NE(more.out.find("one seed each"), std::string::npos) << more.out;
}

TEST(Tradeoff, GoesOnAfterCtrlCAndAfterAKill) {
  const SmallDie die;
  const auto arguments = arguments_for(die, {"--vary", "grain_diameter=1.5 mm", "--seeds", "1"});
  for (const int signal : {SIGINT, SIGKILL}) {
    Program program(arguments);
    while (program.running() && !std::filesystem::exists(die.out() / "base/seed-1/checkpoint.bin"))
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    program.send(signal);
    const Outcome outcome = program.wait();
    if (signal == SIGINT) {
      EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
      EXPECT_NE(outcome.err.find("run the same command again to continue"), std::string::npos) << outcome.err;
    }
  }
  const Outcome last = run_program(arguments);
  ASSERT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(tradeoff_of(die).at("settings").size(), 2U);
}

TEST(Tradeoff, StopsWhereTheBudgetEndsAndSaysWhatIsMissing) {
  const SmallDie die;
  // The first run costs more than this: it is stopped, and nothing else begins.
  const Outcome outcome = run_program(
      arguments_for(die, {"--vary", "grain_diameter=1.5 mm", "--seeds", "1", "--budget", "0.0001"}));
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("2 runs did not fit the budget of 0.0001 core minutes"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("no results for \"base\", \"grain_diameter=1.5 mm\""), std::string::npos)
      << outcome.out;
  const Outcome enough =
      run_program(arguments_for(die, {"--vary", "grain_diameter=1.5 mm", "--seeds", "1", "--budget", "100"}));
  EXPECT_EQ(enough.exit_code, 0) << enough.err;
  EXPECT_EQ(enough.out.find("did not fit"), std::string::npos) << enough.out;
}

TEST(Tradeoff, BadInputEndsInOneLineBeforeAnythingRuns) {
  const SmallDie die;
  const auto refused = [&](const std::vector<std::string>& more, const std::string& part) {
    const Outcome outcome = run_program(arguments_for(die, more));
    EXPECT_EQ(outcome.exit_code, 2) << part;
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  };
  refused({"--vary", "grain_diametre=1 mm"}, "did you mean \"grain_diameter\"?");
  refused({"--vary", "grain_diameter=1 kg"}, "--vary grain_diameter=1 kg");
  refused({"--vary", "economy.slep=true"}, "economy");
  refused({"--vary", "time_step=0.3", "--target", "filled_mas=3"}, "did you mean \"filled_mass\"?");
  refused({"--vary", "time_step=0.3", "--target", "filled_mass"}, "NAME=NUMBER");
  for (const char* word : {"filled_mass=0", "filled_mass=-3", "solid_fraction=2", "solid_fraction=0.3 g"})
    refused({"--vary", "time_step=0.3", "--target", word}, std::string("--target: found \"") + word + '"');
  refused({"--vary", "time_step=0.3", "--target", "filled_mass=3", "--target", "filled_mass=4 mg"},
          "filled_mass is given twice");
  refused({"--vary", "time_step=0.3", "--reference", "bas"}, "did you mean \"base\"?");
  EXPECT_FALSE(std::filesystem::exists(die.out()));
}

}  // namespace
}  // namespace diefill::app
