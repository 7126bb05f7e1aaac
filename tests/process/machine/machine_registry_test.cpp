// Every kind of step that is registered can be asked for, and steps without motion leave tools alone.
#include <gtest/gtest.h>

#include <set>

#include "process/machine/actions/settle.h"
#include "process/machine/actions/wait.h"
#include "process/machine/step_registry.h"

namespace diefill::process {
namespace {

TEST(StepRegistry, NamesEachKindOnce) {
  std::set<std::string> names;
  for (const auto& [name, factory] : step_kinds()) {
    names.insert(name);
    EXPECT_NE(factory, nullptr);
  }
  EXPECT_EQ(names, (std::set<std::string>{"passage", "settle", "wait", "move", "vibration",
                                          "rotational oscillation", "rotation", "table", "piston", "rotor",
                                          "inflow", "clear", "change", "free motion"}));
  EXPECT_EQ(names.size(), step_kinds().size());
}

TEST(Settle, LastsUntilRestUnlessToldATime) {
  EXPECT_EQ(Settle(std::nullopt).duration(), std::nullopt);
  EXPECT_EQ(Settle(std::nullopt).description(), "settling until at rest");
  EXPECT_EQ(Settle(0.2).duration(), 0.2);
  EXPECT_EQ(Settle(0.2).description(), "settling for 0.2 s");
}

TEST(Wait, MovesNothing) {
  const Wait wait(0.05);
  EXPECT_EQ(wait.duration(), 0.05);
  EXPECT_TRUE(wait.tools().empty());
  EXPECT_EQ(wait.motion(0.01).translation, Eigen::Vector3d::Zero());
  EXPECT_EQ(wait.motion(0.01).velocity, Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace diefill::process
