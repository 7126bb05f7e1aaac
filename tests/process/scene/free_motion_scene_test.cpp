// Steps of free motion and start packings in scene files: what they say, and what is refused.
#include <gtest/gtest.h>

#include <fstream>

#include "process/machine/free_motion.h"
#include "process/scene/placed_grains.h"
#include "process/scene/reading/read_sphere_file.h"
#include "process/scene/variants.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

const std::string kFree =
    "[[step]]\nkind = \"free motion\"\ntool = \"shoe\"\nmass = \"2 kg\"\nduration = \"0.1 s\"\n";
const std::string kPassage =
    "[[step]]\nkind = \"passage\"\ntool = \"shoe\"\nvelocity = \"0.2 m/s\"\ndirection = \"-x\"\n";

/// With lines of a free motion in place of the passage; '@' marks the place of the message.
WrongScene free_step(const std::string& name, const std::string& lines, std::vector<std::string> expected) {
  return spoil(name, kPassage, "[[step]]\nkind = \"free motion\"\ntool = \"shoe\"\n" + lines,
               std::move(expected));
}

std::vector<WrongScene> wrong_free_motions() {
  const std::string ends = "\nduration = \"0.1 s\"\n";
  return {
      free_step("mass_and_density", "mass = \"2 kg\"\ndensity = @\"7800 kg/m^3\"" + ends,
                {"step.density", "mass is given as well"}),
      free_step("mass_zero", "mass = @\"0 kg\"" + ends, {"step.mass", "more than 0 kg"}),
      free_step("velocity_off_the_guide",
                "mass = \"2 kg\"\nguide = \"z\"\nvelocity = @[\"1 m/s\", \"0 m/s\", \"0 m/s\"]" + ends,
                {"step.velocity", "along its guide only"}),
      free_step("turning_on_a_guide", "mass = \"2 kg\"\nguide = \"z\"\nturns = @true" + ends,
                {"step.turns", "a tool on a guide does not turn"}),
      free_step(
          "stop_off_the_guide",
          "mass = \"2 kg\"\nguide = \"z\"\nstops = [{ direction = @\"x\", distance = \"5 mm\" }]" + ends,
          {"stops", "direction", "along its guide only"}),
      free_step(
          "restitution_above_one",
          "mass = \"2 kg\"\nstops = [{ direction = \"-z\", distance = \"5 mm\", restitution = @1.5 }]" + ends,
          {"restitution", "found 1.5", "at most 1"}),
      free_step("key_misspelt", "mass = \"2 kg\"\n@gide = \"z\"" + ends,
                {"step.gide", "did you mean \"guide\"?"}),
      spoil("free_and_driven", kPassage, kFree + "\n[[step]]\nkind = @\"passage\"" + kPassage.substr(25),
            {"tool \"shoe\" has a free motion", "remove the other step"}),
      spoil("free_and_asleep", kPassage,
            kFree.substr(0, 16) + "@" + kFree.substr(16) + "[economy]\nsleep = true\n",
            {"a free tool and economy.sleep do not go together"}),
  };
}

class WrongFreeMotions : public testing::TestWithParam<WrongScene> {};

TEST_P(WrongFreeMotions, AreExplainedWithPlaceFindingAndRemedy) {
  const SceneFolder folder;
  try {
    read_scene(folder.write(GetParam().text));
    FAIL() << "the scene was accepted";
  } catch (const SceneError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    for (const std::string& part : GetParam().expected)
      EXPECT_NE(message.find(part), std::string::npos) << "missing: " << part << "\nin:      " << message;
  }
}

INSTANTIATE_TEST_SUITE_P(Scene, WrongFreeMotions, testing::ValuesIn(wrong_free_motions()),
                         [](const auto& instance) { return instance.param.name; });

