// When an estimate gives an answer, and why there is none.
#include <gtest/gtest.h>

#include "process/estimate/statements/limits.h"
#include "process/estimate/trapped_air.h"
#include "tests/process/estimate/estimate_scene.h"

namespace diefill::process::estimate {
namespace {

constexpr double kMm = 1e-3;
constexpr const char* kSquare = "small_dies/square.toml";
const std::pair<std::string, std::string> kSlow = {"velocity = \"0.2 m/s\"", "velocity = \"0.02 m/s\""};

void expect_open(const Estimate& found, const std::string& because) {
  EXPECT_EQ(found.answer, Answer::open);
  ASSERT_FALSE(found.open_because.empty());
  EXPECT_TRUE(says(found.open_because.front(), because)) << found.open_because.front();
  EXPECT_TRUE(says(answer_said(found), because)) << answer_said(found);
  EXPECT_FALSE(says(answer_said(found), "No simulation is needed")) << answer_said(found);
  EXPECT_EQ(in_short(found).size(), 1U);
}

TEST(EstimateAnswer, WithinTheRangeNeedsNoSimulation) {
  const Estimate found = estimated(kSquare, {kSlow});
  EXPECT_EQ(found.answer, Answer::fills) << answer_said(found);
  EXPECT_TRUE(found.open_because.empty());
  EXPECT_TRUE(says(answer_said(found), "with grains of 2.35 mm fills every cavity")) << answer_said(found);
}

TEST(EstimateAnswer, SaysHowManyTimesThePowderWouldFillTheCavityInPlainNumbers) {
  const std::string said = answer_said(estimated(kSquare, {{"passages = 1", "passages = 1000"}}));
  EXPECT_TRUE(says(said, "times what the cavity holds would run in")) << said;
  EXPECT_FALSE(says(said, "e+")) << said;
}

TEST(EstimateAnswer, OfGrainsBeyondTheRangeIsOpen) {
  expect_open(estimated("circular_cavity/fill.toml"),
              "grains of 1.88 mm are 0.48 of the width of the cavity");
}

/// To estimate with a law of one's own.
EstimateOptions with_fit(const continuum::TransientCoefficients& numbers) {
  EstimateOptions options;
  options.law.emplace();
  options.law->numbers = numbers;
  options.law->longest = 9;
  options.law->source = "fit fit.json";
  return options;
}

// A rate of 2e-10 of what powders have, as of masses in a wrong unit.
TEST(EstimateAnswer, OfAFitThatIsInDoubtIsOpen) {
  EstimateOptions options = with_fit({2e-10, 2e-10, 2e-10, 1});
  EXPECT_EQ(estimated(kSquare, {}, options).answer, Answer::too_fast);
  options.law->doubts = {"C_F = 2e-10 is outside the range known for powders"};
  const Estimate found = estimated(kSquare, {}, options);
  expect_open(found, "fit fit.json says: C_F = 2e-10 is outside the range known for powders");
}

TEST(EstimateAnswer, BeyondTheTimesOfAFitWithoutASteadyRateIsOpen) {
  EstimateOptions options = with_fit(continuum::kSimulatedDischarge);
  options.law->holds_beyond_longest = false;
  const Estimate within = estimated(kSquare, {kSlow}, options);
  const double longest = within.openings.at(0).longest_x;
  options.law->longest = 1.01 * longest;
  EXPECT_NE(estimated(kSquare, {kSlow}, options).answer, Answer::open);
  options.law->longest = 0.5 * longest;
  expect_open(estimated(kSquare, {kSlow}, options), "and fit fit.json does not show how it flows after");
  options.law->holds_beyond_longest = true;
  EXPECT_NE(estimated(kSquare, {kSlow}, options).answer, Answer::open);
}

TEST(EstimateAnswer, OfPowderThatIsTooShallowIsOpen) {
  expect_open(estimated(kSquare, {{"fill_height = \"12 mm\"", "fill_height = \"8 mm\""}}),
              "powder is 8 mm deep in the shoe, at least 12 mm");
}

TEST(EstimateAnswer, OfAShoeBeyondTheRangeIsOpen) {
  expect_open(
      estimated("small_dies/slot.toml", {{"velocity = \"0.2 m/s\"", "velocity = \"4 m/s\""},
                                         {"acceleration = \"10 m/s^2\"", "acceleration = \"10000 m/s^2\""}}),
      "sqrt(g D) over the cavity, at most 5");
}

TEST(EstimateAnswer, OfACavityThatNarrowsBelowIsOpen) {
  const std::pair<std::string, std::string> fine = {"grain_diameter = \"0.94 mm\"",
                                                    "grain_diameter = \"1.88 mm\""};
  expect_open(estimated("stepped_ring/fill.toml", {fine}), "to which the cavity narrows, at most 0.43");
  Estimate found = estimated("stepped_ring/fill.toml", {fine});
  OpeningEstimate& cavity = found.openings.at(0);
  cavity.narrowest = 0.9 * (cavity.width - cavity.effective_width);
  EXPECT_TRUE(says(too_coarse(found, cavity), "which narrows to")) << too_coarse(found, cavity);
}

TEST(EstimateAnswer, WhereAirSlowsTheFillingIsOpen) {
  EstimateOptions fine;
  fine.particle_diameter = 2e-5;
  const Estimate found = estimated(kSquare, {kSlow}, fine);
  EXPECT_GT(found.openings.at(0).air_ratio, kAirSlows);
  expect_open(found, "air slows the filling");
}

/// Two places of one cavity, 10 mm deep, over which powder stands at the given times.
Estimate with_exposures(const Exposure& one, const Exposure& other, std::optional<double> opens = {}) {
  OpeningLayout layout;
  layout.places.resize(2);
  ShoePath path;
  path.crossings = 1;
  path.exposures = {{one}, {other}};
  for (OpeningPatch& place : layout.places) {
    place.area = 1e-5;
    place.opens = opens;
  }
  Estimate found;
  found.openings.resize(1);
  found.openings[0].area = 2e-5;
  found.openings[0].depth = 10 * kMm;
  find_trapped_air(layout, path, 0, 0.1, found.openings[0]);
  return found;
}

TEST(TrappedAir, IsThatOfTheTimeInWhichPowderCoversTheWholeCavity) {
  const auto both = with_exposures({0, 0.2, 0.2, 0, 0}, {0, 0.2, 0.2, 0, 0}).openings.at(0);
  EXPECT_NEAR(both.air_trapped, 1, 1e-12);
  EXPECT_NEAR(both.air_ratio, 0.1 / 0.2, 1e-12);
  const auto half = with_exposures({0, 0.2, 0.2, 0, 0}, {0.1, 0.2, 0.2, 0, 0}).openings.at(0);
  EXPECT_NEAR(half.air_trapped, 0.5, 1e-12);
  EXPECT_NEAR(half.air_ratio, 0.5 * both.air_ratio, 1e-12);
}

TEST(TrappedAir, IsNoneInACavityLongerThanTheShoeOrFilledByAPunchAtFirst) {
  EXPECT_FALSE(with_exposures({0, 0.2, 0.2, 0, 0}, {0.3, 0.2, 0.2, 0, 0}).openings.at(0).air_escapes);
  EXPECT_FALSE(with_exposures({0, 0.2, 0.2, 0, 0}, {0, 0.2, 0.2, 0, 0}, 0.0).openings.at(0).air_escapes);
  EXPECT_FALSE(estimated("narrow_ring/strategies/volumetric.toml").openings.at(0).air_escapes);
}

TEST(EstimateAnswer, OfAShoeWithTooLittlePowderIsOpenAndEarlierCrossingsStayAsTheyAre) {
  const std::pair<std::string, std::string> six = {"passages = 1", "passages = 6"};
  const std::pair<std::string, std::string> little = {"fill_height = \"12 mm\"", "fill_height = \"1.5 mm\""};
  const Estimate enough = estimated(kSquare, {six}), powder_limited = estimated(kSquare, {six, little});
  ASSERT_LT(enough.openings.at(0).mass.front(), powder_limited.powder.in_shoe);
  ASSERT_GT(enough.openings[0].mass.back(), powder_limited.powder.in_shoe);
  EXPECT_TRUE(powder_limited.powder_limited);
  EXPECT_NEAR(powder_limited.openings.at(0).mass.front(), enough.openings[0].mass.front(), 1e-12);
  EXPECT_NEAR(powder_limited.openings[0].mass.back(), powder_limited.powder.in_shoe, 1e-9);
  expect_open(powder_limited, "the shoe holds less powder than the openings take");
  const Estimate refilled = estimated(kSquare, {six, little, {"[numerics]", R"([[step]]
kind = "inflow"
from = ["11 mm", "-6 mm", "5 mm"]
to = ["35 mm", "6 mm", "24 mm"]
mass = "20 g"

[numerics])"}});
  EXPECT_NEAR(refilled.powder.let_in, 0.02, 1e-12);
  EXPECT_FALSE(refilled.powder_limited);
}

TEST(EstimateAnswer, CountsWhatStepsLetIntoAHalfModelOnce) {
  const std::string feed = R"([[step]]
kind = "inflow"
from = ["11 mm", "-6 mm", "5 mm"]
to = ["35 mm", "6 mm", "24 mm"]
mass = "20 g"

[numerics])";
  const Estimate whole = estimated(kSquare, {{"[numerics]", feed}});
  const Estimate half = estimated(kSquare, {{"[numerics]", "[economy]\nmirror = \"y\"\n\n" + feed}});
  EXPECT_NEAR(whole.powder.let_in, 0.02, 1e-12);
  EXPECT_NEAR(half.powder.let_in, 0.02, 1e-12);
  EXPECT_NEAR(half.powder.in_shoe, whole.powder.in_shoe, 1e-9 * whole.powder.in_shoe);
}

TEST(EstimateAnswer, CountsNoMoreThanAStepLetsInUntilItIsStopped) {
  const auto let_in = [](const std::string& delay) {
    return estimated(kSquare, {{"[numerics]", R"([[step]]
name = "feed"
kind = "inflow"
from = ["11 mm", "-6 mm", "5 mm"]
to = ["35 mm", "6 mm", "24 mm"]
mass = "20 g"
rate = "10 g/s"
until = { with = "feed", delay = ")" + delay + "\" }\n\n[numerics]"}})
        .powder.let_in;
  };
  EXPECT_NEAR(let_in("0.5 s"), 0.005, 1e-9);
  EXPECT_NEAR(let_in("3 s"), 0.02, 1e-9);
}

TEST(EstimateAnswer, TellsOfTheGrainsAndOfThePowdersOwnParticles) {
  const Estimate found = estimated(kSquare);
  const OpeningEstimate& cavity = found.openings.at(0);
  ASSERT_TRUE(cavity.real_particle_share && cavity.real_particle_speed_once && cavity.speed_once);
  EXPECT_GT(*cavity.real_particle_share, cavity.share);
  EXPECT_GT(*cavity.real_particle_speed_once, *cavity.speed_once);
  EXPECT_TRUE(says(all_said(found), "for one crossing with grains of 2.35 mm"));
  EXPECT_TRUE(says(all_said(found), "particles of the powder's own size, 0.1 mm"));
}

TEST(EstimateAnswer, SaysWhichCavityAndWhere) {
  const Estimate found = estimated("small_dies/pair.toml");
  EXPECT_EQ(found.openings.at(1).name, "cavity 2");
  EXPECT_TRUE(says(answer_said(found), "cavity 2 at x = -9 mm, y = 0 mm")) << answer_said(found);
  EXPECT_TRUE(says(in_short(found).at(1), "cavity 2 at x = -9 mm, y = 0 mm does not fill"));
  EXPECT_TRUE(says(all_said(found), "filling: cavity 1 at x = 6 mm, y = 0 mm: "));
}

TEST(EstimateAnswer, SaysWhichCavityIsNotSeenFromAbove) {
  const Scene scene = sample("small_dies/pair.toml", {kSlow});
  Tooling tooling = read_tooling(scene);
  geometry::Cavity hidden = tooling.other_cavities.at(0);
  hidden.box.lower.head<2>() += Eigen::Vector2d(0, 100 * kMm);
  hidden.box.upper.head<2>() += Eigen::Vector2d(0, 100 * kMm);
  hidden.axis_origin.y() += 100 * kMm;
  tooling.other_cavities.push_back(hidden);
  const Estimate found = estimate(scene, tooling);
  ASSERT_EQ(found.unseen.size(), 1U);
  EXPECT_TRUE(says(all_said(found), "cavity 3 at x = -9 mm, y = 100 mm was not seen from above"))
      << all_said(found);
  EXPECT_EQ(found.openings.size(), 2U);
  EXPECT_NE(found.answer, Answer::fills);
}

TEST(EstimateAnswer, OfASlitIsTheMassThatRunsThrough) {
  const Estimate found = estimated("slit_plate/discharge_6mm.toml");
  const std::string said = answer_said(found);
  EXPECT_TRUE(says(said, "run through the slit in one crossing at 0.18 m/s")) << said;
  EXPECT_TRUE(says(said, "with the uncertainty")) << said;
}

}  // namespace
}  // namespace diefill::process::estimate
