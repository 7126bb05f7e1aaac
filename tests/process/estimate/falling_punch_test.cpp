// Punches that fall under the shoe, and dies that are lifted over them.
#include <gtest/gtest.h>

#include "process/estimate/openings/openings.h"
#include "process/estimate/openings/punch_room.h"
#include "tests/process/estimate/estimate_scene.h"

namespace diefill::process::estimate {
namespace {

constexpr double kMm = 1e-3;
constexpr const char* kVolumetric = "narrow_ring/strategies/volumetric.toml";
const std::pair<std::string, std::string> kNotShaken = {R"([[step]]
kind = "vibration"                         # without it the powder may arch over the ring
tool = "shoe"
axis = "x"
amplitude = "1 mm"
frequency = "2 Hz"
start = { with = "stroke" }
until = { after = "stroke" }
)",
                                                        ""};

TEST(FallingPunch, IsFollowedOnlyWhilePowderStandsOverIt) {
  const Estimate all = estimated(kVolumetric),
                 none = estimated(kVolumetric,
                                  {{"position = [\"0 mm\", \"0 mm\", \"0 mm\"]       # over the ring",
                                    "position = [\"60 mm\", \"0 mm\", \"0 mm\"]"}});
  ASSERT_EQ(all.suctions.size(), 1U);
  EXPECT_NEAR(all.suctions[0].covered, 1, 0.01);
  EXPECT_NEAR(all.openings.at(0).share, 1, 0.01);
  ASSERT_EQ(none.suctions.size(), 1U);
  EXPECT_EQ(none.suctions[0].covered, 0);
  EXPECT_EQ(none.suctions[0].by_weight, 0);
  EXPECT_TRUE(says(all_said(none), "no powder stands over it meanwhile")) << all_said(none);
}

TEST(FallingPunch, GivesNoMoreRoomThanItHasMadeWhenTheShoeLeaves) {
  const Estimate found = estimated(kVolumetric, {kNotShaken,
                                                 {"[[step]]\nkind = \"settle\"\n", ""},
                                                 {R"(velocity = "0.09 m/s")", R"(velocity = "0.09 m/s"
start = { with = "stroke" })"}});
  ASSERT_EQ(found.suctions.size(), 1U);
  const double covered = found.suctions[0].covered;
  EXPECT_GT(covered, 0.1);
  EXPECT_LT(covered, 0.6);
  EXPECT_NEAR(found.suctions[0].by_weight, covered * found.suctions[0].volume_mass,
              0.02 * found.suctions[0].volume_mass);
  EXPECT_NEAR(found.openings.at(0).share, covered, 0.05);
  EXPECT_EQ(found.answer, Answer::too_fast);
}

TEST(FallingPunch, UnderANarrowOpeningThatNothingShakesMayLeaveAnArch) {
  EXPECT_FALSE(estimated(kVolumetric).suctions.at(0).may_arch);
  const Estimate found = estimated(kVolumetric, {kNotShaken});
  EXPECT_TRUE(found.suctions.at(0).may_arch);
  EXPECT_EQ(found.answer, Answer::open);
  EXPECT_TRUE(says(answer_said(found), "powder may arch over lower punch")) << answer_said(found);
}

TEST(FallingPunch, IsAFixedOneInADieThatIsLifted) {
  const Scene scene = sample(kVolumetric, {kNotShaken,
                                           {"tool = \"lower punch\"\ndirection = \"-z\"",
                                            "tools = [\"die\", \"core rod\", \"shoe\"]\ndirection = \"z\""}});
  const Tooling tooling = read_tooling(scene);
  const OpeningLayout layout = find_openings(with_prepared_steps(scene, tooling), tooling);
  ASSERT_EQ(layout.punches.size(), 1U);
  EXPECT_EQ(layout.punches[0].tool, "lower punch");
  EXPECT_NEAR(layout.punches[0].stroke, 20 * kMm, 0.5 * kMm);
  const Estimate found = estimate(scene, tooling);
  EXPECT_NEAR(found.suctions.at(0).covered, 1, 0.01);
  EXPECT_NEAR(found.openings.at(0).share, 1, 0.01);
}

TEST(FallingPunch, ThatDoesNotFillTheOpeningLeavesItOpenFromTheStart) {
  const Scene scene =
      sample(kVolumetric,
             {kNotShaken,
              {"position = [\"0 mm\", \"0 mm\", \"20 mm\"]", "position = [\"0 mm\", \"0 mm\", \"10 mm\"]"},
              {"distance = \"20 mm\"", "distance = \"10 mm\""}});
  const Tooling tooling = read_tooling(scene);
  const OpeningLayout layout = find_openings(with_prepared_steps(scene, tooling), tooling);
  ASSERT_EQ(layout.punches.size(), 1U);
  for (const OpeningPatch& place : layout.places) {
    EXPECT_FALSE(place.opens);
    EXPECT_TRUE(place.punch);
  }
}

TEST(FallingPunch, SaysWhatFollowsItAndWhatSuctionBrings) {
  const auto said = [](double by_weight, double with_air) {
    Estimate found;
    SuctionEstimate suction;
    suction.volume_mass = 0.01;
    suction.covered = 0.5;
    suction.by_weight = by_weight;
    suction.with_air = with_air;
    suction.pull = 0.5;
    found.suctions.push_back(suction);
    return all_said(found);
  };
  EXPECT_TRUE(says(said(0.005, 0.005), "so suction brings nothing more while powder flows"));
  EXPECT_TRUE(says(said(0.002, 0.003), "follow by their own weight, suction brings 1 g more"))
      << said(0.002, 0.003);
  EXPECT_TRUE(says(said(0.002, 0.002), "follow by their own weight, and suction brings nothing more"));
  EXPECT_TRUE(says(said(0, 0), "; no powder runs in by its own weight, nor by suction; the air it draws"))
      << said(0, 0);
}

TEST(OpeningLayout, PlacesBelongToTheCavityBelowThem) {
  const Scene scene = sample("small_dies/pair.toml");
  const Tooling tooling = read_tooling(scene);
  const OpeningLayout layout = find_openings(with_prepared_steps(scene, tooling), tooling);
  ASSERT_EQ(layout.openings.size(), 2U);
  EXPECT_NEAR(layout.openings[0].area, 14 * 7 * kMm * kMm, 2 * kMm * kMm);
  EXPECT_NEAR(layout.openings[1].area, 12 * 8 * kMm * kMm, 2 * kMm * kMm);
  for (const OpeningPatch& place : layout.places) {
    const geometry::Box& box = place.opening == 0 ? tooling.cavity.box : tooling.other_cavities.at(0).box;
    EXPECT_GT(place.at.x(), box.lower.x() - 0.3 * kMm);
    EXPECT_LT(place.at.x(), box.upper.x() + 0.3 * kMm);
  }
}

}  // namespace
}  // namespace diefill::process::estimate