TEST(FreeMotion, IsReadWithItsGuideStopsAndForce) {
  const SceneFolder folder;
  const std::string lines =
      "density = \"7.2 g/cm^3\"\nguide = \"-z\"\nvelocity = [\"0 m/s\", \"0 m/s\", \"-5 m/s\"]\nforce = [\"0 "
      "N\", "
      "\"0 N\", \"3 N\"]\nstops = [{ direction = \"-z\", distance = \"20 mm\", restitution = 0.4 }]\nrecord "
      "= "
      "\"2 ms\"\nduration = \"0.1 s\"\n";
  const Scene scene = read_scene(folder.write(free_step("any", "@" + lines, {}).text));
  const FreeMotion* free = free_motion_of(*scene.steps.front());
  ASSERT_NE(free, nullptr);
  EXPECT_DOUBLE_EQ(free->density, 7200);
  EXPECT_EQ(free->body.guide, Eigen::Vector3d(0, 0, -1));
  EXPECT_FALSE(free->body.turns);
  EXPECT_EQ(free->body.velocity, Eigen::Vector3d(0, 0, -5));
  EXPECT_EQ(free->body.drive, Eigen::Vector3d(0, 0, 3));
  ASSERT_EQ(free->body.stop_count, 1U);
  EXPECT_DOUBLE_EQ(free->body.stops[0].distance, 0.02);
  EXPECT_DOUBLE_EQ(free->record, 2e-3);
}

TEST(FreeMotion, WithoutPowderFallsToItsStop) {
  FreeMotion free;
  free.body.mass = 1;
  free.body.velocity = {0, 0, -1};
  free.body.stops[0] = {-Eigen::Vector3d::UnitZ(), 0.02, 0};
  free.body.stop_count = 1;
  const FreeTool step("ball", free, 1.0);
  EXPECT_NEAR(step.motion(0.01).translation.z(), -0.01 - 0.5 * 9.81 * 1e-4, 1e-15);
  EXPECT_NEAR(step.motion(0.01).velocity.z(), -1 - 0.0981, 1e-15);
  EXPECT_NEAR(step.motion(0.5).translation.z(), -0.02, 1e-15);
  EXPECT_EQ(step.motion(0.5).velocity.z(), 0);
}

const std::string kPour =
    "from = [\"19.4 mm\", \"-14.5 mm\", \"0 mm\"]\nto = [\"51.4 mm\", \"14.5 mm\", \"110 mm\"]\nfill_height "
    "= "
    "\"24 mm\"\n";

