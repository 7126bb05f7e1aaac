// What estimates make of the shoe's motion: many passages, stands, shaking, a cavity that is open at first.
#include <gtest/gtest.h>

#include "process/estimate/discharge/inflow.h"
#include "tests/process/estimate/estimate_scene.h"

namespace diefill::process::estimate {
namespace {

constexpr double kMm = 1e-3;
constexpr const char* kSquare = "small_dies/square.toml";

TEST(EstimateOfMotion, TenPassagesCountAsTen) {
  const Estimate eight = estimated(kSquare, {{"passages = 1", "passages = 8"}});
  const Estimate ten = estimated(kSquare, {{"passages = 1", "passages = 10"}});
  ASSERT_EQ(ten.openings.at(0).offered.size(), 10U);
  EXPECT_EQ(ten.path.crossings, 10U);
  for (std::size_t n = 0; n < 10; ++n)
    EXPECT_NEAR(ten.openings[0].offered[n], eight.openings.at(0).offered.at(n % 2),
                0.03 * eight.openings[0].offered[0]);
  EXPECT_NEAR(ten.path.speed, 0.2, 0.005);
}

TEST(EstimateOfMotion, AShoeThatStandsAndGoesBackHasTheSpeedOfItsMotion) {
  const Estimate found = estimated(kSquare, {{kPassageOfSquare, R"([[step]]
kind = "move"
tool = "shoe"
direction = "-x"
distance = "23 mm"
velocity = "0.2 m/s"

[[step]]
kind = "wait"
duration = "20 ms"

[[step]]
kind = "move"
tool = "shoe"
direction = "x"
distance = "23 mm"
velocity = "0.2 m/s"
)"}});
  EXPECT_EQ(found.path.crossings, 1U);
  EXPECT_GT(found.path.speed, 0.12);  // it brakes over the cavity
  EXPECT_LT(found.path.speed, 0.201);
  EXPECT_NEAR(found.path.standing, 0.02, 0.002);
  EXPECT_GT(found.openings.at(0).share, 0.3);
  ASSERT_TRUE(found.openings[0].speed_once);
  const std::string said = all_said(found);
  EXPECT_TRUE(says(said, "and a dwell of 0.02 s")) << said;
  for (const char* wrong : {"standing over it", "does not fill in 100", "widen the opening"})
    EXPECT_FALSE(says(said, wrong)) << said;
}

TEST(EstimateOfMotion, AStandIsNotShortenedByAFasterShoe) {
  OpeningPatch place;
  place.width = place.chord = 8 * kMm;
  ShoePath path;
  path.extent = 1;
  const Exposure exposure = {0, 0.5, 0.1, 16 * kMm, 16 * kMm};
  const InflowPowder powder{discharge_of({}), 3000, 0};
  const Portions once = portions_of(place, exposure, path, powder),
                 fast = portions_of(place, exposure, path, powder, 10);
  EXPECT_NEAR(once.count, 2, 1e-12);
  EXPECT_NEAR(once.seconds, 0.05, 1e-12);
  EXPECT_NEAR(fast.seconds, 0.005, 1e-12);
  EXPECT_NEAR(once.standing, 0.4, 1e-12);
  EXPECT_EQ(fast.standing, once.standing);
}

TEST(EstimateOfMotion, AShoeThatOnlyStandsHasNoCriticalSpeed) {
  const Estimate found = estimated("narrow_ring/strategies/volumetric.toml", {{R"([[step]]
kind = "passage"                           # strikes off what stands above the rim
tool = "shoe"
direction = "-x"
velocity = "0.09 m/s"
)",
                                                                               ""}});
  EXPECT_EQ(found.path.speed, 0);
  EXPECT_FALSE(says(all_said(found), "shoe speed: "));
  EXPECT_TRUE(says(answer_said(found), "the shoe standing over it"));
}

TEST(EstimateOfMotion, ShakingOfTheShoeIsNoCrossing) {
  const Estimate still = estimated("narrow_ring/strategies/cavity_vibration_after.toml"),
                 shaken = estimated("narrow_ring/strategies/shoe_vibration.toml");
  EXPECT_EQ(shaken.path.crossings, 1U);
  EXPECT_NEAR(shaken.path.speed, 0.09, 1e-3);
  EXPECT_NEAR(shaken.openings.at(0).share, still.openings.at(0).share, 0.01);
}

TEST(EstimateOfMotion, ACavityThatIsOpenDuringThePourIsFullAfterIt) {
  const Estimate found = estimated(kSquare, {{"\"23 mm\", \"0 mm\"", "\"0 mm\", \"0 mm\""},
                                             {"from = [\"11 mm\"", "from = [\"-12 mm\""},
                                             {"to = [\"35 mm\"", "to = [\"12 mm\""}});
  const OpeningEstimate& cavity = found.openings.at(0);
  EXPECT_GT(cavity.poured, kWhole);
  EXPECT_EQ(cavity.share, 1);
  EXPECT_EQ(cavity.mass.back(), cavity.full_mass);
  EXPECT_EQ(found.answer, Answer::fills);
  EXPECT_TRUE(says(answer_said(found), "powder poured over it")) << answer_said(found);
  EXPECT_EQ(estimated(kSquare).openings.at(0).poured, 0);
}

TEST(EstimateOfMotion, WhatIsPouredOverAnOpenSlitRunsOut) {
  constexpr const char* kSlit = "slit_plate/discharge_6mm.toml";
  const Estimate beside = estimated(kSlit),
                 over = estimated(kSlit, {{"\"58 mm\", \"0 mm\"", "\"0 mm\", \"0 mm\""},
                                          {"from = [\"42 mm\"", "from = [\"-16 mm\""},
                                          {"to = [\"74 mm\"", "to = [\"16 mm\""}});
  EXPECT_FALSE(beside.openings.at(0).runs_out());
  EXPECT_LT(beside.openings[0].mass.back(), 0.9 * beside.powder.in_shoe);
  const OpeningEstimate& slit = over.openings.at(0);
  EXPECT_GT(slit.poured, kWhole);
  EXPECT_NEAR(slit.mass.back(), over.powder.in_shoe, 1e-9 * over.powder.in_shoe);
  EXPECT_GT(slit.least_mass, 0);
  EXPECT_LT(slit.least_mass, slit.mass.back());
  EXPECT_TRUE(says(answer_said(over), "what is poured over it runs out before it rests"))
      << answer_said(over);
  EXPECT_FALSE(says(all_said(over), "it is full when that rests")) << all_said(over);
}

TEST(EstimateOfMotion, NoMoreThanTheShoesLengthFlowsAtATime) {
  OpeningPatch place;
  place.width = place.chord = 60 * kMm;
  ShoePath path;
  path.extent = 32 * kMm;
  const Exposure exposure = {0, 0.16, 0.16, 32 * kMm, 32 * kMm};
  const InflowPowder powder{discharge_of({}), 3000, 0};
  EXPECT_NEAR(portions_of(place, exposure, path, powder).width, 32 * kMm, 1e-12);
  place.width = place.chord = 20 * kMm;
  EXPECT_NEAR(portions_of(place, exposure, path, powder).width, 20 * kMm, 1e-12);
}

TEST(EstimateOfMotion, FlowBeginsWhereASlotAlongTheMotionFills) {
  const Estimate found =
      estimated("small_dies/pair.toml", {{"velocity = \"0.2 m/s\"", "velocity = \"1.1 m/s\""},
                                         {"acceleration = \"10 m/s^2\"", "acceleration = \"1000 m/s^2\""}});
  const OpeningEstimate& along = found.openings.at(0);
  EXPECT_GT(found.path.speed / std::sqrt(9.81 * along.effective_width), 5);
  EXPECT_GT(along.mass.back(), 0.01 * along.full_mass);
  EXPECT_LT(along.too_fast, 0.5);
  EXPECT_LT(along.froude, 5);
}

}  // namespace
}  // namespace diefill::process::estimate
