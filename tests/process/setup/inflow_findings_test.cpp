// Boxes of powder that steps let in, as far as a half model has room for them.
#include <gtest/gtest.h>

#include "process/setup/setup_findings.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

/// What is said of a box of grains of 1.8816 mm that reaches `y` (mm) to both sides of y = 0.
std::string complaint_about_a_box(const std::string& y, bool half_model) {
  const SceneFolder folder;
  support::SceneTables tables;
  tables.steps = "[[step]]\nkind = \"inflow\"\nfrom = [\"20 mm\", \"-" + y +
                 " mm\", \"5 mm\"]\nto = [\"50 mm\", \"" + y + " mm\", \"90 mm\"]\nmass = \"5 g\"\n";
  const Scene scene = read_scene(
      folder.write(support::scene_text(tables) + (half_model ? "\n[economy]\nmirror = \"y\"\n" : "")));
  Tooling tooling;
  tooling.mirror = scene.economy.mirror;
  try {
    inflow_findings(scene, tooling);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

TEST(InflowFindings, HalfABoxNarrowerThanAGrainIsRefused) {
  EXPECT_EQ(complaint_about_a_box("0.9", false), "");
  EXPECT_EQ(complaint_about_a_box("1", true), "");
  const std::string refused = complaint_about_a_box("0.9", true);
  for (const char* part : {"scene.toml:",
                           "the box from (20, -0.9, 5) to (50, 0.9, 90) mm reaches 0.9 mm beyond "
                           "the mirror plane y = 0, but a grain needs 0.9408 mm",
                           "widen the box along y or remove economy.mirror"})
    EXPECT_NE(refused.find(part), std::string::npos) << refused;
}

/// What is said of 100 g/s out of a box of 30 x 20 x 85 mm, under gravity (m/s^2) that a step changes before
/// and one after the inflow.
std::string complaint_about_a_rate(const std::string& at_start, const std::string& then) {
  const auto change = [](const std::string& gravity) {
    return "[[step]]\nkind = \"change\"\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"-" + gravity + " m/s^2\"]\n";
  };
  const SceneFolder folder;
  support::SceneTables tables;
  tables.top += "gravity = \"" + at_start + " m/s^2\"\n";
  tables.steps =
      change(then) +
      "[[step]]\nkind = \"inflow\"\nfrom = [\"20 mm\", \"-10 mm\", \"5 mm\"]\nto = [\"50 mm\", \"10 "
      "mm\", \"90 mm\"]\nmass = \"5 g\"\nrate = \"100 g/s\"\n" +
      change("9.81");
  const Scene scene = read_scene(folder.write(support::scene_text(tables)));
  const auto findings = inflow_findings(scene, Tooling{});
  return findings.empty() ? "" : findings.front().words;
}

// The box holds 0.38 of its 51 cm3 in spheres of 1.8816 mm about the grains: 5,556 of 4.88 mg, 27 g. 85 mm
// take 0.13 s under 9.81 m/s^2, which gives 206 g/s, and ten times as long under a hundredth of it.
TEST(InflowFindings, RatesAreComparedUnderTheGravityOfTheirStep) {
  EXPECT_EQ(complaint_about_a_rate("0.0981", "9.81"), "");
  EXPECT_NE(complaint_about_a_rate("9.81", "0.0981").find("rate is 100 g/s, but the box"), std::string::npos)
      << complaint_about_a_rate("9.81", "0.0981");
}

}  // namespace
}  // namespace diefill::process
