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

}  // namespace
}  // namespace diefill::process
