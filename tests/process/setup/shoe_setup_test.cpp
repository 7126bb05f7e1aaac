// Shoes that let nothing out, whose rim is too low, or that leave the table.
#include <gtest/gtest.h>

#include "process/setup/setup_findings.h"
#include "process/tooling/examination/shoe_floor.h"
#include "tests/process/box_tools.h"

namespace diefill::process {
namespace {

constexpr double kMm = 1e-3;
constexpr const char* kWait = "[[step]]\nkind = \"wait\"\nduration = \"0.1 s\"\n";

std::string words(const std::vector<SetupFinding>& findings) {
  return findings.empty() ? "" : findings.front().words;
}

void expect_said(const std::vector<SetupFinding>& findings, const std::vector<std::string>& parts) {
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_FALSE(findings[0].places.empty());
  for (const auto& part : parts)
    EXPECT_NE(findings[0].words.find(part), std::string::npos) << findings[0].words;
}

/// The shoe with a floor 1 mm thick whose hole reaches from the left wall to x = `hole` (mm).
geometry::Mesh with_floor(double hole) {
  geometry::Mesh shoe = walls_around_the_pour(40 * kMm);
  if (hole < 51.4) add_box(shoe, {hole * kMm, -14.5 * kMm, 0}, {51.4 * kMm, 14.5 * kMm, 1 * kMm});
  return shoe;
}

TEST(ShoeFloor, ThatClosesTheShoeIsTold) {
  const BoxTools shut(table(), with_floor(19.4), with_steps(kWait));
  expect_said(shoe_floor_findings(shut.scene, shut.tooling),
              {"shoe \"shoe\" is closed below all of its powder, z = 1 mm", "nothing can run out of it"});
  const BoxTools frame(table(), with_floor(51.4), with_steps(kWait));
  EXPECT_EQ(words(shoe_floor_findings(frame.scene, frame.tooling)), "");
}

TEST(ShoeFloor, WithAHoleLetsPowderOut) {
  const BoxTools slit(table(), with_floor(21.4), with_steps(kWait));
  EXPECT_EQ(words(shoe_floor_findings(slit.scene, slit.tooling)), "");
}

TEST(ShoeFloor, OfAShoeThatIsTippedIsNoObstacle) {
  const BoxTools ladle(
      table(), with_floor(19.4),
      with_steps("[[step]]\nkind = \"rotation\"\ntool = \"shoe\"\naxis = \"y\"\nthrough = "
                 "[\"35 mm\", \"0 mm\", \"0 mm\"]\nspeed = \"30 rpm\"\nduration = \"1 s\"\n"));
  EXPECT_FALSE(closed_floor(ladle.scene, ladle.tooling.tools[1]));
}

/// What is said of powder poured 24 mm deep between walls of this height (mm).
std::vector<SetupFinding> said_of_walls(double height) {
  const BoxTools tools(table(), walls_around_the_pour(height * kMm), with_steps(kWait));
  return pour_findings(tools.scene, tools.tooling);
}

TEST(PourFindings, PowderHigherThanTheRimIsTold) {
  expect_said(said_of_walls(15), {"poured up to z = 24 mm", "the walls around it end at z = 15 mm",
                                  "9 mm above them runs over the rim", "lower pour.fill_height to 15 mm"});
  expect_said(said_of_walls(10), {"the walls around it end at z = 10 mm"});
  EXPECT_EQ(words(said_of_walls(25)), "");
  EXPECT_EQ(words(said_of_walls(23.5)), "") << "half a grain looks over it";
}

TEST(PourFindings, APourBoxBesideTheShoeIsTold) {
  support::SceneTables tables = with_steps(kWait);
  tables.pour = support::exchanged(tables.pour, "51.4 mm", "71.4 mm");
  const BoxTools tools(table(), walls_around_the_pour(40 * kMm), tables);
  expect_said(pour_findings(tools.scene, tools.tooling), {"of the pour box", "lies outside the shoe"});
}

/// What is said of a shoe that moves along `direction` by `distance` (mm).
std::vector<SetupFinding> said_of_a_move(const std::string& direction, const std::string& distance,
                                         const std::string& before = "") {
  const BoxTools tools(
      table(), walls_around_the_pour(40 * kMm),
      with_steps(before + "[[step]]\nkind = \"move\"\ntool = \"shoe\"\nvelocity = \"0.1 m/s\"\n" +
                 "direction = \"" + direction + "\"\ndistance = \"" + distance + " mm\"\n"));
  return table_findings(tools.scene, tools.tooling);
}

TEST(TableFindings, AShoeThatGoesOverTheEdgeIsToldWithPlaceAndDistance) {
  // Its opening ends at 51.4 mm, the table at 60 mm.
  const auto over = said_of_a_move("x", "20");
  expect_said(over,
              {"the opening of shoe \"shoe\" goes beyond the edge of the table", "where powder falls off"});
  EXPECT_NE(words(over).find("11 mm past the edge"), std::string::npos) << words(over);
  EXPECT_EQ(words(said_of_a_move("x", "8")), "");
  EXPECT_EQ(words(said_of_a_move("-x", "70")), "");
  EXPECT_EQ(said_of_a_move("y", "20").size(), 1U);
}

TEST(TableFindings, AShoeThatIsLiftedOrWhosePowderIsClearedAwayMayLeave) {
  EXPECT_EQ(
      words(said_of_a_move("x", "20",
                           "[[step]]\nkind = \"move\"\ntool = \"shoe\"\nvelocity = \"0.1 m/s\"\ndirection = "
                           "\"z\"\ndistance = \"5 mm\"\n")),
      "");
  EXPECT_EQ(words(said_of_a_move("x", "20", "[[step]]\nkind = \"clear\"\n")), "");
}

TEST(TableFindings, AShoeThatStartsBesideTheTableIsTold) {
  const BoxTools tools(box_of({-0.06, -0.03, -0.03}, {0.04, 0.03, 0}), walls_around_the_pour(40 * kMm),
                       with_steps(kWait));
  expect_said(table_findings(tools.scene, tools.tooling), {"starts beyond the edge of the table"});
}

}  // namespace
}  // namespace diefill::process
