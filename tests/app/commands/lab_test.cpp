// Experiments with the method from the command line: tables and charts of each, and names that do not exist.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

TEST(Lab, AnExperimentLeavesTablesAndCharts) {
  const support::TemporaryFolder folder;
  const auto out = folder.path() / "limits";
  const Outcome outcome = run_program({"lab", "stability", "rotation", "--quick", "--out", out.string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(SmallDie::files_in(out),
            (std::vector<std::string>{"rotation.json", "rotation_drift.csv", "rotation_drift.png",
                                      "stability.csv", "stability.json"}));
  const auto limits = nlohmann::json::parse(contents(out / "stability.json"));
  ASSERT_EQ(limits.size(), 2U);
  EXPECT_EQ(limits[0]["experiment"], "rotation");
  // A hundred turns of a scheme of second order: between a hundredth and a whole radian a step.
  EXPECT_GT(limits[0]["measured"].get<double>(), 0.01);
  EXPECT_LT(limits[0]["measured"].get<double>(), 1);
}

TEST(Lab, WallSpheresAreHeldAgainstTheMesh) {
  const support::TemporaryFolder folder;
  const auto out = folder.path() / "walls";
  const Outcome outcome = run_program({"lab", "walls", "rebound", "--quick", "--out", out.string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto limits = nlohmann::json::parse(contents(out / "walls.json"));
  ASSERT_EQ(limits.size(), 8U);
  // Finer wall spheres turn a rebound less.
  EXPECT_GT(limits[6]["measured"].get<double>(), 0);
  EXPECT_GT(limits[6]["measured"].get<double>(), limits[0]["measured"].get<double>());
}

TEST(Lab, AnUnknownExperimentEndsInOneLineWithTheNearest) {
  const Outcome outcome = run_program({"lab", "stability", "rotaton"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("did you mean \"rotation\"?"), std::string::npos) << outcome.err;
}

TEST(Lab, WithoutPublishedFiguresNothingIsComputed) {
  const support::TemporaryFolder folder;
  const auto out = folder.path() / "out";
  const std::vector<std::pair<std::string, std::string>> compared = {{"flow", "hopper"},
                                                                     {"stability", "cavity"}};
  for (const auto& [family, name] : compared) {
    const Outcome outcome = run_program(
        {"lab", family, name, "--quick", "--scenes", folder.path().string(), "--out", out.string()});
    EXPECT_EQ(outcome.exit_code, 2) << family;
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    for (const char* part : {"published_figures.csv: cannot be read", "--scenes"})
      EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(out)) << family;
  }
}

TEST(Lab, WithoutOneOfItsPublishedFiguresNothingIsComputed) {
  const support::TemporaryFolder folder;
  const auto out = folder.path() / "out";
  folder.write("published_figures.csv",
               "id,source,section,model,setting,quantity,unit,published,lower,upper,kind,place,experiment\n"
               "M02,,,,,,,,,,,,\n");
  const Outcome outcome = run_program(
      {"lab", "stability", "cavity", "--quick", "--scenes", folder.path().string(), "--out", out.string()});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("published_figures.csv: id: found no row M03"), std::string::npos)
      << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Lab, ThePathOfAPowderMayHoldQuotesAndBackslashes) {
  for (const std::string name : {"a\"b.toml", "a\\tb.toml"}) {
    const support::TemporaryFolder folder;
    const std::string powder = folder.write(name, "[powder]\npreset = \"ASC100.29 D2\"\n").string();
    const Outcome outcome = run_program({"lab", "mean_fractions", "--powder", powder, "--out",
                                         (folder.path() / "out").string(), "--collect", "--quiet"});
    EXPECT_EQ(outcome.err.find("TOML"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("control characters"), std::string::npos) << outcome.err;
  }
}

TEST(Lab, TheListNamesExperimentsWithScenesAndFamilies) {
  const Outcome outcome = run_program({"lab", "--list"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name :
       {"mean_fractions     12 published figures", "angle_of_repose", "stability:", "  time_step:"})
    EXPECT_NE(outcome.out.find(name), std::string::npos) << name << "\n" << outcome.out;
}

TEST(Lab, WithoutAnExperimentItSaysWhatIsMissing) {
  const Outcome outcome = run_program({"lab"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("--list"), std::string::npos) << outcome.err;
}

// What a budget leaves out has a row and its reason; a later call with more finds the runs in place.
TEST(Lab, WhatTheBudgetLeavesOutIsSaid) {
  const support::TemporaryFolder folder;
  const Outcome outcome =
      run_program({"lab", "packing_scatter", "--collect", "--quiet", "--out", folder.path().string()});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const auto kept = folder.path() / "packing_scatter/coarse";
  const auto table = nlohmann::json::parse(contents(kept / "packing_scatter.json"));
  ASSERT_EQ(table["rows"].size(), 16U);
  EXPECT_EQ(table["rows"][0]["verdict"], "no value");
  EXPECT_EQ(table["rows"][0]["reason"], "1 of 1 runs not finished (budget used, or stopped)");
}

// Runs of an experiment share a scene file; pictures and reports name the run.
TEST(Lab, ScenesAreTitledAfterExperimentAndRun) {
  const support::TemporaryFolder folder;
  const Outcome outcome =
      run_program({"lab", "mean_fractions", "--budget", "1e-9", "--quiet", "--out", folder.path().string()});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const std::string scene = contents(folder.path() / "mean_fractions/coarse/D2/seed-1/scene.toml");
  EXPECT_NE(scene.find("mean_fractions: D2"), std::string::npos) << scene;
}

// What was run of another scene stays as it is, and the table says why it does not count.
TEST(Lab, CollectingLeavesFoldersOfRunsAsTheyAre) {
  const support::TemporaryFolder folder;
  const std::vector<std::string> collect = {"lab",     "fill_height", "--collect",
                                            "--quiet", "--out",       folder.path().string()};
  const auto other = folder.path() / "fill_height/coarse/D2__10_mm_of_powder/seed-1";
  std::filesystem::create_directories(other);
  std::ofstream(other / "scene.toml") << "title = \"another\"\n";
  const Outcome outcome = run_program(collect);
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_EQ(contents(other / "scene.toml"), "title = \"another\"\n");
  EXPECT_EQ(SmallDie::files_in(other), std::vector<std::string>{"scene.toml"});
  EXPECT_FALSE(std::filesystem::exists(other.parent_path() / "seed-1-previous-1"));
  const auto table = nlohmann::json::parse(contents(folder.path() / "fill_height/coarse/fill_height.json"));
  EXPECT_NE(table.dump().find("1 of 3 runs of a different scene"), std::string::npos) << table.dump();
}

// Calibrations all write powder.toml, and folders are called by it.
TEST(Lab, KeepsTheDataSheetOfAnotherPowderOfTheSameFileName) {
  const support::TemporaryFolder folder;
  const auto powder = folder.write("powder.toml", "[powder]\npreset = \"ASC100.29 A2\"\n");
  const auto sheet = folder.path() / "out/powder_sheet/coarse_powder";
  const auto run = sheet / "funnel_and_cup/seed-1";
  std::filesystem::create_directories(run);
  std::ofstream(run / "scene.toml") << "title = \"another\"\n";
  std::ofstream(sheet / "data_sheet.html") << "of another";
  const std::vector<std::string> collect = {
      "lab", "powder", powder.string(), "--collect", "--quiet", "--out", (folder.path() / "out").string()};
  const Outcome outcome = run_program(collect);
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;  // no value
  EXPECT_EQ(contents(sheet / "previous-1/data_sheet.html"), "of another");
  EXPECT_NE(outcome.err.find("previous-1"), std::string::npos) << outcome.err;
  EXPECT_NE(contents(sheet / "data_sheet.html"), "of another");
}

TEST(Lab, QuietFidelityPrintsOnlyWhereThePageIs) {
  const support::TemporaryFolder folder;
  const auto page = folder.path() / "FIDELITY.md";
  const Outcome outcome = run_program({"lab", "fidelity", "--collect", "--quiet", "--page", page.string(),
                                       "--out", (folder.path() / "lab").string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1) << outcome.out;
  EXPECT_NE(outcome.out.find(" published figures in " + page.string()), std::string::npos) << outcome.out;
  EXPECT_TRUE(std::filesystem::exists(page));
}

TEST(Lab, HelpOfAnExperimentHasItsOwnExampleAndOptions) {
  const Outcome sawing = run_program({"lab", "wire_sawing", "--help"});
  EXPECT_NE(sawing.out.find("--film"), std::string::npos) << sawing.out;
  const Outcome beds = run_program({"lab", "mean_fractions", "--help"});
  EXPECT_EQ(beds.out.find("--film"), std::string::npos) << beds.out;
  EXPECT_NE(beds.out.find("diefill lab mean_fractions"), std::string::npos) << beds.out;
  EXPECT_EQ(beds.out.find("diefill new"), std::string::npos) << beds.out;
}

}  // namespace
}  // namespace diefill::app
