// Exact results that need no bed, and figures of comparisons of strategies.
#include <gtest/gtest.h>

#include <map>

#include "process/input/scene_error.h"
#include "process/laboratory/published/comparisons.h"
#include "process/laboratory/published/experiments.h"
#include "project_paths.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::laboratory {
namespace {

std::vector<PublishedFigure> all_figures() {
  return read_published_figures(std::filesystem::path(DIEFILL_SOURCE_DIR) /
                                "sample_tools/laboratory/published_figures.csv");
}

TEST(ClosedForms, AreAllMet) {
  const auto figures = all_figures();
  const SeedResults none(1, {});
  int met = 0;
  for (const LabQuantity& quantity : plan_closed_forms({}).quantities) {
    const PublishedFigure& figure = figure_called(figures, quantity.id);
    const double value = quantity.value(none);
    EXPECT_FALSE(value < figure.lower) << quantity.id << ": " << value;
    EXPECT_FALSE(value > figure.upper) << quantity.id << ": " << value;
    met += value == value ? 1 : 0;
  }
  EXPECT_EQ(met, 29);
}

TEST(ComparedFigures, OfTheTreeHaveAVerdict) {
  const auto table = compared_figures(
      std::filesystem::path(DIEFILL_SOURCE_DIR) / "sample_tools/laboratory/comparisons.csv", all_figures());
  EXPECT_EQ(table.rows.size(), 19U);
  const std::map<std::string, std::string> others = {{"M02", "`diefill run"},
                                                     {"M03", "`diefill lab stability cavity`"}};
  for (const auto& row : table.rows) {
    EXPECT_TRUE(row.verdict == "met" || row.verdict == "not met") << row.id;
    const std::string command = others.contains(row.id) ? others.at(row.id) : "diefill compare";
    EXPECT_NE(row.reason.find(command), std::string::npos) << row.id;
  }
}

TEST(ComparedFigures, AWrongLineIsNamed) {
  const support::TemporaryFolder folder;
  const auto message = [&](const std::string& line) {
    try {
      compared_figures(folder.write("some.csv", "id,value,d_mm,command\n" + line + "\n"), all_figures());
    } catch (const SceneError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message("M15,0.1").find("some.csv:2: found 2 fields"), std::string::npos);
  EXPECT_NE(message("M99,0.1,0.94,x").find("no published figure \"M99\""), std::string::npos);
  EXPECT_NE(message("M15,much,0.94,x").find("found \"much\", expected a number"), std::string::npos);
  EXPECT_TRUE(message("M15,0.001,0.94,x").empty());
}

TEST(ComparedFigures, OfAMissingFileAreNone) {
  EXPECT_TRUE(compared_figures("/nowhere/comparisons.csv", all_figures()).rows.empty());
}

}  // namespace
}  // namespace diefill::process::laboratory
