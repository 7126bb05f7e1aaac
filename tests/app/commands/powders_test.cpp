// `diefill powders`, and what runs of the presets say of the real powder.
#include <gtest/gtest.h>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

TEST(Powders, AreListedWithUseAndLimitsThoseThatFillDiesFirst) {
  const Outcome text = run_program({"powders"});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_LT(text.out.find("Distaloy AE"), text.out.find("ASC100.29 D2"));
  EXPECT_NE(text.out.find("rings are underfilled the most"), std::string::npos);
  EXPECT_NE(text.out.find("apparent density 3 g/cm3"), std::string::npos);
  const Outcome outcome = run_program({"powders", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto list = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(list.size(), 11U);
  EXPECT_EQ(list.front().at("name"), "Distaloy AE");
  EXPECT_EQ(list.back().at("name"), "ASC100.29 A1");
  EXPECT_FALSE(list.back().at("fills_dies").get<bool>());
  EXPECT_TRUE(list.front().at("apparent_density_kg_m3").is_null());
  for (const auto& powder : list) {
    EXPECT_FALSE(powder.at("use").get<std::string>().empty());
    EXPECT_FALSE(powder.at("limits").get<std::string>().empty());
  }
}

TEST(Powders, ThatAreNotForFillingAreNeverSuggestedFirstAndWarnedOf) {
  const SmallDie die;
  die.exchange("preset = \"ASC100.29 A2\"", "preset = \"ASC100.29\"");
  const Outcome wrong = die.check();
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_EQ(wrong.err.find("did you mean \"ASC100.29 A1\""), std::string::npos) << wrong.err;
  EXPECT_LT(wrong.err.find("\"Distaloy AE\""), wrong.err.find("\"ASC100.29 A1\"")) << wrong.err;
  die.exchange("preset = \"ASC100.29\"", "preset = \"ASC100.29 A1\"");
  const Outcome columns = die.check();
  EXPECT_EQ(columns.exit_code, 0) << columns.err;
  EXPECT_NE(columns.out.find("is not suitable for die filling"), std::string::npos) << columns.out;
}

TEST(Powders, GiveMassesInGramsAndAVerdict) {
  const SmallDie die;
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = die.report();
  const std::string verdict = report.at("verdict");
  EXPECT_NE(outcome.out.find(verdict + '\n'), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("cycle time"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("apparent density 3 g/cm3"), std::string::npos) << outcome.out;
  EXPECT_NEAR(report.at("full_die_mass_kg").get<double>(), 64e-9 * 3000, 4e-6);
  EXPECT_FALSE(report.contains("cavities"));
}

}  // namespace
}  // namespace diefill::app
