// diefill estimate and its short form in plan and check, as a user meets them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "project_paths.h"
#include "tests/app/commands/variants.h"

namespace diefill::app {
namespace {

std::string sample(const std::string& name) {
  return std::string(DIEFILL_SOURCE_DIR) + "/sample_tools/" + name;
}

nlohmann::json json_of(const std::vector<std::string>& arguments) {
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

void expect_refused(const std::vector<std::string>& arguments, const std::string& part) {
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
}

TEST(Estimate, AnswersWithinASecondOfReadingTheTools) {
  const auto json = json_of({"estimate", sample("narrow_ring/fill.toml"), "--json"});
  EXPECT_LT(json.at("estimating_seconds").get<double>(), 1);
  const auto& ring = json.at("openings").at(0);
  EXPECT_TRUE(ring.at("is_cavity").get<bool>());
  EXPECT_GT(ring.at("share_filled").get<double>(), 0);
  EXPECT_LE(ring.at("share_filled").get<double>(), 1);
  EXPECT_GT(ring.at("critical_speed_one_crossing_m_per_s").get<double>(), 0);
  EXPECT_NEAR(json.at("shoe").at("speed_m_per_s").get<double>(), 0.2, 0.01);
  for (const auto& statement : json.at("statements")) {
    EXPECT_FALSE(statement.at("words").get<std::string>().empty());
    EXPECT_FALSE(statement.at("error_against_dem").get<std::string>().empty());
  }
}

TEST(Estimate, SaysWhatAnEngineerCanActOn) {
  const Outcome outcome = run_program({"estimate", sample("narrow_ring/fill.toml")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* part : {"answer: ", "critical shoe speed", "crossing", "cycle time", "air: ", "Bond: ",
                           "Froude", "Pi_2: 8.6", "Bierwisch 2009, Eq. 5.17", "error against DEM: "})
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part << "\n" << outcome.out;
}

TEST(Estimate, EverySampleSceneHasOne) {
  for (const char* name : {"gear/fill.toml", "stepped_ring/fill.toml", "rectangular_die/fill_jkr.toml",
                           "narrow_ring/fill_sizes.toml", "narrow_ring/strategies/volumetric.toml",
                           "tradeoff/angle_of_repose.toml", "slit_plate/discharge_6mm.toml"}) {
    const Outcome outcome = run_program({"estimate", sample(name)});
    EXPECT_EQ(outcome.exit_code, 0) << name << outcome.err;
    EXPECT_NE(outcome.out.find("answer: "), std::string::npos) << name << outcome.out;
  }
}

TEST(Estimate, TakesTheSizeOfTheRealParticlesAndALawOfOnesOwn) {
  const SmallDie die;
  die.write("fit.json", R"({"law": "5.17", "coefficients": {"C_B": {"value": 0.05}, "C_I": {"value": 0.39},
    "C_F": {"value": 0.92}, "beta": {"value": 1.4}}})");
  const std::string scene = die.scene().string();
  const auto json = json_of({"estimate", scene, "--json", "--particle-diameter", "50 um", "--discharge",
                             (die.folder() / "fit.json").string()});
  EXPECT_NEAR(json.at("powder").at("particle_diameter_m").get<double>(), 50e-6, 1e-12);
  EXPECT_NEAR(json.at("powder").at("discharge_law").at("C_F").get<double>(), 0.92, 1e-12);
  expect_refused({"estimate", scene, "--particle-diameter", "50"}, "--particle-diameter: found \"50\"");
  expect_refused({"estimate", scene, "--particle-diameter", "0 um"}, "allowed: 1 um to 1 mm");
  expect_refused({"estimate", scene, "--particle-diameter", "1 cm"}, "the scene's grains");
  expect_refused({"estimate", scene, "--discharge", scene}, "found no JSON");
  expect_refused({"estimate", (die.folder() / "none.toml").string()}, "none.toml");
}

TEST(Estimate, IsWhatPlanAndCheckBeginWith) {
  const SmallDie die;
  const std::string scene = die.scene().string();
  const Outcome check = run_program({"check", scene});
  EXPECT_EQ(check.out.find("estimate without simulation: "), 0U) << check.out;
  const Outcome plan = run_program({"plan", scene, "--no-benchmark"});
  EXPECT_EQ(plan.out.find("Small die, one passage\nestimate without simulation: "), 0U) << plan.out;
  EXPECT_TRUE(json_of({"check", scene, "--json"}).at("estimate").contains("answer"));
  EXPECT_TRUE(json_of({"plan", scene, "--no-benchmark", "--json"}).at("estimate").contains("answer"));
}

TEST(Estimate, OfASceneWithVariantsHasALineForEach) {
  const SmallDie die;
  const std::string scene = die.scene().string();
  EXPECT_FALSE(json_of({"estimate", scene, "--json"}).contains("variants"));
  add_variants(die);
  const auto json = json_of({"estimate", scene, "--json"});
  const auto& variants = json.at("variants");
  ASSERT_EQ(variants.size(), 2U);
  EXPECT_EQ(variants[0].at("name"), "quick");
  EXPECT_LT(variants[0].at("share_filled").get<double>(),
            json.at("openings").at(0).at("share_filled").get<double>());
  EXPECT_LT(variants[0].at("cycle_time_s").get<double>(), json.at("cycle_time_s").get<double>());
  EXPECT_NEAR(variants[0].at("shoe_speed_m_per_s").get<double>(), 0.2, 0.01);
  EXPECT_EQ(variants[1].at("answer"), "nothing to fill");
  EXPECT_TRUE(variants[1].at("share_filled").is_null());
  const Outcome text = run_program({"estimate", scene});
  ASSERT_EQ(text.exit_code, 0) << text.err;
  for (const char* part :
       {"critical, m/s", "\nquick  ", "\nstays  ", "nothing to fill", "--variant \"quick\""})
    EXPECT_NE(text.out.find(part), std::string::npos) << part << "\n" << text.out;
}

TEST(Estimate, TakesOneVariantByItsName) {
  const SmallDie die;
  const std::string scene = die.scene().string();
  expect_refused({"estimate", scene, "--variant", "quick"}, "has no [[variant]]");
  add_variants(die);
  const auto line = json_of({"estimate", scene, "--json"}).at("variants").at(0);
  const auto quick = json_of({"estimate", scene, "--variant", "quick", "--json"});
  EXPECT_EQ(quick.at("title"), "Small die, one passage: quick");
  EXPECT_FALSE(quick.contains("variants"));
  EXPECT_EQ(quick.at("openings").at(0).at("share_filled"), line.at("share_filled"));
  EXPECT_EQ(quick.at("openings").at(0).at("critical_speed_m_per_s"), line.at("critical_speed_m_per_s"));
  expect_refused({"estimate", scene, "--variant", "quik"}, "did you mean \"quick\"?");
}

TEST(Check, SaysThatVariantsAreThereAndChecksOne) {
  const SmallDie die;
  const std::string scene = die.scene().string();
  add_variants(die);
  const Outcome all = run_program({"check", scene});
  ASSERT_EQ(all.exit_code, 0) << all.err;
  EXPECT_NE(all.out.find("without its 2 [[variant]]s; check one with --variant, such as --variant \"quick\""),
            std::string::npos)
      << all.out;
  EXPECT_EQ(json_of({"check", scene, "--json"}).at("unchecked_variants").size(), 2U);
  const Outcome quick = run_program({"check", scene, "--variant", "quick"});
  ASSERT_EQ(quick.exit_code, 0) << quick.err;
  EXPECT_NE(quick.out.find("at 0.2 m/s"), std::string::npos) << quick.out;
  EXPECT_EQ(quick.out.find("[[variant]]"), std::string::npos) << quick.out;
}

TEST(Estimate, SaysWhereAFitCountsOpeningsAsTheyAre) {
  const SmallDie die;
  const std::string scene = die.scene().string(), file = (die.folder() / "fit.json").string();
  const std::string rates = R"({"law": "beverloo-slit", "coefficients": {"C": {"value": 1.03}})";
  for (const auto& [grain, remarked] : {std::pair{"0", true}, {"0.001", false}}) {
    die.write("fit.json", rates + R"(, "effective_opening_grain_diameter_m": )" + grain + "}");
    const Outcome outcome = run_program({"estimate", scene, "--discharge", file});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("fit them again with --grain-diameter") != std::string::npos, remarked)
        << outcome.out;
  }
  die.write("fit.json", R"({"law": "beverloo-round", "coefficients": {"C": {"value": 0.58}}})");
  expect_refused({"estimate", scene, "--discharge", file}, "through holes");
}

}  // namespace
}  // namespace diefill::app
