// What runs on ranks refuse before any rank starts.
#include "process/cluster/rank_limits.h"

#include <gtest/gtest.h>

#include "process/input/scene_error.h"

namespace diefill::process::cluster {
namespace {

TEST(RankLimits, RefuseTheFlowAlongAPeriodicAxis) {
  Scene scene;
  scene.numerics.period[0] = 0.02;
  ProbeSpec probe;
  probe.name = "round";
  probe.quantity = ProbeQuantity::flow;
  probe.normal = {0, 0, -1};
  scene.probes = {probe};
  EXPECT_NO_THROW(refuse_unsupported_on_ranks(scene));
  scene.probes.front().normal = {1, 0, 0};
  try {
    refuse_unsupported_on_ranks(scene);
    FAIL() << "ranks do not tell which grains come round";
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("probe \"round\""), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace diefill::process::cluster
