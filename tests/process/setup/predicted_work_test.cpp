// Work that cannot end here is refused with its numbers before it begins.
#include "process/setup/predicted_work.h"

#include <gtest/gtest.h>

#include "process/setup/wall_sphere_limit.h"
#include "process/tooling/machine_memory.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

/// What is said of the faultless scene with `old` exchanged for `text`.
std::string complaint(const std::string& old, const std::string& text) {
  const SceneFolder folder;
  const Scene scene = read_scene(folder.write(support::exchanged(faultless_scene(), old, text)));
  try {
    refuse_excessive_work(scene);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
  for (const auto& part : parts) EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(ForeseenWork, ScenesOfDaysPass) {
  EXPECT_EQ(complaint("seed = 1", "seed = 2"), "");
  EXPECT_EQ(complaint("[[step]]", "[[step]]\nkind = \"wait\"\nduration = \"1000 s\"\n[[step]]"), "");
}

TEST(ForeseenWork, StepsWithoutEndAreCounted) {
  for (const char* key :
       {"time_step_fraction = 1e-300", "time_step = \"1e-300 s\"", "time_step_fraction = 1e-9"})
    expect_parts(complaint("max_time = \"5 s\"", std::string("max_time = \"5 s\"\n") + key),
                 {"scene.toml: ", " s of simulated time in time steps of ", " steps, allowed: at most 1e+10",
                  "use a longer time step (numerics.time_step_fraction"});
}

TEST(ForeseenWork, GrainsThatNoMemoryHoldsAreCounted) {
  const std::string message = complaint("1.88 mm\"\n\n[walls]\nsphere_radius = \"0.15 mm\"\nspacing = 1.6",
                                        "0.047 mm\"\n\n[walls]\nspacing = 1.4");
  expect_parts(message, {" grains of 0.04704 mm (", " spheres) would need about ", " GB of memory, but only ",
                         " GB are available; use grains of 0.", " mm or more (powder.grain_diameter)"});
}

TEST(ForeseenWork, AHalfModelHasHalfTheGrainsThatAreLetIn) {
  const std::string feed =
      "[[step]]\nkind = \"inflow\"\nfrom = [\"20 mm\", \"-10 mm\", \"0 mm\"]\nto = [\"50 mm\", \"10 mm\", "
      "\"90 "
      "mm\"]\nmass = \"1000 kg\"\n[[step]]";
  // 1000 kg / (7.63e-8 kg * 4^3), beside which the 4,500 poured are few.
  expect_parts(complaint("[[step]]", feed), {"scene.toml: 2.05e+08 grains of "});
  expect_parts(complaint("[[step]]", "[economy]\nmirror = \"y\"\n" + feed),
               {"scene.toml: 1.02e+08 grains of "});
}

TEST(ForeseenWork, SnapshotsWithoutEndAreCounted) {
  expect_parts(complaint("[measure]", "[[snapshot]]\nname = \"s\"\nevery = \"1e-9 s\"\n[measure]"),
               {"snapshot \"s\": every 1e-09 s of 0.25 s makes 2.5e+08 folders",
                "allowed: at most 1e+04; increase every"});
}

/// What is said of a face of 0.24 m^2 that powder reaches all of, covered with spheres of `radius` (mm).
std::string complaint_about_walls(const std::string& radius) {
  const SceneFolder folder;
  const Scene scene = read_scene(folder.write(support::exchanged(
      faultless_scene(), "sphere_radius = \"0.15 mm\"", "sphere_radius = \"" + radius + " mm\"")));
  Tooling tooling;
  tooling.tools.emplace_back();
  tooling.tools[0].spec = scene.tools[0];
  tooling.tools[0].mesh.vertices = {{0, 0, 0}, {0.6, 0, 0}, {0.6, 0.4, 0}, {0, 0.4, 0}};
  tooling.tools[0].mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  try {
    refuse_too_many_wall_spheres(scene, tooling, [](auto&&...) { return true; });
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

TEST(ForeseenWork, TwoMillionWallSpheresAreTheMost) {
  // In squares of 1.6 radii.
  EXPECT_EQ(complaint_about_walls("0.22"), "");
  const std::string message = complaint_about_walls("0.2"), advice = "use a radius of ";
  expect_parts(
      message,
      {"tool \"die\": covering the reachable surface needs about 2.34e+06 wall spheres of radius 0.2 mm",
       "allowed here: at most 2e+06", "(walls.sphere_radius or the tool's), or a wider spacing"});
  const auto begin = message.find(advice) + advice.size();
  EXPECT_EQ(complaint_about_walls(message.substr(begin, message.find(" mm", begin) - begin)), "") << message;
}

TEST(ForeseenWork, MemoryOfTheMachineIsKnown) {
  EXPECT_GT(machine_memory(), 1e8);
  EXPECT_LT(machine_memory(), 1e14);
  EXPECT_NO_THROW(refuse_memory("a bed", 1000, 1000, 0, "take less"));
  EXPECT_THROW(refuse_memory("a bed", 1e12, 0, 0, "take less"), SceneError);
}

}  // namespace
}  // namespace diefill::process
