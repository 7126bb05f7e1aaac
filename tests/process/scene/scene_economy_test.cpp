// What [economy] makes of a scene.
#include <gtest/gtest.h>

#include "process/powder/material.h"
#include "process/scene/scene.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

Scene with_economy(const std::string& lines) {
  const SceneFolder folder;
  return read_scene(folder.write(faultless_scene() + "\n[economy]\n" + lines));
}

TEST(SceneEconomy, NothingThatChangesResultsIsOnUnlessAskedFor) {
  const Scene scene = with_economy("");
  EXPECT_FALSE(scene.economy.sleep);
  EXPECT_FALSE(scene.economy.mirror);
  EXPECT_TRUE(scene.economy.drop_spilled);
  EXPECT_TRUE(scene.economy.skip_far_walls);
  const auto settings = engine_settings(scene, 1);
  EXPECT_FALSE(settings.sleep);
  EXPECT_TRUE(settings.skip_far_walls);
}

TEST(SceneEconomy, SleepingTakesItsLimits) {
  const auto settings = engine_settings(
      with_economy("sleep = true\nsleep_after = \"2 ms\"\nsleep_energy = 1e-3\nwake_force = 0.3\n"
                   "skip_far_walls = false"),
      1);
  ASSERT_TRUE(settings.sleep);
  EXPECT_EQ(settings.sleep->time, 2e-3);
  EXPECT_EQ(settings.sleep->energy, 1e-3);
  EXPECT_EQ(settings.sleep->force, 0.3);
  EXPECT_FALSE(settings.skip_far_walls);
}

TEST(SceneEconomy, HalfModelPoursHalf) {
  const Scene whole = with_economy(""), half = with_economy("mirror = \"y\"");
  EXPECT_EQ(half.economy.mirror, 1);
  EXPECT_EQ(half.pour.lower.y(), 0);
  EXPECT_EQ(half.pour.upper.y(), whole.pour.upper.y());
  EXPECT_EQ(half.pour.lower.x(), whole.pour.lower.x());
}

}  // namespace
}  // namespace diefill::process
