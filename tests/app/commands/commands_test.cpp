// The command line: help, wrong arguments, and what check, map and info do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <regex>
#include <string>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

const char* const kCommands[] = {"new", "run", "check", "map", "info", "powders", "bench"};

TEST(CommandLine, HelpShowsAnExampleOfEveryCommand) {
  for (const std::string command : kCommands) {
    SCOPED_TRACE(command);
    const Outcome outcome = run_program({command, "--help"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("Example"), std::string::npos);
    EXPECT_NE(outcome.out.find("  diefill " + command + " "), std::string::npos) << outcome.out;
  }
  const Outcome outcome = run_program({"--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  for (const std::string command : kCommands)
    EXPECT_NE(outcome.out.find("  diefill " + command + " "), std::string::npos) << outcome.out;
}

TEST(CommandLine, VersionNamesCompilerInstructionSetAndLibraries) {
  const Outcome outcome = run_program({"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.out.starts_with("diefill ")) << outcome.out;
  for (const char* name : {"\nInstruction set: ", "\nLibraries: Eigen ", ", Voro++, ", ", VTK ", ", Qt "})
    EXPECT_NE(outcome.out.find(name), std::string::npos) << name << " in " << outcome.out;
  EXPECT_TRUE(std::regex_search(outcome.out, std::regex("\nCompiler: .*(GCC|Clang) [0-9]+\\.[0-9]")))
      << outcome.out;
  for (const char* name : {"CGAL", "assimp", "OpenCASCADE", "lib3mf", "Embree", "NLopt", "HDF5"})
    EXPECT_TRUE(std::regex_search(outcome.out, std::regex(std::string(", ") + name + " [0-9]+\\.[0-9]")))
        << name << " in " << outcome.out;
}

TEST(CommandLine, WrongWordsExitWithTwo) {
  const SmallDie die;
  const std::string scene = die.scene().string();
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"fill", scene},
      {"run"},
      {"check"},
      {"run", scene, "--threads", "0"},
      {"run", scene, "--threads", "two"},
      {"run", scene, "--speed", "3"},
      {"check", scene, "more"},
      {"info"},
      {"map"},
      {"bench"},
      {"bench", "cubes"},
      {"map", die.folder().string(), "--normal", "up"},
      {"map", die.folder().string(), "--origin", "0 mm", "0 mm"},
  };
  for (const auto& arguments : wrong) {
    SCOPED_TRACE(testing::PrintToString(arguments));
    const Outcome outcome = run_program(arguments, {die.folder(), {}});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err, "");
  }
  EXPECT_FALSE(std::filesystem::exists(die.folder() / "out"));
}

TEST(CommandLine, MissingSceneIsNamed) {
  for (const std::string command : {"run", "check"}) {
    const Outcome outcome = run_program({command, "/no/such/scene.toml"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find("/no/such/scene.toml"), std::string::npos) << outcome.err;
  }
}

TEST(CommandLine, MapAndInfoRefuseADirectoryWithoutResults) {
  const SmallDie die;
  for (const std::string command : {"map", "info"}) {
    for (const auto& directory : {die.folder(), die.folder() / "none", die.scene()}) {
      const Outcome outcome = run_program({command, directory.string()});
      EXPECT_EQ(outcome.exit_code, 2) << directory;
      EXPECT_EQ(outcome.out, "");
      EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
      EXPECT_NE(outcome.err.find("results.h5"), std::string::npos) << outcome.err;
    }
  }
}

TEST(Check, DescribesEveryToolAndWritesNothing) {
  const SmallDie die;
  const auto files = SmallDie::files_in(die.folder());
  const Outcome outcome = run_program({"check", die.scene().string()}, {die.folder(), {}});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(SmallDie::files_in(die.folder()), files);
  for (const std::string tool : {"die (die): 28 triangles, 21.00 x 7.00 x 5.00 mm, volume 0.671 cm3",
                                 "shoe (shoe): 32 triangles, 6.20 x 6.20 x 10.00 mm, volume 0.1344 cm3"}) {
    const std::size_t start = outcome.out.find(tool);
    ASSERT_NE(start, std::string::npos) << outcome.out;
    const std::size_t line = outcome.out.find("wall spheres: ", start);
    ASSERT_NE(line, std::string::npos);
    const std::string spheres = outcome.out.substr(line, outcome.out.find('\n', line) - line);
    double count = 0, radius = 0, mean = 0, largest = 0, gap = 0;
    EXPECT_EQ(std::sscanf(
                  spheres.c_str(),
                  "wall spheres: %lf of radius %lf mm; envelope to CAD surface: mean %lf mm, largest %lf mm; "
                  "largest gap %lf mm",
                  &count, &radius, &mean, &largest, &gap),
              5)
        << spheres;
    EXPECT_GT(count, 500);
    EXPECT_EQ(radius, 0.25);
    EXPECT_GT(mean, 0);
    EXPECT_LT(mean, largest);
    EXPECT_LT(largest, 0.25);
    // A flat square grid leaves 2 (1.6 / sqrt(2) - 1) R_w = 0.0657 mm; none may leave more than a fifth above
    // it.
    EXPECT_GT(gap, 0);
    EXPECT_LT(gap, 0.079);
  }
  EXPECT_NE(
      outcome.out.find("cavity: volume 0.064 cm3, depth 4.00 mm below z = 0.00 mm, narrowest width 4.000 mm"),
      std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("138 grains of d = 1 mm"), std::string::npos) << outcome.out;
}

TEST(Check, TakesTheTopOfTheDieForTheFillPlane) {
  const SmallDie die;
  die.exchange("file = \"die.stl\"\n", "file = \"die.stl\"\nposition = [\"0 mm\", \"0 mm\", \"12 mm\"]\n");
  die.exchange("position = [\"3 mm\", \"0 mm\", \"0 mm\"]", "position = [\"3 mm\", \"0 mm\", \"12 mm\"]");
  die.exchange("\"-2.5 mm\", \"0 mm\"]", "\"-2.5 mm\", \"12 mm\"]");
  die.exchange("\"2.5 mm\", \"9 mm\"]", "\"2.5 mm\", \"21 mm\"]");
  const Outcome top = run_program({"check", die.scene().string()});
  EXPECT_EQ(top.exit_code, 0) << top.err;
  EXPECT_NE(top.out.find("cavity: volume 0.064 cm3, depth 4.00 mm below z = 12.00 mm"), std::string::npos)
      << top.out;
  // A scene that states another height has its way.
  die.exchange("[measure]\n", "[measure]\nfill_plane = \"11 mm\"\n");
  const Outcome stated = run_program({"check", die.scene().string()});
  EXPECT_EQ(stated.exit_code, 0) << stated.err;
  EXPECT_NE(stated.out.find("cavity: volume 0.048 cm3, depth 3.00 mm below z = 11.00 mm"), std::string::npos)
      << stated.out;
}

TEST(Map, DrawsOtherSectionsAndAveragingFromResultsAlone) {
  const SmallDie die;
  die.exchange("velocity = \"0.1 m/s\"", "velocity = \"0.2 m/s\"");
  ASSERT_EQ(die.run({"--quiet"}).exit_code, 0);
  for (const char* input : {"die.stl", "shoe.stl", "scene.toml"})
    std::filesystem::remove(die.folder() / input);
  const std::string section = contents(die.out() / "section.png"),
                    stored = contents(die.out() / "results.h5");

  const auto other = die.folder() / "other" / "maps";
  const Outcome outcome =
      run_program({"map", die.out().string(), "--normal", "z", "--origin", "-3 mm", "0 mm", "-3 mm",
                   "--averaging-width", "0.8 mm", "--out", other.string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(SmallDie::files_in(other),
            (std::vector<std::string>{"fill_level.png", "fill_level_map.png", "height_profile.png",
                                      "plan_map.png", "section.png", "snapshot.png"}));
  EXPECT_NE(outcome.out.find((other / "section.png").string() + "\n"), std::string::npos) << outcome.out;
  EXPECT_FALSE(contents(other / "section.png") == section);
  EXPECT_TRUE(contents(die.out() / "results.h5") == stored);

  for (const std::string width : {"0 mm", "-1 mm", "1", "1 s", "wide"}) {
    const Outcome wrong = run_program({"map", die.out().string(), "--averaging-width=" + width});
    EXPECT_EQ(wrong.exit_code, 2) << width;
    EXPECT_EQ(wrong.complaints(), 1U) << wrong.err;
    EXPECT_NE(wrong.err.find("--averaging-width"), std::string::npos) << wrong.err;
  }
}

TEST(Map, RedrawsWithTheWidthOfTheRun) {
  const SmallDie die;
  die.exchange("velocity = \"0.1 m/s\"", "velocity = \"0.2 m/s\"");
  die.exchange("[measure]\n", "[measure]\naveraging_width = \"0.8 mm\"\n");
  ASSERT_EQ(die.run({"--quiet"}).exit_code, 0);
  const auto again = die.folder() / "again", finer = die.folder() / "finer";
  ASSERT_EQ(run_program({"map", die.out().string(), "--out", again.string()}).exit_code, 0);
  ASSERT_EQ(run_program({"map", die.out().string(), "--averaging-width", "0.5 mm", "--out", finer.string()})
                .exit_code,
            0);
  for (const char* picture : {"plan_map.png", "section.png"}) {
    EXPECT_TRUE(contents(again / picture) == contents(die.out() / picture)) << picture;
    EXPECT_FALSE(contents(finer / picture) == contents(die.out() / picture)) << picture;
  }
}

TEST(Map, TheViewHasTheColoursOfTheRunsOwnPictures) {
  const SmallDie die;
  die.exchange("velocity = \"0.1 m/s\"", "velocity = \"0.2 m/s\"");
  ASSERT_EQ(die.run({"--quiet"}).exit_code, 0);
  ASSERT_EQ(run_program({"map", die.out().string(), "--picture", "view"}).exit_code, 0);
  EXPECT_TRUE(contents(die.out() / "view.png") == contents(die.out() / "snapshot.png"));
}

TEST(Check, RefusesAnAveragingWidthBeyondTheCavity) {
  const SmallDie die;
  die.exchange("[measure]\n", "[measure]\naveraging_width = \"100 mm\"\n");
  const Outcome outcome = die.check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("measure.averaging_width: found 100 mm, allowed: at most "), std::string::npos)
      << outcome.err;
}

}  // namespace
}  // namespace diefill::app
