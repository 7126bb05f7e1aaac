// Pilots that are kept, and time that others had the processors.
#include "process/plan/pilot_cache.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "process/plan/processor_use.h"
#include "process/setup/read_tooling.h"
#include "project_paths.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::plan {
namespace {

Pilot sample() {
  Pilot pilot;
  pilot.grain_diameter = 1e-3;
  pilot.fill_height = 0.01;
  pilot.time_step = 2e-6;
  pilot.fall_time = 0.07;
  pilot.spheres = 12345;
  pilot.wall_seconds = 9.25;
  pilot.processor_share = 0.4;
  pilot.cost[0] = {3.5, 1e8, 0.15, true, 0.7};
  pilot.cost[2] = {0.5, 2e7, 0.05, false, 0.1};
  pilot.rest = {0.11, 0.17};
  pilot.stopped = "time limit reached";
  pilot.size.points = {{1e4, 1e-8, 2e-8}, {1e5, 1.2e-8, 3e-8}};
  return pilot;
}

TEST(KeptPilot, ComesBackAsItWas) {
  const support::TemporaryFolder folder;
  store_pilot(folder.path() / "pilots", "name", sample());
  const auto kept = cached_pilot(folder.path() / "pilots", "name");
  ASSERT_TRUE(kept);
  const Pilot was = sample();
  EXPECT_EQ(kept->spheres, was.spheres);
  EXPECT_EQ(kept->processor_share, was.processor_share);
  EXPECT_EQ(kept->rest.after_motion, was.rest.after_motion);
  EXPECT_EQ(kept->stopped, was.stopped);
  EXPECT_FALSE(kept->cached_since.empty());
  for (std::size_t k = 0; k < was.cost.size(); ++k) {
    EXPECT_EQ(kept->cost[k].wall_seconds, was.cost[k].wall_seconds);
    EXPECT_EQ(kept->cost[k].sphere_steps, was.cost[k].sphere_steps);
    EXPECT_EQ(kept->cost[k].search_seconds, was.cost[k].search_seconds);
    EXPECT_EQ(kept->cost[k].whole, was.cost[k].whole);
  }
  ASSERT_EQ(kept->size.points.size(), 2U);
  EXPECT_EQ(kept->size.points[1].search_seconds, 3e-8);
}

TEST(KeptPilot, WhatCannotBeReadIsNone) {
  const support::TemporaryFolder folder;
  EXPECT_FALSE(cached_pilot(folder.path(), "none"));
  EXPECT_FALSE(cached_pilot({}, "none"));
  for (const char* text : {"", "{", "[]", R"({"format": 0})", R"({"format": 1, "date": 3})"}) {
    folder.write("name.json", text);
    EXPECT_FALSE(cached_pilot(folder.path(), "name")) << text;
  }
  store_pilot("/proc/nowhere", "name", sample());  // no place: no harm
}

TEST(KeptPilot, OldOnesGo) {
  const support::TemporaryFolder folder;
  for (std::size_t k = 0; k < kMaxPilots + 5; ++k) store_pilot(folder.path(), std::to_string(k), sample());
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    count += entry.path().extension() == ".json" ? 1 : 0;
  EXPECT_EQ(count, kMaxPilots);
  EXPECT_TRUE(cached_pilot(folder.path(), std::to_string(kMaxPilots + 4)));
}

TEST(KeptPilot, IsOfTheSameScenesToolsAndThreadsOnly) {
  const std::string file = std::string(DIEFILL_SOURCE_DIR) + "/sample_tools/rectangular_die/fill.toml";
  Scene scene = read_scene(file);
  const Tooling tooling = read_tooling(scene);
  const std::string name = pilot_name(scene, tooling, 2, 15);
  EXPECT_EQ(pilot_name(read_scene(file), tooling, 2, 15), name);
  EXPECT_NE(pilot_name(scene, tooling, 1, 15), name);
  scene.text += "\n# a remark\n";
  EXPECT_EQ(pilot_name(scene, tooling, 2, 15), name);
  scene.text.replace(scene.text.find("seed = "), 8, "seed = 9");
  EXPECT_NE(pilot_name(scene, tooling, 2, 15), name);
}

TEST(ProcessorUse, ShowsThatOthersHadTheProcessors) {
  const auto work_with = [](unsigned threads) {
    const ProcessorUse before = processor_use();
    std::atomic<bool> stop{false};
    std::vector<std::thread> crowd;
    for (unsigned k = 0; k < threads; ++k)
      crowd.emplace_back([&] {
        while (!stop.load(std::memory_order_relaxed)) continue;
      });
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    const double share = processor_use().share_since(before);
    stop = true;
    for (auto& thread : crowd) thread.join();
    return share;
  };
  const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
  EXPECT_LT(work_with(4 * processors), 0.5);  // a quarter at most, and what the scheduler books late
  const ProcessorUse none;
  EXPECT_EQ(none.share_since(none), 1);
}

}  // namespace
}  // namespace diefill::process::plan