TEST(GrainsFile, GivesPlacesAndTheBoxAboutThem) {
  const SceneFolder folder;
  std::ofstream(folder.path() / "grains.csv")
      << "x [mm], y [mm], z [mm], radius [mm]\n20, 0, 1, 1\n24.5, 2, 3, 1\n";
  const auto file =
      folder.write(support::exchanged(faultless_scene(), kPour, "grains_file = \"grains.csv\"\n"));
  const Scene scene = read_scene(file);
  EXPECT_NEAR((scene.pour.lower - Eigen::Vector3d(0.019, -0.001, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((scene.pour.upper - Eigen::Vector3d(0.0255, 0.003, 0.004)).norm(), 0, 1e-15);
  ASSERT_TRUE(scene.pour.grains_file);
  const auto grains = grains_in_file(*scene.pour.grains_file);
  ASSERT_EQ(grains.size(), 2U);
  EXPECT_NEAR(grains[1].centre.x(), 0.0245, 1e-15);
  EXPECT_NEAR(grains[1].radius, 1e-3, 1e-15);
  // A job in another folder finds the file.
  const std::string text = scene_text_with(scene, 7, [](const auto& path) { return path.string(); });
  EXPECT_NE(text.find((folder.path() / "grains.csv").string()), std::string::npos) << text;
}

TEST(GrainsFile, NamesItsColumnsInAnyOrder) {
  const support::TemporaryFolder folder;
  const auto grains =
      grains_in_file(folder.write("grains.csv", "radius [um], z [m], x [mm], y [mm]\n500, 0.02, 3, 4\n"));
  ASSERT_EQ(grains.size(), 1U);
  EXPECT_NEAR((grains[0].centre - Eigen::Vector3d(3e-3, 4e-3, 0.02)).norm(), 0, 1e-15);
  EXPECT_NEAR(grains[0].radius, 5e-4, 1e-15);
}

TEST(GrainsFile, GrainsInEachOtherAreRefusedWithTheirLines) {
  const SphereRows touching = {{{{0, 0, 0}, 1e-3}, {{1.6e-3, 0, 0}, 1e-3}, {{0, 1.07e-3, 0}, 1e-4}},
                               {2, 3, 5}};
  EXPECT_NO_THROW(refuse_grains_in_each_other(touching, "grains.csv"));
  const auto message = [&](const Eigen::Vector3d& place, double radius) -> std::string {
    SphereRows rows = touching;
    rows.spheres.push_back({place, radius});
    rows.lines.push_back(7);
    try {
      refuse_grains_in_each_other(rows, "grains.csv");
    } catch (const SceneError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_TRUE(message({0, 0, 0}, 1e-3).starts_with("grains.csv:7: this grain overlaps that of line 2"));
  EXPECT_TRUE(
      message({1.6e-3, 1e-4, 0}, 1e-3).starts_with("grains.csv:7: this grain overlaps that of line 3"));
  EXPECT_NE(message({0, -9.4e-4, 0}, 1e-4), "");  // a small one in a large one
  EXPECT_NE(message({0, 1.07e-3, 1e-5}, 1e-4), "");
  EXPECT_EQ(message({0, 0, 5e-2}, 1e-3), "");
}

TEST(GrainsFile, OfAnotherSceneIsNone) {
  const SceneFolder folder;
  EXPECT_FALSE(read_scene(folder.write(faultless_scene())).pour.grains_file);
}

TEST(GrainsFile, IsRefusedBesideABoxAndWhenWrong) {
  const SceneFolder folder;
  const auto message = [&](const std::string& lines) -> std::string {
    try {
      read_scene(folder.write(support::exchanged(faultless_scene(), kPour, lines)));
    } catch (const SceneError& error) {
      return error.what();
    }
    return "";
  };
  std::ofstream(folder.path() / "grains.csv") << "x [mm], y [mm], z [mm], radius [mm]\n20, 0, one, 1\n";
  EXPECT_NE(message("grains_file = \"grains.csv\"\n" + kPour).find("gives all grains; remove the key"),
            std::string::npos);
  EXPECT_NE(message("grains_file = \"grains.csv\"\n").find("grains.csv:2:8: column z: found \"one\""),
            std::string::npos)
      << message("grains_file = \"grains.csv\"\n");
  const auto of_file = [&](const std::string& text) {
    std::ofstream(folder.path() / "grains.csv") << text;
    return message("grains_file = \"grains.csv\"\n");
  };
  const auto expect = [&](const std::string& text, const std::string& part) {
    EXPECT_NE(of_file(text).find(part), std::string::npos) << of_file(text);
  };
  const std::string head = "x [mm], y [mm], z [mm], radius [mm]\n";
  expect(head + "20, 0, inf, 1\n", "grains.csv:2:8: column z: found \"inf\", expected a number");
  expect(head + "1e999, 0, 1, 1\n", "grains.csv:2:1: column x: found \"1e999\", too large");
  expect(head + "20, 0, 1, 0\n", "grains.csv:2:11: column radius: found 0 mm, allowed: 1e-06 to 50 mm");
  expect(head + "20, 0, 1, -1\n", "found -1 mm");
  expect(head + "20, 0, 1, 9000\n", "found 9000 mm");
  expect(head + "900000, 0, 1, 1\n", "column x: found 900000 mm, allowed: -10000 to 10000 mm");
  expect("x [mm], y [mm], z [mm], z [mm]\n", "found column z twice");
  expect("x [mm], y [mm], z [mm]\n20, 0, 1\n", "grains.csv:1: found no column radius");
  expect("x [mm], y [mm], z [mm], radus [mm]\n", "did you mean \"radius\"?");
  expect("x [s], y [mm], z [mm], radius [mm]\n", "grains.csv:1:1: found unit \"s\"");
  EXPECT_NE(message("grains_file = \"none.csv\"\n").find("pour.grains_file"), std::string::npos)
      << message("grains_file = \"none.csv\"\n");
}

}  // namespace
}  // namespace diefill::process
