// The ground of experiments without CAD tools.
#include "process/laboratory/endless_ground.h"

#include <gtest/gtest.h>

namespace diefill::process::laboratory {
namespace {

TEST(EndlessGround, ReachesBeyondThePourOnAllSides) {
  Scene scene;
  scene.pour.lower = {-0.01, -0.02, 0.003};
  scene.pour.upper = {0.01, 0.02, 0.05};
  const Tooling ground = endless_ground(scene);
  EXPECT_TRUE(ground.tools.empty());
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LT(ground.standing.lower[axis], scene.pour.lower[axis] - 0.5);
    EXPECT_GT(ground.standing.upper[axis], scene.pour.upper[axis] + 0.5);
  }
}

}  // namespace
}  // namespace diefill::process::laboratory
