// The alarm that ends a pilot: it goes off when its time is over, and not when it is gone before.
#include "process/plan/alarm.h"

#include <gtest/gtest.h>

namespace diefill::process::plan {
namespace {

/// Whether the flag is set within a time that only a hung alarm would take.
bool goes_off(const std::atomic<bool>& flag) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!flag && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return flag;
}

TEST(Alarm, GoesOffWhenItsTimeIsOver) {
  std::atomic<bool> flag{false};
  const Alarm alarm(0.001, flag);
  EXPECT_TRUE(goes_off(flag));
}

TEST(Alarm, GoneBeforeItSetsNothing) {
  std::atomic<bool> flag{false};
  { const Alarm alarm(3600, flag); }
  EXPECT_FALSE(flag);
}

TEST(Alarm, CanBeSetAnew) {
  std::atomic<bool> flag{false};
  Alarm alarm(3600, flag);
  alarm.postpone(7200);
  EXPECT_FALSE(flag);
  alarm.postpone(0.001);
  EXPECT_TRUE(goes_off(flag));
}

}  // namespace
}  // namespace diefill::process::plan
