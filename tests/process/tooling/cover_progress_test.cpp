// How far tools are that are covered side by side.
#include "process/tooling/cover_progress.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace diefill::process {
namespace {

std::future<geometry::WallSpheres> covered() {
  std::promise<geometry::WallSpheres> done;
  done.set_value({});
  return done.get_future();
}

TEST(CoverProgress, CountsToolsByTheirTriangles) {
  CoverProgress progress({{"die", 3e6}, {"punch", 1e6}});
  progress.done(0, 0.5);
  progress.done(1, 1);
  double share = -1;
  std::string doing;
  auto spheres = covered();
  progress.wait_for(0, spheres, 0.2, [&](double reported, const std::string& words) {
    share = reported;
    doing = words;
  });
  EXPECT_DOUBLE_EQ(share, 0.2 + 0.8 * (0.5 * 3 + 1) / 4);
  EXPECT_EQ(doing, "covering \"die\" with wall spheres");
}

TEST(CoverProgress, TellsWhileItWaits) {
  CoverProgress progress({{"die", 1e6}});
  auto slow = std::async(std::launch::async, [&] {
    for (int k = 1; k <= 4; ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      progress.done(0, 0.25 * k);
    }
    geometry::WallSpheres spheres;
    spheres.radius = 7;
    return spheres;
  });
  std::vector<double> reported;
  const auto spheres =
      progress.wait_for(0, slow, 0, [&](double share, const std::string&) { reported.push_back(share); });
  EXPECT_EQ(spheres.radius, 7);
  EXPECT_GE(reported.size(), 2U);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
}

TEST(CoverProgress, PassesOnWhyAToolCannotBeCovered) {
  CoverProgress progress({{"die", 1e6}});
  std::promise<geometry::WallSpheres> failed;
  failed.set_exception(std::make_exception_ptr(geometry::MeshError("too thin")));
  auto spheres = failed.get_future();
  EXPECT_THROW(progress.wait_for(0, spheres, 0, ignore_progress), geometry::MeshError);
}

}  // namespace
}  // namespace diefill::process
