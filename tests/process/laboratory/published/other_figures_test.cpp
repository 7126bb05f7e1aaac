// What experiments measure without a published value, kept beside the page of fidelity.
#include "process/laboratory/published/other_figures.h"

#include <gtest/gtest.h>

#include "process/input/scene_error.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::laboratory {
namespace {

results::LabRow row(const std::string& id, const std::vector<double>& values) {
  results::LabRow row;
  row.id = id, row.quantity = "mass, " + id, row.unit = "g", row.values = values;
  row.grain_diameter = 1.88e-3, row.core_seconds = 12;
  return row;
}

results::LabTable table(const std::string& size, const std::vector<results::LabRow>& rows,
                        const std::string& experiment = "drum") {
  results::LabTable table;
  table.experiment = experiment, table.size = size, table.rows = rows;
  return table;
}

TEST(OtherFigures, AreThoseWithoutAPublishedValue) {
  results::LabRow published = row("N01", {0.6});
  published.published = "0.59";
  std::vector<OtherFigure> kept;
  take_over(kept, {table("coarse", {published, row("a, first", {1, 2}), row("none", {})})});
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].row.id, "a, first");
}

TEST(OtherFigures, AFinerRunReplacesACoarserOneOfItsExperiment) {
  std::vector<OtherFigure> kept;
  take_over(kept, {table("medium", {row("a", {1})}), table("medium", {row("a", {5})}, "damping")});
  take_over(kept, {table("coarse", {row("a", {2})})});
  EXPECT_EQ(kept.at(0).row.values, std::vector<double>{1});
  take_over(kept, {table("published", {row("a", {3})})});
  EXPECT_EQ(kept.at(0).row.values, std::vector<double>{3});
  EXPECT_EQ(kept.at(0).size, "published");
  EXPECT_EQ(kept.at(1).row.values, std::vector<double>{5});
}

TEST(OtherFigures, ThoseThatAnExperimentNoLongerMeasuresAreDropped) {
  std::vector<OtherFigure> kept;
  take_over(kept, {table("coarse", {row("a", {1}), row("b", {2})})});
  take_over(kept, {table("coarse", {row("b", {}), row("c", {3})})});
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].row.id, "b");
  EXPECT_EQ(kept[0].row.values, std::vector<double>{2});
  EXPECT_EQ(kept[1].row.id, "c");
}

TEST(OtherFigures, ComeBackFromTheirFile) {
  const support::TemporaryFolder folder;
  std::vector<OtherFigure> kept;
  take_over(kept, {table("coarse", {row("a, \"first\"", {1, 2.5})})});
  const auto file = folder.write(kOtherFigures, csv_of(kept));
  const auto back = read_other_figures(file);
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].row.id, "a, \"first\"");
  EXPECT_EQ(back[0].row.values, (std::vector<double>{1, 2.5}));
  EXPECT_EQ(csv_of(back), csv_of(kept));
  EXPECT_TRUE(read_other_figures(folder.path() / "none.csv").empty());
}

TEST(OtherFigures, AWrongSizeIsNamedWithItsLine) {
  const support::TemporaryFolder folder;
  const auto file = folder.write(kOtherFigures, "heading\ndrum,huge,a,a,g,1,,1\n");
  try {
    read_other_figures(file);
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("other_figures.csv:2: found \"huge\""), std::string::npos)
        << error.what();
  }
}

TEST(OtherFigures, ThePageHasATableForEachExperiment) {
  std::vector<OtherFigure> kept;
  take_over(kept, {table("coarse", {row("a", {1, 2})}), table("medium", {row("b", {5})}, "damping")});
  const std::string page = other_figures_page(kept);
  EXPECT_NE(page.find("| mass, a | 1.5 +- 0.71 g | 1.88 | 12 | coarse, 2 seeds |"), std::string::npos)
      << page;
  EXPECT_NE(page.find("| mass, b | 5 g | 1.88 | 12 | medium, 1 seed |"), std::string::npos) << page;
  EXPECT_LT(page.find("## damping: "), page.find("## drum: "));
}

}  // namespace
}  // namespace diefill::process::laboratory
