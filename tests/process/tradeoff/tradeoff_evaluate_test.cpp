// Errors, floors, Pareto front and recommendation against points worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "process/tradeoff/evaluate.h"
#include "process/tradeoff/quantities.h"
#include "process/tradeoff/trade_off.h"

namespace diefill::process {
namespace {

using results::Tradeoff;
using results::TradeoffPoint;
using results::TradeoffValue;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TradeoffPoint point(const std::string& name, double cost, const std::vector<double>& means,
                    double scatter = kNone, std::uint64_t seeds = 1) {
  TradeoffPoint made;
  made.name = name;
  if (name != "base") made.changes = {{"parameter", name}};
  made.state = "finished";
  made.seeds = seeds;
  made.core_seconds = cost;
  for (const double mean : means) made.values.push_back({mean, scatter, seeds, kNone});
  return made;
}

Tradeoff with_quantities(const std::vector<TradeoffPoint>& points) {
  Tradeoff tradeoff;
  tradeoff.quantities.resize(2);
  tradeoff.quantities[0].key = tradeoff.quantities[0].name = "mass";
  tradeoff.quantities[1].key = tradeoff.quantities[1].name = "spread";
  tradeoff.quantities[1].scale = "mass";
  tradeoff.points = points;
  return tradeoff;
}

TEST(Targets, OfQuantitiesWithoutAValueAreRemarkedOn) {
  const auto tradeoff = with_quantities({point("base", 1, {2, kNone}), point("fine", 2, {3, kNone})});
  EXPECT_TRUE(remarks_on_targets(tradeoff, {{"mass", 2.5}}).empty());
  const auto said = remarks_on_targets(tradeoff, {{"mass", 2.5}, {"spread", 0.1}});
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("--target spread: no run has a value"), std::string::npos) << said[0];
}

TEST(ParetoFront, HoldsWhatNothingBeats) {
  //                              0   1   2     3  4  5   6
  const std::vector<double> cost = {8, 4, 4, 2, 1, 16, kNone};
  const std::vector<double> error = {1, 2, 3, 2, 9, 1, 0};
  EXPECT_EQ(pareto_front(cost, error), (std::vector<std::size_t>{4, 3, 0}));
  EXPECT_EQ(pareto_front({1, 1}, {2, 2}), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(pareto_front({}, {}).empty());
}

TEST(ErrorFloor, PoolsTheScatterOverSettings) {
  // Two seeds each: one degree of freedom a setting. sqrt((0.3^2 + 0.1^2) / 2) / 10.
  const std::vector<TradeoffValue> values = {{10, 0.3, 2, 0}, {11, 0.1, 2, 0}, {12, kNone, 1, 0}};
  const PooledScatter pooled = pooled_scatter(values, 10);
  EXPECT_NEAR(pooled.scatter, std::sqrt(0.05) / 10, 1e-15);
  EXPECT_EQ(pooled.freedom, 2);
  // t_{0.975, 2} = 4.302653; means of two seeds differ by sqrt(2 / 2) times the scatter.
  EXPECT_NEAR(error_floor(pooled, 2, 2), 4.302653 * std::sqrt(0.05) / 10, 1e-8);
  EXPECT_NEAR(error_floor(pooled, 2, std::nullopt), 4.302653 * std::sqrt(0.05) / 10 / std::sqrt(2), 1e-8);
  EXPECT_TRUE(std::isnan(error_floor(pooled_scatter({{10, kNone, 1, 0}}, 10), 1, 1)));
}

TEST(Reference, IsTheCostliestSettingThatIsOnlyFiner) {
  const std::vector<TradeoffPoint> points = {point("base", 10, {1, 1}), point("coarse", 50, {1, 1}),
                                             point("fine", 30, {1, 1}), point("finer", 90, {1, 1}, kNone, 0),
                                             point("unknown", 70, {1, 1})};
  EXPECT_EQ(reference_setting(points, {0, -1, 1, 1, 0}), 2U);  // "finer" has no result
  EXPECT_EQ(reference_setting({point("base", 10, {1, 1})}, {0}), 0U);
  EXPECT_EQ(reference_setting({point("base", 10, {1, 1}, kNone, 0)}, {0}), 1U);
}

TEST(Evaluation, ErrorsAreDistancesFromTheReferenceOverTheScale) {
  Tradeoff tradeoff = with_quantities({point("base", 10, {102, 5}), point("fine", 40, {100, 4})});
  evaluate(tradeoff, 1);
  const auto& base = tradeoff.points[0];
  EXPECT_NEAR(base.values[0].error, 0.02, 1e-15);
  EXPECT_NEAR(base.values[1].error, 0.01, 1e-15);  // of the mass, not of itself
  EXPECT_NEAR(base.error, 0.02, 1e-15);
  EXPECT_EQ(base.worst, "mass");
  EXPECT_EQ(tradeoff.points[1].error, 0);
  EXPECT_TRUE(tradeoff.points[1].reference);
  EXPECT_TRUE(std::isnan(tradeoff.floor));
}

TEST(Evaluation, RecommendsTheCheapestWithinTheToleranceOrTheFloor) {
  const std::vector<TradeoffPoint> points = {point("base", 10, {101, 1}), point("quick", 2, {103, 1}),
                                             point("crude", 1, {120, 1}), point("fine", 40, {100, 1}),
                                             point("slow", 50, {100.5, 1})};
  Tradeoff tradeoff = with_quantities(points);
  tradeoff.tolerance = 0.02;
  evaluate(tradeoff, 3);
  EXPECT_TRUE(tradeoff.points[0].recommended);
  EXPECT_EQ(
      tradeoff.advice,
      "Take \"base\": 4.0 times cheaper than \"fine\", error 1.0 % (mass), within the tolerance of 2.0 %.");
  for (const std::size_t on : {0U, 1U, 2U, 3U}) EXPECT_TRUE(tradeoff.points[on].pareto) << on;
  EXPECT_FALSE(tradeoff.points[4].pareto);

  // Scatter 1 over three seeds of five settings: t_{0.975, 10} = 2.228139, floor 2.228139 x 0.01 x sqrt(2 /
  // 3) = 1.8 %.
  for (auto& each : tradeoff.points) {
    each.seeds = 3;
    each.values[0].scatter = 1;
    each.values[0].seeds = 3;
  }
  tradeoff.tolerance = 0;
  evaluate(tradeoff, 3);
  EXPECT_NEAR(tradeoff.floor, 2.228139 * 0.01 * std::sqrt(2.0 / 3), 1e-8);
  EXPECT_TRUE(tradeoff.points[0].recommended);
  EXPECT_NE(tradeoff.advice.find("(mass), within the 1.8 % scatter over seeds"), std::string::npos)
      << tradeoff.advice;

  tradeoff.tolerance = 0.05;
  evaluate(tradeoff, 3);
  EXPECT_TRUE(tradeoff.points[1].recommended);
  EXPECT_FALSE(tradeoff.points[0].recommended);

  tradeoff.points[1].core_seconds = 38;
  tradeoff.points[0].core_seconds = 39;
  tradeoff.points[2].core_seconds = 37;
  evaluate(tradeoff, 3);
  EXPECT_NE(tradeoff.advice.find("Take \"quick\": 5.0 % cheaper than \"fine\""), std::string::npos)
      << tradeoff.advice;
}

TEST(Evaluation, EveryQuantityIsHeldAgainstItsOwnScatter) {
  // Mass scatters by 3 %, spread (over the mass) by a thousandth: 3 % of the mass mean nothing where 3 % of
  // the mass in the spread do.
  Tradeoff tradeoff = with_quantities({point("base", 10, {100, 10}, 3, 2), point("heavy", 4, {103, 10}, 3, 2),
                                       point("uneven", 2, {101, 13}, 3, 2)});
  for (auto& each : tradeoff.points) each.values[1].scatter = 0.1;
  evaluate(tradeoff, 0);
  EXPECT_LT(tradeoff.points[2].error, tradeoff.floor);
  EXPECT_EQ(tradeoff.points[2].beyond, std::vector<std::string>{"spread"});
  EXPECT_FALSE(is_acceptable(tradeoff.points[2]));
  EXPECT_TRUE(is_acceptable(tradeoff.points[1]));
  EXPECT_TRUE(tradeoff.points[1].recommended);
  // Who accepts 5 % gets the cheapest.
  tradeoff.tolerance = 0.05;
  evaluate(tradeoff, 0);
  EXPECT_TRUE(tradeoff.points[2].beyond.empty());
  EXPECT_TRUE(tradeoff.points[2].recommended);
}

TEST(Evaluation, ASettingWithFewerSeedsIsHeldAgainstAWiderFloor) {
  // Scatter 1 % of the mass; 5 and 5 seeds of two settings and one of the third: t_{0.975, 8} = 2.306004.
  Tradeoff tradeoff =
      with_quantities({point("base", 40, {100, 10}, 1, 5), point("sure", 10, {101.8, 10}, 1, 5),
                       point("unsure", 4, {101.8, 10}, kNone, 1)});
  for (auto& each : tradeoff.points) each.values[1].scatter = kNone;
  evaluate(tradeoff, 0);
  EXPECT_NEAR(tradeoff.points[1].values[0].floor, 2.306004 * 0.01 * std::sqrt(0.4), 1e-8);
  EXPECT_NEAR(tradeoff.points[2].values[0].floor, 2.306004 * 0.01 * std::sqrt(1.2), 1e-8);
  EXPECT_NEAR(tradeoff.quantities[0].floor, tradeoff.points[1].values[0].floor, 1e-15);
  EXPECT_FALSE(is_acceptable(tradeoff.points[1]));
  EXPECT_TRUE(is_acceptable(tradeoff.points[2]));
  EXPECT_TRUE(tradeoff.points[2].recommended);
  EXPECT_NE(tradeoff.advice.find("within the 2.5 % scatter over seeds"), std::string::npos)
      << tradeoff.advice;
}

TEST(Evaluation, ASettingWithSeedsTooFewIsNotRecommended) {
  // Scatter 5 %: the floor of five seeds is 7.3 %, that of one 12.6 %, with which nothing is told apart.
  Tradeoff tradeoff = with_quantities({point("base", 40, {100, 10}, 5, 5), point("sure", 10, {101, 10}, 5, 5),
                                       point("unsure", 4, {100, 10}, kNone, 1)});
  for (auto& each : tradeoff.points) each.values[1].scatter = kNone;
  evaluate(tradeoff, 0);
  EXPECT_TRUE(distinguishes_settings(tradeoff));
  EXPECT_FALSE(has_enough_seeds(tradeoff, tradeoff.points[2]));
  EXPECT_TRUE(tradeoff.points[1].recommended);
  tradeoff.tolerance = 0.13;
  evaluate(tradeoff, 0);
  EXPECT_TRUE(tradeoff.points[2].recommended);
}

TEST(Evaluation, TheReferenceItselfIsTakenWhereNothingElseComesNear) {
  Tradeoff tradeoff = with_quantities({point("base", 10, {150, 1}), point("fine", 40, {100, 1})});
  tradeoff.tolerance = 0.02;
  evaluate(tradeoff, 1);
  EXPECT_TRUE(tradeoff.points[1].recommended);
  EXPECT_NE(tradeoff.advice.find("no cheaper setting stays within"), std::string::npos) << tradeoff.advice;
}

TEST(Evaluation, ATargetTakesThePlaceOfTheReferencesValue) {
  Tradeoff tradeoff = with_quantities({point("base", 10, {102, 5}), point("fine", 40, {100, 4})});
  tradeoff.quantities[0].is_target = true;
  tradeoff.quantities[0].reference = 103;
  evaluate(tradeoff, 1);
  EXPECT_NEAR(tradeoff.points[1].values[0].error, 3.0 / 103, 1e-15);
  EXPECT_NEAR(tradeoff.points[0].values[0].error, 1.0 / 103, 1e-15);
}

TEST(Evaluation, ASettingWithoutAValueThatDecidesIsNotJudged) {
  Tradeoff tradeoff = with_quantities({point("base", 10, {kNone, 4}), point("fine", 40, {100, 4})});
  tradeoff.tolerance = 1;
  evaluate(tradeoff, 1);
  EXPECT_TRUE(std::isnan(tradeoff.points[0].error));
  EXPECT_TRUE(tradeoff.points[1].recommended);
  tradeoff.quantities[0].decides = false;
  evaluate(tradeoff, 1);
  EXPECT_EQ(tradeoff.points[0].error, 0);
}

TEST(Evaluation, ASettingWithAFailedRunIsNotRecommended) {
  Tradeoff tradeoff = with_quantities({point("base", 10, {100, 4}), point("quick", 2, {100, 4})});
  tradeoff.points[1].reason = "left the method's valid range";
  evaluate(tradeoff, 0);
  EXPECT_FALSE(tradeoff.points[1].recommended);
  EXPECT_TRUE(tradeoff.points[0].recommended);
}

TEST(Evaluation, ASettingWithAFailedRunIsNotOnTheFrontEither) {
  Tradeoff tradeoff = with_quantities(
      {point("base", 10, {101, 4}), point("quick", 2, {100, 4}), point("fine", 40, {100, 4})});
  evaluate(tradeoff, 2);
  EXPECT_TRUE(tradeoff.points[1].pareto);
  EXPECT_FALSE(tradeoff.points[0].pareto);
  tradeoff.points[1].reason = "energy grew";
  evaluate(tradeoff, 2);
  EXPECT_FALSE(tradeoff.points[1].pareto);
  EXPECT_TRUE(tradeoff.points[0].pareto);
  EXPECT_TRUE(tradeoff.points[2].pareto);
  EXPECT_EQ(tradeoff.points[1].error, 0);  // what its other runs came to is told all the same
}

TEST(Reference, HasNoFailedRunWhereAnotherWillDo) {
  std::vector<TradeoffPoint> points = {point("base", 10, {1, 1}), point("fine", 30, {1, 1}),
                                       point("finer", 90, {1, 1})};
  points[2].reason = "energy grew";
  EXPECT_EQ(reference_setting(points, {0, 1, 1}), 1U);
  points[0].reason = points[1].reason = "energy grew";
  EXPECT_EQ(reference_setting(points, {0, 1, 1}), 2U);
}

TEST(SeedsFor, AreTheFewestWhoseFloorIsNarrowEnough) {
  const PooledScatter pooled{0.09, 3};
  const std::uint64_t seeds = seeds_for(pooled, 3, 0.1, false);
  const auto floor = [&](std::uint64_t n) {
    return error_floor({0.09, 3.0 * static_cast<double>(n - 1)}, n, n);
  };
  EXPECT_LE(floor(seeds), 0.1);
  EXPECT_GT(floor(seeds - 1), 0.1);
  EXPECT_EQ(seeds, 8U);
  EXPECT_LT(seeds_for(pooled, 3, 0.1, true), seeds);
  EXPECT_EQ(seeds_for({kNone, 0}, 3, 0.1, false), 0U);
  EXPECT_EQ(seeds_for({100, 3}, 3, 0.1, false), 0U);
}

TEST(Evaluation, RecommendsNothingWhereSeedsScatterTooMuchAndSaysWhatIsMissing) {
  // Two seeds of three settings, 9 % each: t_{0.975, 3} = 3.182446, floor 28.6 %.
  Tradeoff tradeoff = with_quantities({point("base", 10, {100, 10}, 9, 2), point("quick", 4, {103, 10}, 9, 2),
                                       point("crude", 2, {120, 10}, 9, 2)});
  tradeoff.tolerance = 0.02;
  evaluate(tradeoff, 0);
  EXPECT_NEAR(tradeoff.floor, 3.182446 * 0.09, 1e-7);
  for (const auto& each : tradeoff.points) EXPECT_FALSE(each.recommended) << each.name;
  EXPECT_EQ(
      tradeoff.advice,
      "No setting is recommended: the scatter over seeds is up to 29 % (mass), and settings that "
      "differ by less than 10 % cannot be distinguished; about 8 seeds of each would suffice: --seeds 8.");
  EXPECT_FALSE(distinguishes_settings(tradeoff));
  // Who accepts more than the scatter is told what to take.
  tradeoff.tolerance = 0.3;
  evaluate(tradeoff, 0);
  EXPECT_TRUE(tradeoff.points[2].recommended);
}

TEST(Evaluation, NothingFinishedIsSaid) {
  Tradeoff tradeoff = with_quantities({point("base", kNone, {kNone, kNone}, kNone, 0)});
  evaluate(tradeoff, 1);
  EXPECT_NE(tradeoff.advice.find("No finished run"), std::string::npos);
}

TEST(SteadyRate, IsTheSlopeBetweenAFifthAndFourFifths) {
  EXPECT_NEAR(steady_rate({0, 1, 2, 3, 4, 5, 6}, {0, 0, 2, 4, 6, 8, 8}), 2, 1e-14);
  EXPECT_TRUE(std::isnan(steady_rate({0, 1}, {0, 0})));
  EXPECT_TRUE(std::isnan(steady_rate({}, {})));
}

}  // namespace
}  // namespace diefill::process
