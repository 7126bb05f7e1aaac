// Values of earlier runs, kept beside the page of fidelity.
#include "process/laboratory/published/kept_results.h"

#include <gtest/gtest.h>

#include "process/input/scene_error.h"
#include "process/laboratory/published/fidelity.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::laboratory {
namespace {

PublishedFigure figure(const std::string& id) {
  PublishedFigure figure;
  figure.id = id, figure.experiment = "mean_fractions", figure.published = "0.59", figure.lower = 0.575,
  figure.upper = 0.605, figure.kind = "value", figure.unit = "1";
  return figure;
}

const std::vector<PublishedFigure> kFigures = {figure("N01"), figure("N02"), figure("N03")};

results::LabTable table(const std::string& size, const std::string& id, const std::vector<double>& values,
                        double core_seconds) {
  results::LabTable table;
  table.size = size;
  results::LabRow row;
  row.id = id, row.published = "0.59", row.values = values, row.core_seconds = core_seconds;
  row.verdict = values.empty() ? "no value" : "met", row.reason = values.empty() ? "it failed" : "";
  table.rows.push_back(row);
  return table;
}

TEST(KeptResults, ARunOfOneExperimentLeavesTheRowsOfOthers) {
  std::vector<KeptResult> kept;
  take_over(kept, {table("coarse", "N01", {0.58, 0.6}, 10), table("medium", "N02", {0.59}, 20)});
  take_over(kept, {table("coarse", "N01", {0.6, 0.6}, 5)});
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].row.values, (std::vector<double>{0.6, 0.6}));
  EXPECT_EQ(kept[1].row.values, std::vector<double>{0.59});
}

TEST(KeptResults, ARunWithFewerSeedsLeavesWhatRestsOnMore) {
  std::vector<KeptResult> kept;
  auto scatter = table("coarse", "N02", {3}, 10);  // one value of three seeds together
  scatter.rows[0].seeds = 3;
  take_over(kept, {table("coarse", "N01", {0.58, 0.6, 0.59}, 10), scatter});
  auto of_two = table("coarse", "N02", {4}, 10);
  of_two.rows[0].seeds = 2;
  take_over(kept, {table("coarse", "N01", {0.7}, 10), of_two});
  EXPECT_EQ(kept.at(0).row.values, (std::vector<double>{0.58, 0.6, 0.59}));
  EXPECT_EQ(kept.at(1).row.values, std::vector<double>{3});
  // Finer grains count more than seeds.
  take_over(kept, {table("medium", "N01", {0.7}, 10)});
  EXPECT_EQ(kept.at(0).row.values, std::vector<double>{0.7});
}

TEST(KeptResults, AValueOfSeveralSeedsTogetherNamesTheirNumber) {
  const support::TemporaryFolder folder;
  std::vector<KeptResult> kept;
  auto scatter = table("coarse", "N01", {0.59}, 10);
  scatter.rows[0].seeds = 3;
  take_over(kept, {scatter});
  const auto back = read_kept_results(folder.write("kept_results.csv", csv_of(kept)), kFigures);
  EXPECT_EQ(back.at(0).row.seeds, 3U);
  EXPECT_NE(fidelity_page(kFigures, tables_with_kept(back, {}), {}).find("coarse, 3 seeds |"),
            std::string::npos);
  // A row without the number has a value of each seed.
  const auto older = read_kept_results(
      folder.write("kept_results.csv", "id,size,values,d_mm,core_seconds,reason\nN01,coarse,0.5 0.6,1,1,\n"),
      kFigures);
  EXPECT_EQ(results::seeds_of(older.at(0).row), 2U);
}

TEST(KeptResults, AValueIsLostToNoRunThatHasNoneOrCoarserGrains) {
  std::vector<KeptResult> kept;
  take_over(kept, {table("medium", "N01", {0.58}, 10)});
  for (const auto& other : {table("coarse", "N01", {0.7}, 10), table("medium", "N01", {}, 10),
                            table("medium", "N01", {0.7}, 0)}) {
    take_over(kept, {other});
    EXPECT_EQ(kept.at(0).row.values, std::vector<double>{0.58});
  }
  take_over(kept, {table("published", "N01", {0.7}, 10)});
  EXPECT_EQ(kept.at(0).size, "published");
}

TEST(KeptResults, ComeBackFromTheirFileWithTheFiguresRange) {
  const support::TemporaryFolder folder;
  std::vector<KeptResult> kept;
  take_over(kept, {table("coarse", "N01", {0.58, 0.6}, 10), table("coarse", "N03", {}, 3)});
  kept[1].row.reason = "run \"A1\" failed: max_time, 8 s";
  const auto file = folder.write("kept_results.csv", csv_of(kept));
  const auto back = read_kept_results(file, kFigures);
  ASSERT_EQ(back.size(), 2U);
  EXPECT_EQ(back[0].row.values, (std::vector<double>{0.58, 0.6}));
  EXPECT_EQ(back[0].row.verdict, "met");
  EXPECT_DOUBLE_EQ(back[0].row.upper, 0.605);
  EXPECT_EQ(back[1].row.reason, kept[1].row.reason);
  EXPECT_EQ(csv_of(back), csv_of(kept));
  EXPECT_TRUE(read_kept_results(folder.path() / "none.csv", kFigures).empty());
}

TEST(KeptResults, ThePageHasThemBesideWhatIsNew) {
  std::vector<KeptResult> kept;
  take_over(kept, {table("coarse", "N01", {0.58, 0.6}, 10)});
  const std::string page = fidelity_page(
      kFigures, tables_with_kept(kept, {table("coarse", "N01", {}, 0), table("coarse", "N02", {0.7}, 0)}),
      {});
  EXPECT_NE(page.find("| N01 |  | 0.59 (0.575 to 0.605) | 0.59 +- 0.014 | met |"), std::string::npos) << page;
  EXPECT_NE(page.find("| N02 |  | 0.59 (0.575 to 0.605) | 0.7 |"), std::string::npos) << page;
}

TEST(KeptResults, ThePageSaysWhatStandsInForThePublishedQuantity) {
  std::vector<KeptResult> kept;
  take_over(kept, {table("coarse", "N01", {0.58}, 10), table("medium", "N02", {0.6}, 10)});
  // A later call without runs: the experiment's name of the quantity, no value.
  auto measured = table("coarse", "N01", {}, 0);
  measured.rows[0].quantity = "deviation, l = 8 from l = 4";
  auto other = table("coarse", "N02", {}, 0);
  other.rows[0].quantity = "of another size";
  const std::string page = fidelity_page(kFigures, tables_with_kept(kept, {measured, other}), {});
  EXPECT_NE(page.find("coarse, 1 seed; deviation, l = 8 from l = 4 |"), std::string::npos) << page;
  EXPECT_EQ(page.find("of another size"), std::string::npos) << page;
}

TEST(KeptResults, AWrongLineIsNamed) {
  const support::TemporaryFolder folder;
  const std::string head = "id,size,values,d_mm,core_seconds,reason\n";
  const std::pair<const char*, const char*> wrong[] = {
      {"N01,coarse,0.5\n", "kept_results.csv:2: found 3 fields"},
      {"N01,tiny,0.5,1,1,\n", "kept_results.csv:2: found \"tiny\", expected coarse"},
      {"N01,coarse,0.5 x,1,1,\n", "kept_results.csv:2: found \"x\", expected a number"}};
  for (const auto& [text, message] : wrong) {
    const auto file = folder.write("kept_results.csv", head + text);
    try {
      read_kept_results(file, kFigures);
      FAIL() << text;
    } catch (const SceneError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace diefill::process::laboratory
