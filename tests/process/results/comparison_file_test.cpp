// comparison.json and powder_samples.json: numbers under a key are in the unit that the key names.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "process/results/figure_table.h"
#include "process/results/studies/comparison.h"
#include "process/results/studies/powder_spread.h"
#include "tests/support/temporary_folder.h"

namespace diefill::results {
namespace {

using support::contents;

TEST(ComparisonFile, NumbersUnderAKeyHaveTheUnitOfReportJson) {
  const support::TemporaryFolder folder;
  Comparison comparison;
  comparison.variants = {"a", "b"};
  const ComparedValue first{12, 0.5, 2, 0, 0, Verdict::reference},
      second{10, 0.25, 2, -2, 1, Verdict::different};
  comparison.measures = {{"filled_mass_kg", "filled mass of model powder", "g", {first, second}},
                         {"fill_height_mm", "fill height", "mm", {first, second}},
                         {"mass_share_in_flange", "share of the powder in flange", "%", {first, second}},
                         {"measured_ruler_rms", "rms difference from measured ruler", "mm", {first, second}}};
  ComparedRun run;
  run.values = {{"filled_mass_kg", 12},
                {"fill_height_mm", 12},
                {"mass_share_in_flange", 12},
                {"measured_ruler_rms", 12}};
  comparison.runs = {run};
  write_comparison(folder.path(), comparison);

  const auto json = nlohmann::json::parse(contents(folder.path() / "comparison.json"));
  const auto& mass = json.at("measures")[0];
  EXPECT_EQ(mass.at("unit"), "kg");
  EXPECT_DOUBLE_EQ(mass.at("variants")[1].at("mean"), 10e-3);
  EXPECT_DOUBLE_EQ(mass.at("variants")[1].at("scatter"), 0.25e-3);
  EXPECT_DOUBLE_EQ(mass.at("variants")[1].at("difference"), -2e-3);
  EXPECT_DOUBLE_EQ(mass.at("variants")[1].at("interval_95"), 1e-3);
  for (const auto& [at, unit] : {std::pair{1, "mm"}, {2, "1"}, {3, "mm"}})
    EXPECT_EQ(json.at("measures")[static_cast<std::size_t>(at)].at("unit"), unit);
  const auto& values = json.at("runs")[0].at("values");
  EXPECT_DOUBLE_EQ(values.at("filled_mass_kg"), 12e-3);
  EXPECT_DOUBLE_EQ(values.at("fill_height_mm"), 12);
  EXPECT_DOUBLE_EQ(values.at("mass_share_in_flange"), 0.12);
  EXPECT_DOUBLE_EQ(values.at("measured_ruler_rms"), 12);

  const std::string table = contents(folder.path() / "comparison.csv");
  EXPECT_NE(table.find("\"a\",\"filled mass of model powder\",\"g\",12,0.5,"), std::string::npos) << table;
}

TEST(PowderSpreadFile, NumbersUnderAKeyHaveTheUnitOfReportJson) {
  const support::TemporaryFolder folder;
  PowderSpread spread;
  spread.figures = {{"filled_mass_kg", "filled mass", "g", {12, 14}, {13}, 13, 1.5, 13, 2, 1, true}};
  write_powder_spread(folder.path(), spread);
  const auto json = nlohmann::json::parse(contents(folder.path() / "powder_samples.json"));
  const auto& figure = json.at("figures")[0];
  EXPECT_EQ(figure.at("unit"), "kg");
  EXPECT_DOUBLE_EQ(figure.at("best_powder_mean"), 13e-3);
  EXPECT_DOUBLE_EQ(figure.at("scatter_over_seeds"), 1.5e-3);
  EXPECT_DOUBLE_EQ(figure.at("effect_of_the_powder"), 1e-3);
  EXPECT_DOUBLE_EQ(figure.at("of_seeds")[1], 14e-3);
}

TEST(FigureTable, FiguresInAnotherUnitThanTheyAreShownInStayAsTheyAre) {
  EXPECT_EQ(stored_as("cavity_2_filled_mass_kg", "g").unit, "kg");
  EXPECT_EQ(stored_as("filled_mass_kg", "g/mm").unit, "g/mm");
  EXPECT_EQ(stored_as("filled_mass_kg", "g/mm").divisor, 1);
  EXPECT_EQ(stored_as("no_figure_kg", "g").unit, "g");
}

}  // namespace
}  // namespace diefill::results
