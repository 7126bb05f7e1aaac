// Places to measure at that neither tools nor powder reach.
#include <gtest/gtest.h>

#include "process/setup/setup_findings.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

/// What is said of `measured`, tables of [measure], where tools stand from -20 to 20 mm and 25 mm below.
std::vector<SetupFinding> findings_of(const std::string& measured) {
  const SceneFolder folder;
  const Scene scene = read_scene(folder.write(faultless_scene() + measured));
  Tooling tooling;
  tooling.all.include(Eigen::Vector3d(-0.02, -0.02, -0.025));
  tooling.all.include(Eigen::Vector3d(0.02, 0.02, 0.01));
  return measure_findings(scene, tooling);
}

const std::string kSection = "[[measure.section]]\nname = \"far\"\nnormal = \"x\"\norigin = ";
const std::string kZone = "[[measure.zone]]\nname = \"rim\"\n";
const std::string kHeap = "[[measure.heap]]\nname = \"pile\"\n";

void expect_one(const std::string& measured, const std::string& words) {
  const auto findings = findings_of(measured);
  ASSERT_EQ(findings.size(), 1U) << measured;
  EXPECT_NE(findings[0].words.find(words + " meets neither tools nor powder"), std::string::npos)
      << findings[0].words;
  EXPECT_EQ(findings[0].words.find('\n'), std::string::npos);
}

TEST(MeasureFindings, WhatLiesOutsideToolsAndPowderIsTold) {
  expect_one(kSection + "[\"9 m\", \"0 mm\", \"0 mm\"]\n", "[[measure.section]] \"far\"");
  expect_one(kZone + "from = [\"100 mm\", \"0 mm\", \"0 mm\"]\nto = [\"110 mm\", \"9 mm\", \"5 mm\"]\n",
             "[[measure.zone]] \"rim\"");
  expect_one(kZone + "inner_radius = \"200 mm\"\n", "[[measure.zone]] \"rim\"");
  expect_one(kZone + "outer_radius = \"5 mm\"\naxis = [\"0 mm\", \"90 mm\", \"0 mm\"]\n",
             "[[measure.zone]] \"rim\"");
  expect_one(kZone + "heights = [\"-50 mm\", \"-40 mm\"]\n", "[[measure.zone]] \"rim\"");
  expect_one(kHeap + "from = [\"0 mm\", \"0 mm\", \"1 m\"]\nto = [\"9 mm\", \"9 mm\", \"2 m\"]\n",
             "[[measure.heap]] \"pile\"");
}

TEST(MeasureFindings, WhatMeetsToolsOrPowderIsNot) {
  EXPECT_TRUE(findings_of("").empty());
  // The pour begins at 19.4 mm and ends at 51.4 mm.
  EXPECT_TRUE(findings_of(kSection + "[\"50 mm\", \"0 mm\", \"0 mm\"]\n").empty());
  EXPECT_TRUE(findings_of(kZone + "inner_radius = \"8 mm\"\nouter_radius = \"12 mm\"\n").empty());
  EXPECT_TRUE(findings_of(kZone + "heights = [\"-24 mm\", \"-12 mm\"]\n").empty());
  EXPECT_TRUE(
      findings_of(kHeap + "from = [\"0 mm\", \"0 mm\", \"0 mm\"]\nto = [\"9 mm\", \"9 mm\", \"5 mm\"]\n")
          .empty());
}

/// What is said where [suction] names the shoe and the step `motion` is all there is.
std::vector<SetupFinding> said_of_suction(const std::string& motion) {
  const SceneFolder folder;
  support::SceneTables tables;
  tables.steps = "[[step]]\ntool = \"shoe\"\n" + motion;
  return suction_findings(read_scene(folder.write(
      support::scene_text(tables) + "\n[suction]\ntool = \"shoe\"\nparticle_diameter = \"0.1 mm\"\n")));
}

TEST(SuctionFindings, AToolThatNeverMovesUpOrDownIsTold) {
  const std::string move = "kind = \"move\"\ndistance = \"5 mm\"\nvelocity = \"0.1 m/s\"\ndirection = ";
  const auto level = said_of_suction(move + "\"x\"\n");
  ASSERT_EQ(level.size(), 1U);
  EXPECT_NE(level[0].words.find("tool \"shoe\" never moves up or down"), std::string::npos) << level[0].words;
  EXPECT_TRUE(said_of_suction(move + "\"z\"\n").empty());
  EXPECT_TRUE(said_of_suction("kind = \"vibration\"\naxis = \"z\"\namplitude = \"1 mm\"\nfrequency = \"20 "
                              "Hz\"\nduration = \"0.5 s\"\n")
                  .empty());
}

}  // namespace
}  // namespace diefill::process
