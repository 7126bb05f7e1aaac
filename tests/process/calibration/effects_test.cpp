// Effects and regression on responses whose coefficients are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "process/calibration/methods/effect_regression.h"
#include "process/calibration/methods/screening_effects.h"
#include "tests/process/calibration/normal.h"

namespace diefill::process::calibration {
namespace {

FractionalDesign kottlan_design() {
  return design_of(5, {"ABC", "ABD", "BCDE"});
}

std::vector<FactorRange> kottlan_ranges() {
  return {{10, 100}, {2, 20}, {0.5, 1.2}, {10, 50}, {0.02, 0.2}, {5, 50}, {0.03, 0.3}, {0.03, 0.3}};
}

/// Coefficients in units of the levels: y = mean + sum main x_i + sum of pairs x_i x_j.
struct Planted {
  double mean = 0;
  std::vector<double> main;
  std::vector<std::pair<FactorPair, double>> pairs;

  double at(const FractionalDesign& design, std::size_t run) const {
    double y = mean;
    for (std::size_t k = 0; k < main.size(); ++k) y += main[k] * level(design, run, k);
    for (const auto& [pair, beta] : pairs)
      y += beta * level(design, run, pair.first) * level(design, run, pair.second);
    return y;
  }
};

/// A pair for each of the strings that hold pairs alone.
Planted planted(const FractionalDesign& design, unsigned seed) {
  Normal normal(seed);
  Planted truth;
  truth.mean = 20 + normal();
  for (std::size_t k = 0; k < design.factors(); ++k) truth.main.push_back(normal());
  for (const auto& string : alias_strings(design))
    if (string.factors.empty()) truth.pairs.push_back({string.pairs.front(), 0.3 * normal()});
  return truth;
}

std::vector<double> responses(const Planted& truth, const FractionalDesign& design) {
  std::vector<double> y;
  for (std::size_t run = 0; run < design.runs(); ++run) y.push_back(truth.at(design, run));
  return y;
}

TEST(EffectRegression, PlantedMainAndPairEffectsAreExactToRoundOff) {
  const auto design = kottlan_design();
  const auto ranges = kottlan_ranges();
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Planted truth = planted(design, seed);
    ASSERT_EQ(truth.main.size() + truth.pairs.size(), 28U);  // 8 main effects and 20 strings of pairs
    const auto y = responses(truth, design);
    std::vector<FactorPair> pairs;
    for (const auto& [pair, beta] : truth.pairs) pairs.push_back(pair);
    const EffectModel model = fit_effects(design, ranges, y, pairs);
    EXPECT_NEAR(model.mean, truth.mean, 1e-13 * 20);
    for (std::size_t k = 0; k < 8; ++k)
      EXPECT_NEAR(0.5 * model.coefficient[k] * (ranges[k].high - ranges[k].low), truth.main[k], 1e-13);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto& [i, j] = pairs[k];
      const double scale = 0.25 * (ranges[i].high - ranges[i].low) * (ranges[j].high - ranges[j].low);
      EXPECT_NEAR(model.pairs[k].coefficient * scale, truth.pairs[k].second, 1e-13);
    }
    const auto settings = settings_of(design, ranges);
    EXPECT_LT(prediction_error(model, settings, y), 1e-11);
  }
}

TEST(EffectRegression, AFactorOfTwoBeforeThePairsWouldMissTheData) {
  const auto design = kottlan_design();
  const auto ranges = kottlan_ranges();
  const Planted truth = planted(design, 3);
  const auto y = responses(truth, design);
  EffectModel model = fit_effects(design, ranges, y, pairs_to_fit(design, y));
  for (auto& term : model.pairs) term.coefficient *= 2;
  EXPECT_GT(prediction_error(model, settings_of(design, ranges), y), 0.1);
}

TEST(EffectRegression, InteractionsLowerThePredictionErrorByWhatTheyAre) {
  const auto design = design_of(2, {});
  const std::vector<FactorRange> ranges = {{0, 2}, {0, 4}};
  // y = 10 + x1 + 2 x2 + 0.5 x1 x2 in levels; without the last term every run is off by 0.5.
  const std::vector<double> y = {13.5, 8.5, 10.5, 7.5};
  const EffectModel model = fit_effects(design, ranges, y, {{0, 1}});
  const auto settings = settings_of(design, ranges);
  EXPECT_NEAR(prediction_error(model, settings, y), 0, 1e-12);
  EXPECT_NEAR(prediction_error(model, settings, y, false),
              100 * 0.5 * (1 / 13.5 + 1 / 8.5 + 1 / 10.5 + 1 / 7.5) / 4, 1e-12);
  EXPECT_NEAR(predicted(model, {1, 2}), 10, 1e-12);      // the centre
  EXPECT_NEAR(predicted(model, {1.5, 2}), 10.5, 1e-12);  // half a level up
}

TEST(EffectRegression, HasNoRelativeErrorWhereTheResponseIsZeroOrChangesItsSign) {
  const auto design = design_of(2, {});
  const std::vector<FactorRange> ranges = {{-1, 1}, {-1, 1}};
  const auto error = [&](const std::vector<double>& y) {
    return prediction_error(fit_effects(design, ranges, y, {}), settings_of(design, ranges), y);
  };
  EXPECT_TRUE(std::isnan(error({3, 2, 1, 0})));
  EXPECT_TRUE(std::isnan(error({3, -2, 1, 1})));
  EXPECT_TRUE(std::isnan(error({0, 0, 0, 0})));
  EXPECT_NEAR(error({-5, -3, -4, -2.4}), error({5, 3, 4, 2.4}), 1e-12);
  EXPECT_GT(error({5, 3, 4, 2.4}), 0);
}

