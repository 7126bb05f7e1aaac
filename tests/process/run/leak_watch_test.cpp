#include "process/run/leak_watch.h"

#include <gtest/gtest.h>

namespace diefill::process {
namespace {

/// A cavity of 10 x 10 x 10 mm, its top at z = 0.
Tooling with_cavity() {
  Tooling tooling;
  tooling.cavity.found = true;
  tooling.cavity.box.include(Eigen::Vector3d(0, 0, -0.01));
  tooling.cavity.box.include(Eigen::Vector3d(0.01, 0.01, 0));
  return tooling;
}

void leave(LeakWatch& watch, const Eigen::Vector3d& place, int grains) {
  for (int n = 0; n < grains; ++n) watch.count_removed(place);
}

TEST(LeakWatch, CountsWhatLeavesBeneathTheCavityAndNotWhatIsSpilled) {
  const Tooling tooling = with_cavity();
  LeakWatch watch(tooling, 1e-3);
  leave(watch, {0.005, 0.005, -0.03}, 5);
  leave(watch, {-0.0009, 0.0109, -0.03}, 2);  // drifted
  leave(watch, {-0.02, 0.005, -0.03}, 40);    // over the table's edge
  leave(watch, {0.005, 0.005, 0.03}, 40);
  EXPECT_EQ(watch.grains(), 7U);
}

TEST(LeakWatch, WarnsFromAThousandthOfThePowderOn) {
  const Tooling tooling = with_cavity();
  LeakWatch watch(tooling, 1e-3);
  leave(watch, {0.005, 0.005, -0.03}, 10);
  EXPECT_FALSE(watch.warning(10000));
  leave(watch, {0.005, 0.005, -0.03}, 1);
  const auto warning = watch.warning(10000);
  ASSERT_TRUE(warning);
  EXPECT_NE(warning->find("11 of 10000 grains leaked out below the cavity"), std::string::npos) << *warning;
}

TEST(LeakWatch, HasNewsOnce) {
  const Tooling tooling = with_cavity();
  LeakWatch watch(tooling, 1e-3);
  EXPECT_FALSE(watch.first_warning(100));
  leave(watch, {0.005, 0.005, -0.03}, 50);
  EXPECT_TRUE(watch.first_warning(100));
  EXPECT_FALSE(watch.first_warning(100));
  EXPECT_TRUE(watch.warning(100));
}

TEST(LeakWatch, HasNewsOnceThoughARunIsResumed) {
  const Tooling tooling = with_cavity();
  LeakWatch watch(tooling, 1e-3), resumed(tooling, 1e-3);
  leave(watch, {0.005, 0.005, -0.03}, 50);
  EXPECT_TRUE(watch.first_warning(100));
  resumed.restore(watch.state());
  EXPECT_EQ(resumed.grains(), 50U);
  EXPECT_FALSE(resumed.first_warning(100));
}

TEST(LeakWatch, CountsBothHalvesOfAHalfModel) {
  Tooling tooling = with_cavity();
  tooling.mirror = 0;
  LeakWatch watch(tooling, 1e-3);
  leave(watch, {0.005, 0.005, -0.03}, 50);
  const auto warning = watch.warning(100);
  ASSERT_TRUE(warning);
  EXPECT_NE(warning->find("100 of 200 grains"), std::string::npos) << *warning;
}

TEST(LeakWatch, IsSilentWithoutACavity) {
  const Tooling tooling;
  LeakWatch watch(tooling, 1e-3);
  leave(watch, {0.005, 0.005, -0.03}, 50);
  EXPECT_FALSE(watch.warning(100));
}

}  // namespace
}  // namespace diefill::process
