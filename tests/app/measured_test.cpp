// Zones and measured data through the real program, with the small die.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/commands/variants.h"
#include "tests/app/shared_report.h"

namespace diefill::app {
namespace {

/// The die with finer grains, so that zones hold some, and zones that halve it.
class ZonedDie {
 public:
  ZonedDie() {
    die_.exchange("[measure]",
                  "[[measure.zone]]\nname = \"upper half\"\nheights = [\"-2 mm\", \"0 mm\"]\n\n"
                  "[[measure.zone]]\nname = \"lower half\"\nheights = [\"-4 mm\", \"-2 mm\"]\n\n[measure]");
    take_shared_results(die_);
  }
  const SmallDie& die() const { return die_; }
  /// The fill level that the run found, shifted by 0.5 mm.
  void write_measured() const {
    const auto report = die_.report();
    const auto& level = report.at("fill_level");
    std::string csv = level.at("x_name").get<std::string>() + " [mm], fill level [mm]\n";
    for (std::size_t k = 0; k < level.at("x").size(); ++k)
      csv += std::to_string(level.at("x")[k].get<double>()) + ", " +
             std::to_string(level.at("y")[k].get<double>() - 0.5) + '\n';
    die_.write("ruler.csv", csv);
  }
  std::string measured() const { return (die_.folder() / "ruler.csv").string(); }

 private:
  SmallDie die_;
};

TEST(Zones, AreFiguresOfTheReport) {
  const ZonedDie zoned;
  const auto report = zoned.die().report();
  const double upper = report.at("filled_mass_in_upper_half_kg"),
               lower = report.at("filled_mass_in_lower_half_kg");
  EXPECT_GT(lower, upper);
  EXPECT_NEAR(upper + lower, report.at("filled_mass_kg").get<double>(), 1e-12);
  EXPECT_NEAR(report.at("mass_share_in_lower_half").get<double>(), lower / (upper + lower), 1e-9);
  // Few grains of 1 mm: no solid fraction, and the report says why.
  EXPECT_TRUE(report.at("no_value").contains("solid_fraction_in_upper_half"));
}

TEST(MeasuredData, AreHeldAgainstAResultByMapReportAndCompare) {
  const ZonedDie zoned;
  zoned.write_measured();
  const auto& die = zoned.die();
  const Outcome map = run_program({"map", die.out().string(), "--measured", zoned.measured()});
  ASSERT_EQ(map.exit_code, 0) << map.err;
  EXPECT_NE(map.out.find("mean 0.5 mm, rms 0.5 mm"), std::string::npos) << map.out;
  for (const char* file : {"measured_ruler.csv", "measured_ruler_zones.csv", "measured_ruler.png",
                           "measured_ruler_difference.png"})
    EXPECT_GT(contents(die.out() / file).size(), 50U) << file;

  const Outcome report = run_program({"report", die.out().string(), "--measured", zoned.measured()});
  ASSERT_EQ(report.exit_code, 0) << report.err;
  const std::string page = contents(die.out() / "report.html");
  EXPECT_NE(page.find("Against measured data"), std::string::npos);
  EXPECT_NE(page.find("Share of the powder in lower half"), std::string::npos);

  const std::string compared = (die.folder() / "compared").string();
  const Outcome compare = run_program({"compare", die.scene().string(), "--out", compared, "--quiet",
                                       "--no-pictures", "--measured", zoned.measured()});
  ASSERT_EQ(compare.exit_code, 0) << compare.err;
  const auto json = nlohmann::json::parse(contents(std::filesystem::path(compared) / "comparison.json"));
  const std::string all = json.dump();
  EXPECT_NE(all.find("measured_ruler_rms"), std::string::npos);
  EXPECT_NE(all.find("mass_share_in_lower_half"), std::string::npos);
}

TEST(MeasuredData, AVariantWithoutValuesLeavesTheOthersCompared) {
  const SmallDie die;
  add_variants(die);
  die.write("ruler.csv", "distance along the shoe's travel [mm], fill level [mm]\n1, 3.2\n2, 3.5\n3, 3.7\n");
  const std::string measured = (die.folder() / "ruler.csv").string();
  const Outcome outcome = run_program(compare_arguments(die, {"--quiet", "--measured", measured}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto comparison = comparison_of(die.out());
  // The shoe that stays beside the pocket leaves it empty.
  for (const auto& run : comparison.at("runs")) {
    const bool stays = run.at("variant") == "stays";
    EXPECT_EQ(run.at("values").contains("measured_ruler_rms"), !stays) << run;
    EXPECT_EQ(run.contains("reason"), stays) << run;
  }
  for (const auto& measure : comparison.at("measures"))
    if (measure.at("key") == "measured_ruler_rms") {
      EXPECT_TRUE(measure.at("variants")[0].at("mean").is_number());
      EXPECT_EQ(measure.at("variants")[1].at("verdict"), "no value");
    }
  EXPECT_NE(outcome.out.find("\"stays\", seed 1: no value: "), std::string::npos) << outcome.out;
  // The scene of the runs may be named beside their directory.
  EXPECT_EQ(run_program({"compare", die.scene().string(), "--collect", die.out().string()}).exit_code, 0);

  // Where no variant has a value the data are wrong.
  die.write("ruler.csv", "distance along the shoe's travel [mm], fill level [mm]\n100, 3.2\n200, 3.5\n");
  const Outcome wrong = run_program({"compare", "--collect", die.out().string(), "--measured", measured});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_EQ(wrong.complaints(), 1U) << wrong.err;
}

TEST(MeasuredData, AreComparedInEachZoneOfTheScene) {
  const SmallDie die;
  die.exchange(
      "[measure]",
      "[[measure.zone]]\nname = \"far end\"\naxis = [\"-4 mm\", \"0 mm\", \"0 mm\"]\nouter_radius = \"1.5 "
      "mm\"\n\n[measure]");
  die.write("photo.csv", "x [mm], y [mm], fill level [mm]\n-4, 0, 3\n-3.6, 0, 3\n-2, 0, 3.5\n");
  const Outcome outcome =
      run_program({"compare", die.scene().string(), "--out", die.out().string(), "--quiet", "--no-pictures",
                   "--measured", (die.folder() / "photo.csv").string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("mean difference from measured photo in far end, mm"), std::string::npos)
      << outcome.out;
  const auto values = comparison_of(die.out()).at("runs").at(0).at("values");
  EXPECT_TRUE(values.contains("measured_photo_difference_in_far_end")) << values;
}

TEST(MeasuredData, ThatNoRunCanHaveAreRefusedBeforeAnyRuns) {
  const SmallDie die;
  add_variants(die);
  const auto refused = [&](const std::string& csv, const std::string& part) {
    die.write("ruler.csv", csv);
    const Outcome outcome =
        run_program(compare_arguments(die, {"--quiet", "--measured", (die.folder() / "ruler.csv").string()}));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(die.out()));
  };
  refused("azimuth [deg], fill level [mm]\n45, 3\n", "only rings have a fill level over azimuth");
  refused("height [mm], solid fracton [1]\n2, 0.3\n", "did you mean \"solid fraction\"?");
}

TEST(MeasuredData, FaultsEndInOneLine) {
  const ZonedDie zoned;
  zoned.die().write("ruler.csv", "azimuth [deg], fill level [mm]\n45, 3\n");
  const Outcome wrong = run_program({"map", zoned.die().out().string(), "--measured", zoned.measured()});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_EQ(wrong.complaints(), 1U) << wrong.err;
  EXPECT_NE(wrong.err.find("distance along the shoe's travel"), std::string::npos) << wrong.err;
}

}  // namespace
}  // namespace diefill::app