TEST(EffectRegression, AnAliasStringGoesToThePairOfLargerMainEffects) {
  const auto design = kottlan_design();
  Planted truth;
  truth.main = {0.1, 0.1, 3, 0.1, 0, 2, 0.1, 0};  // C and F are large: AB = CF = DG is theirs
  const auto pairs = pairs_to_fit(design, responses(truth, design));
  EXPECT_EQ(pairs.size(), 20U);
  EXPECT_NE(std::find(pairs.begin(), pairs.end(), FactorPair(2, 5)), pairs.end());
  EXPECT_EQ(std::find(pairs.begin(), pairs.end(), FactorPair(0, 1)), pairs.end());
}

TEST(EffectRegression, RangesWithoutWidthAndMissingRunsAreRefused) {
  const auto design = design_of(2, {});
  EXPECT_THROW(fit_effects(design, {{0, 1}, {2, 2}}, {1, 2, 3, 4}, {}), std::invalid_argument);
  EXPECT_THROW(fit_effects(design, {{0, 1}, {0, 2}}, {1, 2, 3}, {}), std::invalid_argument);
}

TEST(ScreeningEffects, AreDifferencesOfMeansAndSumsOverAString) {
  const auto design = kottlan_design();
  Planted truth;
  truth.mean = 5;
  truth.main = {1, 0, -2, 0, 0, 0, 0, 0.5};
  truth.pairs = {{{0, 1}, 0.25}, {{2, 5}, 0.5}};  // AB and CF stand in one string
  std::vector<std::vector<double>> y;
  for (const double value : responses(truth, design)) y.push_back({value});
  const auto screening = screening_effects(design, y);
  EXPECT_NEAR(screening.mean, 5, 1e-13);
  for (const auto& effect : screening.effects) {
    const std::string name = text_of(effect.string);
    const double wanted = name == "A"              ? 2
                          : name == "C"            ? -4
                          : name == "H"            ? 1
                          : name == "AB = CF = DG" ? 1.5
                                                   : 0;
    EXPECT_NEAR(effect.value, wanted, 1e-13) << name;
  }
}

TEST(ScreeningEffects, StandardErrorsFromRepeatsAreThoseOfADifferenceOfMeans) {
  const auto design = design_of(3, {});
  Normal normal(11);
  constexpr double kScatter = 0.7;
  constexpr int kTrials = 400, kRepeats = 3;
  double squares = 0, variance = 0, outside = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<std::vector<double>> y(design.runs());
    for (std::size_t run = 0; run < design.runs(); ++run)
      for (int k = 0; k < kRepeats; ++k) y[run].push_back(3.0 * level(design, run, 0) + kScatter * normal());
    const auto screening = screening_effects(design, y);
    ASSERT_EQ(screening.source, ErrorSource::repeats);
    squares += std::pow(screening.effects[1].value, 2);  // nothing acts there
    variance += screening.error * screening.error;
    outside += std::abs(screening.effects[1].value) > screening.margin ? 1 : 0;
  }
  const double exact = 4 * kScatter * kScatter / (8.0 * kRepeats);
  EXPECT_NEAR(squares / kTrials, exact, 0.2 * exact);
  EXPECT_NEAR(variance / kTrials, exact, 0.05 * exact);
  EXPECT_NEAR(outside / kTrials, 0.05, 0.025);
}

TEST(ScreeningEffects, WithoutRepeatsLenthsErrorFindsTheFewEffectsThatAct) {
  const auto design = compact_design(8, 4);
  Normal normal(5);
  std::vector<std::vector<double>> y;
  for (std::size_t run = 0; run < design.runs(); ++run)
    y.push_back({2.0 * level(design, run, 1) - 1.5 * level(design, run, 4) + 0.1 * normal()});
  const auto screening = screening_effects(design, y);
  ASSERT_EQ(screening.source, ErrorSource::lenth);
  for (const auto& effect : screening.effects) {
    const std::string name = text_of(effect.string);
    EXPECT_EQ(std::abs(effect.value) > screening.margin, name == "B" || name == "E") << name;
  }
}

TEST(ScreeningEffects, WithoutRepeatsEffectsThatAreMostlyZeroTellNoError) {
  const auto design = compact_design(8, 4);
  const auto effects = [&](double friction) {
    std::vector<std::vector<double>> y;
    for (std::size_t run = 0; run < design.runs(); ++run)
      y.push_back({1 / 3.0 + friction * level(design, run, 0)});
    return screening_effects(design, y);
  };
  for (const double friction : {0.0, 0.1}) {  // what rounding leaves of the others is no scatter
    const auto screening = effects(friction);
    EXPECT_EQ(screening.source, ErrorSource::zeros);
    EXPECT_TRUE(std::isnan(screening.error));
    EXPECT_TRUE(std::isnan(screening.margin));
  }
}

TEST(ScreeningEffects, FourRunsWithoutRepeatsHaveNoErrorAndMissingRunsAreRefused) {
  const auto design = design_of(2, {});
  const auto screening = screening_effects(design, {{1}, {2}, {3}, {4}});
  EXPECT_EQ(screening.source, ErrorSource::none);
  EXPECT_TRUE(std::isnan(screening.error));
  EXPECT_THROW(screening_effects(design, {{1}, {2}, {3}}), std::invalid_argument);
  EXPECT_THROW(screening_effects(design, {{1}, {2}, {3}, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::process::calibration
