// diefill plan, and settings of diefill run and check, as a user meets them.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "project_paths.h"
#include "tests/app/commands/variants.h"
#include "tests/app/shared_report.h"

namespace diefill::app {
namespace {

nlohmann::json plan(const SmallDie& die, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"plan", die.scene().string(), "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

TEST(Plan, SaysWhatASampleSceneNeeds) {
  const std::string scene = std::string(DIEFILL_SOURCE_DIR) + "/sample_tools/narrow_ring/fill.toml";
  const Outcome outcome = run_program({"plan", scene, "--no-benchmark"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("narrowest, 4.462 mm"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("d is 1.882 mm, 0.42 of it"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("across y = 0 mm, and so are powder and motion"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("expected error"), std::string::npos) << outcome.out;
}

/// Plans the small die twice with a place of its own for pilots that are kept; gives both plans, and how long
/// they took in s, to all tests: a pilot takes ten seconds.
nlohmann::json planned_twice(const SmallDie& die) {
  const auto kept = shared_folder(die, "plans", [&](const std::filesystem::path& folder) {
    const char* before = std::getenv("XDG_CACHE_HOME");
    const std::string was = before == nullptr ? "" : before;
    setenv("XDG_CACHE_HOME", folder.c_str(), 1);
    nlohmann::json plans;
    for (const char* name : {"first", "second"}) {
      const auto began = std::chrono::steady_clock::now();
      plans[name] = plan(die, {"--minutes", "10", "--error", "0.05", "--threads", "1"});
      plans[std::string(name) + "_s"] =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    }
    if (before == nullptr)
      unsetenv("XDG_CACHE_HOME");
    else
      setenv("XDG_CACHE_HOME", was.c_str(), 1);
    std::ofstream(folder / "plans.json") << plans;
  });
  return nlohmann::json::parse(contents(kept / "plans.json"));
}

// What belongs to another computation: process.KeptPilot.
TEST(Plan, KeepsItsPilotSoThatASecondPlanIsQuick) {
  const auto plans = planned_twice(SmallDie());
  EXPECT_LT(plans.at("second_s"), plans.at("first_s"));  // no pilot, and no beds of several sizes
  const auto &first = plans.at("first").at("pilot"), &second = plans.at("second").at("pilot");
  EXPECT_TRUE(first.at("kept_since").is_null());
  EXPECT_FALSE(second.at("kept_since").is_null());
  EXPECT_EQ(plans.at("first").at("choices"), plans.at("second").at("choices"));
  EXPECT_GT(first.at("processor_share").get<double>(), 0);
  EXPECT_LE(first.at("processor_share").get<double>(), 1);
}

TEST(Plan, CountsWhatTheRunThenHas) {
  const SmallDie die;
  auto json = planned_twice(die).at("first");
  ASSERT_EQ(json["choices"].size(), 4U);
  const auto& own = json["choices"][0];
  EXPECT_NEAR(json["needs"]["narrowest_width_m"].get<double>(), 4e-3, 1e-4);
  EXPECT_GT(own["wall_seconds"].get<double>(), 0);
  ASSERT_TRUE(json.contains("within_error"));
  for (const auto& choice : json["choices"]) {
    if (choice["name"] != json["within_error"]) continue;
    for (const auto& error : choice["expected_errors"]) EXPECT_LE(error["error"].get<double>(), 0.05);
  }
  ASSERT_EQ(die.run({"--no-pictures"}).exit_code, 0);
  const auto report = die.report();
  const double left = report["grains"].get<double>() + report["grains_left"].get<double>();
  EXPECT_EQ(own["grains"].get<double>(), left + report["grains_sheared"].get<double>());
  EXPECT_EQ(own["wall_spheres"], report["wall_spheres"]);
  EXPECT_NEAR(own["time_step_s"].get<double>(), report["time_step_s"].get<double>(), 1e-12);
  EXPECT_NEAR(own["simulated_s"].get<double>(), report["simulated_s"].get<double>(),
              0.2 * report["simulated_s"].get<double>());
}

TEST(Plan, ASettingTakesThePlaceOfTheScenesNumbersAndTheReportSaysSo) {
  const SmallDie die;
  const Outcome outcome = die.run({"--setting", "quick", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("setting quick"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("replacing \"1 mm\""), std::string::npos) << outcome.err;
  const auto report = die.report();
  EXPECT_EQ(report["setting"]["Chosen by"], "setting quick");
  EXPECT_GT(report["grain_diameter_m"].get<double>(), 1.01e-3);
}

TEST(Plan, SumsUpWhatVariantsTakeAndSaysThatTheyAreThere) {
  const SmallDie die;
  die.write("scene.toml", contents(die.scene()) + R"(
[[variant]]
name = "slow"
step.1.velocity = "0.05 m/s"
[[variant]]
name = "fast"
[[variant]]
name = "coarse"
powder.grain_diameter = "1.2 mm"
)");
  const auto json = plan(die, {"--variants"});
  const auto& variants = json.at("variants");
  ASSERT_EQ(variants.size(), 3U);
  double sum = 0;
  for (const auto& variant : variants) sum += variant.at("wall_seconds").get<double>();
  EXPECT_NEAR(json.at("wall_seconds").get<double>(), sum, 1e-9);
  EXPECT_GT(variants[0].at("simulated_s").get<double>(), variants[1].at("simulated_s").get<double>());
  EXPECT_LT(variants[1].at("wall_seconds").get<double>(), variants[1].at("wall_seconds_alone").get<double>());
  EXPECT_EQ(variants[2].at("shared_s").get<double>(), 0);  // another powder
  EXPECT_EQ(json.at("pilots").size(), 2U);
  const Outcome table = run_program({"plan", die.scene().string(), "--variants", "--no-benchmark"});
  ASSERT_EQ(table.exit_code, 0) << table.err;
  EXPECT_NE(table.out.find("all variants one after the other"), std::string::npos) << table.out;
  // With a setting all grains are alike, and so the poured powder is common to all.
  const auto quick = plan(die, {"--variants", "--setting", "quick", "--no-benchmark"}).at("variants");
  EXPECT_EQ(quick[0].at("grain_diameter_m"), quick[2].at("grain_diameter_m"));
  EXPECT_GT(quick[2].at("shared_s").get<double>(), 0);
  const Outcome base = run_program({"plan", die.scene().string(), "--no-benchmark"});
  EXPECT_NE(base.out.find("diefill plan --variants"), std::string::npos) << base.out;
}

TEST(Plan, EstimatesEachVariant) {
  const SmallDie die;
  add_variants(die);
  const auto variants = plan(die, {"--variants", "--no-benchmark"}).at("variants");
  ASSERT_EQ(variants.size(), 2U);
  const auto& quick = variants[0].at("estimate");
  EXPECT_GT(quick.at("share_filled").get<double>(), 0);
  EXPECT_NEAR(quick.at("shoe_speed_m_per_s").get<double>(), 0.2, 0.01);
  EXPECT_EQ(quick.at("crossings"), 1);
  EXPECT_EQ(variants[1].at("estimate").at("answer"), "nothing to fill");
  const Outcome table = run_program({"plan", die.scene().string(), "--variants", "--no-benchmark"});
  ASSERT_EQ(table.exit_code, 0) << table.err;
  for (const char* part : {"estimate without simulation:", "critical, m/s", "\nstays  "})
    EXPECT_NE(table.out.find(part), std::string::npos) << part << "\n" << table.out;
}

TEST(Plan, WrongInputEndsInOneLine) {
  const SmallDie die;
  const Outcome setting = run_program({"check", die.scene().string(), "--setting", "quik"});
  EXPECT_EQ(setting.exit_code, 2);
  EXPECT_EQ(setting.complaints(), 1U) << setting.err;
  EXPECT_NE(setting.err.find("did you mean \"quick\"?"), std::string::npos) << setting.err;
  EXPECT_EQ(run_program({"plan", die.scene().string(), "--minutes", "-1"}).exit_code, 2);
  EXPECT_EQ(run_program({"plan", (die.folder() / "none.toml").string()}).exit_code, 2);
  EXPECT_EQ(run_program({"plan", die.scene().string(), "--variants", "--minutes", "5"}).exit_code, 2);
  EXPECT_EQ(run_program({"plan", die.scene().string(), "--setting", "quick"}).exit_code, 2);
  die.exchange("seed = 1", "seed = 1\nsetting = \"working\"");
  const Outcome both = run_program({"plan", die.scene().string(), "--no-benchmark"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_EQ(both.complaints(), 1U) << both.err;
  EXPECT_NE(both.err.find("remove one of the two"), std::string::npos) << both.err;
}

}  // namespace
}  // namespace diefill::app
