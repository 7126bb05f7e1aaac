// Powder that came into tools where no walls are: what a run says about it.
#include "process/run/stray_watch.h"

#include <gtest/gtest.h>

namespace diefill::process {
namespace {

Tooling with_shoe() {
  Tooling tooling;
  tooling.tools.resize(2);
  tooling.tools[0].spec.name = "die";
  tooling.tools[1].spec.name = "shoe";
  return tooling;
}

constexpr const char* kWhere = "the first into tool \"shoe\" at (1.00, -2.00, 30.00) mm, t = 0.5 s";

TEST(StrayWatch, NamesTheToolAndThePlaceOfTheFirstAndWhatToDo) {
  const Tooling tooling = with_shoe();
  StrayWatch watch(tooling);
  EXPECT_FALSE(watch.warning(100));
  watch.count_removed({7, 1, {1e-3, -2e-3, 30e-3}}, 0.5);
  watch.count_removed({8, 0, {0, 0, 0}}, 0.75);
  const auto warning = watch.warning(100);
  ASSERT_TRUE(warning);
  for (const char* part : {"2 of 100 grains came into tools", kWhere, "economy.skip_far_walls = false"})
    EXPECT_NE(warning->find(part), std::string::npos) << *warning;
}

TEST(StrayWatch, RemedyForAMeshSpeaksOfNoWallSpheres) {
  Tooling tooling = with_shoe();
  tooling.tools[1].wall_mesh.emplace();
  StrayWatch watch(tooling);
  watch.count_removed({7, 1, {1e-3, -2e-3, 30e-3}}, 0.5);
  const std::string warning = watch.warning(100).value_or("");
  for (const char* part : {kWhere, "reduce the speed of the tools", "whose wall is its mesh"})
    EXPECT_NE(warning.find(part), std::string::npos) << warning;
  for (const char* part : {"wall spheres", "skip_far_walls"})
    EXPECT_EQ(warning.find(part), std::string::npos) << warning;
}

TEST(StrayWatch, SaysTheSameAfterARestart) {
  const Tooling tooling = with_shoe();
  StrayWatch watch(tooling), resumed(tooling);
  watch.count_removed({7, 1, {1e-3, -2e-3, 30e-3}}, 0.5);
  resumed.restore(watch.state());
  EXPECT_EQ(resumed.warning(100), watch.warning(100));
}

TEST(StrayWatch, CountsBothHalvesOfAHalfModel) {
  Tooling tooling = with_shoe();
  tooling.mirror = 0;
  StrayWatch watch(tooling);
  watch.count_removed({7, 1, {1e-3, -2e-3, 30e-3}}, 0.5);
  EXPECT_EQ(watch.warning(100).value_or("").find("2 of 200 grains"), 0U);
}

}  // namespace
}  // namespace diefill::process
