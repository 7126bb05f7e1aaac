// Likelihood, region, search and what they tell, on functions in place of simulations.
#include "process/calibration/methods/region.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "process/calibration/methods/insight.h"
#include "process/calibration/methods/likelihood.h"
#include "process/calibration/methods/next_points.h"
#include "process/calibration/methods/space_filling.h"
#include "tests/process/calibration/normal.h"

namespace diefill::process::calibration {
namespace {

/// log-likelihood of a normal distribution.
LogLikelihood normal_around(const Eigen::Vector2d& mean, const Eigen::Matrix2d& covariance) {
  const Eigen::Matrix2d inverse = covariance.inverse();
  return [=](const Eigen::VectorXd& at) {
    const Eigen::Vector2d off = at - mean;
    return -0.5 * off.dot(inverse * off);
  };
}

Eigen::Matrix2d narrow_valley() {
  Eigen::Matrix2d covariance;
  covariance << 0.01, -0.0095, -0.0095, 0.01;
  return covariance;
}

TEST(Region, OfANormalLikelihoodHasItsMeanCovarianceAndEdge) {
  const Eigen::Vector2d mean(0.5, 0.45);
  const auto log = normal_around(mean, narrow_valley());
  const Region region = sample_region(log, 2, 1);
  EXPECT_NEAR(region.best[0], 0.5, 1e-3);
  EXPECT_NEAR(region.best[1], 0.45, 1e-3);
  EXPECT_NEAR(region.mean[0], 0.5, 0.02);
  EXPECT_NEAR(region.covariance(0, 0), 0.01, 0.002);
  EXPECT_NEAR(region.correlation(0, 1), -0.95, 0.02);
  // 90 % of a normal distribution in two dimensions lie where chi^2 < 4.605.
  EXPECT_NEAR(region.threshold, -0.5 * 4.605, 0.25);
  EXPECT_NEAR(region.upper[0] - region.lower[0], 2 * 1.645 * 0.1, 0.03);
  EXPECT_TRUE(region.contains(log(mean)));
  EXPECT_FALSE(region.contains(log(Eigen::Vector2d(0.6, 0.6))));
}

TEST(Region, IsTheSameForTheSameSeedAndStaysInTheBox) {
  const auto flat = [](const Eigen::VectorXd&) { return 0.0; };
  const Region a = sample_region(flat, 3, 5), b = sample_region(flat, 3, 5);
  EXPECT_EQ(a.samples, b.samples);
  EXPECT_GE(a.samples.minCoeff(), 0);
  EXPECT_LE(a.samples.maxCoeff(), 1);
  for (Eigen::Index d = 0; d < 3; ++d) {
    EXPECT_NEAR(a.lower[d], 0.05, 0.04);
    EXPECT_NEAR(a.upper[d], 0.95, 0.04);
  }
}

TEST(Region, EdgePointsLieAtBothEndsOfTheValley) {
  const Region region = sample_region(normal_around({0.5, 0.5}, narrow_valley()), 2, 1);
  const auto edge = edge_of(region, 2);
  ASSERT_EQ(edge.size(), 2U);
  EXPECT_LT((edge[0][0] - 0.5) * (edge[1][0] - 0.5), 0);
  for (const auto& place : edge) {
    EXPECT_GT(std::abs(place[0] - 0.5), 0.12);
    EXPECT_LT(std::abs(place[0] + place[1] - 1), 0.12);  // along the valley
  }
}

TEST(Region, EveryTwentiethSampleStandsForAll) {
  // Twenty walkers: in their order, every twentieth sample would be the slow chain of one.
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Region region = sample_region(normal_around({0.5, 0.5}, narrow_valley()), 2, seed);
    std::vector<double> some;
    for (Eigen::Index k = 0; k < region.samples.rows(); k += 20) some.push_back(region.samples(k, 0));
    double squares = 0, with_next = 0;
    for (std::size_t k = 0; k < some.size(); ++k) {
      squares += std::pow(some[k] - region.mean[0], 2);
      if (k > 0) with_next += (some[k] - region.mean[0]) * (some[k - 1] - region.mean[0]);
    }
    const double variance = squares / static_cast<double>(some.size());
    EXPECT_NEAR(variance / region.covariance(0, 0), 1, 0.3) << "seed " << seed;
    EXPECT_NEAR(with_next / squares, 0, 0.25) << "seed " << seed;
    EXPECT_NEAR(region.log[7], normal_around({0.5, 0.5}, narrow_valley())(region.samples.row(7).transpose()),
                1e-12);
  }
}

TEST(Region, IntervalsHoldTheBestPlaceAtAnEndOfTheRange) {
  const Region region = sample_region([](const Eigen::VectorXd& at) { return -20 * at[0]; }, 1, 1);
  EXPECT_LT(region.best[0], 1e-3);
  EXPECT_LE(region.lower[0], region.best[0]);
  EXPECT_NEAR(region.upper[0], 0.15, 0.03);  // 95 % of an exponential distribution lie below -ln(0.05) / 20
}

TEST(Profiles, HoldOneParameterAndLetTheOthersFollow) {
  const auto log = normal_around({0.5, 0.5}, narrow_valley());
  const auto all = profiles([&](const Eigen::VectorXd& at) { return -2 * log(at); }, 2, 11);
  ASSERT_EQ(all.size(), 2U);
  ASSERT_EQ(all[0].size(), 11U);
  for (const auto& point : all[0]) {
    // The least over the other parameter is that of the marginal distribution.
    EXPECT_NEAR(point.value, std::pow((point.place - 0.5) / 0.1, 2), 0.3 + 0.05 * point.value);
    if (std::abs(point.place - 0.5) < 0.35) {
      EXPECT_NEAR(point.others[1], 0.5 - 0.95 * (point.place - 0.5), 0.02);
    }
  }
  const auto one = profiles([](const Eigen::VectorXd& at) { return at[0]; }, 1, 3);
  EXPECT_EQ(one[0][1].value, 0.5);
}

/// Two quantities of two parameters in place of two measurements.
Eigen::Vector2d simulated(const Eigen::VectorXd& at) {
  return {10 * at[0] + 4 * at[1] + std::sin(2 * at[0]), 5 - 3 * at[0] + 6 * at[1] * at[1]};
}

Eigen::MatrixXd simulated_at(const Eigen::MatrixXd& places, double scatter, Normal& normal) {
  Eigen::MatrixXd outputs(places.rows(), 2);
  for (Eigen::Index k = 0; k < places.rows(); ++k)
    for (Eigen::Index q = 0; q < 2; ++q)
      outputs(k, q) = simulated(places.row(k).transpose())[q] + scatter * normal();
  return outputs;
}

std::vector<MeasuredData> data_for(const Eigen::MatrixXd& places, const Eigen::MatrixXd& outputs,
                                   const Eigen::Vector2d& measured, double deviation, bool both = true) {
  std::vector<MeasuredData> data;
  for (Eigen::Index q = 0; q < (both ? 2 : 1); ++q)
    data.push_back({measured.segment(q, 1), Eigen::VectorXd::Constant(1, deviation),
                    std::make_shared<Emulator>(places, outputs.col(q))});
  return data;
}

TEST(Likelihood, IsThatOfNormalErrorsWithBothVariances) {
  const Eigen::MatrixXd places = space_filling(12, 2, 1);
  Normal normal(1);
  const Eigen::MatrixXd outputs = simulated_at(places, 0, normal);
  const auto emulator = std::make_shared<Emulator>(places, outputs);
  const Eigen::Vector2d measured(7, 6), deviation(0.3, 0.2);
  const Likelihood likelihood({{measured, deviation, emulator}});
  EXPECT_EQ(likelihood.data(), 2U);
  const Eigen::Vector2d at(0.31, 0.62);
  const auto there = emulator->at(at);
  Eigen::Matrix2d covariance = there.factor * emulator->covariance();
  covariance(0, 0) += 0.09;
  covariance(1, 1) += 0.04;
  const Eigen::Vector2d off = there.mean - measured;
  const double chi = off.dot(covariance.inverse() * off);
  EXPECT_NEAR(likelihood.chi_square(at), chi, 1e-9 * chi);
  // Without the constant of the deviations, which no parameter changes.
  EXPECT_NEAR(likelihood.log_at(at), -0.5 * (chi + std::log(covariance.determinant() / (0.09 * 0.04))),
              1e-9 * chi);
  EXPECT_NEAR(likelihood.misfit(at), std::pow(off[0] / 0.3, 2) + std::pow(off[1] / 0.2, 2), 1e-9 * chi);
}

TEST(Likelihood, OfManyQuantitiesOfFewRunsIsThatOfTheirWholeCovariance) {
  constexpr Eigen::Index kQuantities = 300;
  const Eigen::MatrixXd places = space_filling(12, 2, 1);
  Eigen::MatrixXd outputs(places.rows(), kQuantities);
  for (Eigen::Index q = 0; q < kQuantities; ++q)
    outputs.col(q) = (places.col(0) * (1 + 0.01 * static_cast<double>(q))).array().sin() +
                     places.col(1).array() * std::cos(0.1 * static_cast<double>(q));
  const auto emulator = std::make_shared<Emulator>(places, outputs);
  const Eigen::VectorXd measured = outputs.row(3).transpose(),
                        deviation = Eigen::VectorXd::Constant(kQuantities, 0.05);
  const Likelihood likelihood({{measured, deviation, emulator}});
  const Eigen::Vector2d at(0.31, 0.62);
  const auto there = emulator->at(at);
  Eigen::MatrixXd covariance = there.factor * emulator->covariance();
  covariance.diagonal().array() += 0.05 * 0.05;
  const Eigen::VectorXd off = there.mean - measured;
  const double chi = off.dot(covariance.ldlt().solve(off));
  EXPECT_NEAR(likelihood.chi_square(at), chi, 1e-6 * chi);
  EXPECT_NEAR(likelihood.misfit(at), off.squaredNorm() / (0.05 * 0.05), 1e-9 * likelihood.misfit(at));
  EXPECT_NEAR(likelihood.emulator_share(at),
              there.factor * emulator->covariance().trace() / (0.05 * 0.05 * kQuantities), 1e-9);
}

TEST(Likelihood, DeviationsOfZeroAndMissingValuesAreRefused) {
  const Eigen::MatrixXd places = space_filling(6, 2, 1);
  const auto emulator = std::make_shared<Emulator>(places, places);
  EXPECT_THROW(Likelihood({}), std::invalid_argument);
  EXPECT_THROW(Likelihood({{Eigen::Vector2d(1, 2), Eigen::Vector2d(1, 0), emulator}}), std::invalid_argument);
  EXPECT_THROW(Likelihood({{Eigen::VectorXd::Ones(1), Eigen::VectorXd::Ones(1), emulator}}),
               std::invalid_argument);
}

TEST(ExpectedImprovement, IsZeroAtSafePlacesAndThatOfANormalErrorElsewhere) {
  const Eigen::MatrixXd places = space_filling(14, 2, 3);
  Normal normal(2);
  const auto data =
      data_for(places, simulated_at(places, 0, normal), simulated(Eigen::Vector2d(0.4, 0.5)), 0.1);
  const Likelihood likelihood(data);
  const Eigen::VectorXd known = places.row(0).transpose();
  EXPECT_NEAR(expected_improvement(likelihood, known, likelihood.misfit(known)), 0,
              0.01 * likelihood.misfit(known) + 1e-6);
  const Eigen::VectorXd best = Eigen::Vector2d(0.4, 0.5);
  EXPECT_NEAR(expected_improvement(likelihood, best, 50), 50, 5);  // certain to fall by nearly all of it
}

TEST(MisfitScatter, OfQuantitiesThatScatterTogetherIsThatOfTheirSum) {
  constexpr Eigen::Index kQuantities = 9;
  const Eigen::MatrixXd places = space_filling(12, 2, 1).replicate(2, 1);
  Normal normal(3);
  const Eigen::MatrixXd one = simulated_at(places, 0.1, normal).leftCols(1);
  const auto alone = std::make_shared<Emulator>(places, one),
             together = std::make_shared<Emulator>(places, one.replicate(1, kQuantities));
  const Eigen::VectorXd measured = Eigen::VectorXd::Constant(kQuantities, 7),
                        deviation = Eigen::VectorXd::Constant(kQuantities, 0.3);
  const Eigen::Vector2d at(0.31, 0.62);
  const double x = (alone->at(at).mean[0] - 7) / 0.3, s = alone->scatter()[0] / 0.3;
  const double of_one = std::sqrt(4 * x * x * s * s + 2 * std::pow(s, 4));
  const Likelihood single({{measured.head(1), deviation.head(1), alone}});
  EXPECT_NEAR(misfit_scatter(single, at), of_one, 1e-9 * of_one);
  // The misfit of all is nine times that of one, whatever the seed.
  const Likelihood curve({{measured, deviation, together}});
  EXPECT_NEAR(misfit_scatter(curve, at), kQuantities * of_one, 1e-6 * kQuantities * of_one);
  // As many measurements, each with runs of its own, scatter on their own.
  std::vector<MeasuredData> apart(kQuantities, {measured.head(1), deviation.head(1), alone});
  EXPECT_NEAR(misfit_scatter(Likelihood(apart), at), std::sqrt(kQuantities) * of_one, 1e-9 * of_one);
}

/// A search of the planted parameters from `start` runs on; gives the region and the number of places.
struct Found {
  Region region;
  Likelihood likelihood;
  std::size_t places = 0;
  bool stopped = false;
};

Found search(const Eigen::Vector2d& truth, double deviation, double scatter, unsigned seed,
             bool both = true) {
  Normal normal(seed);
  Eigen::Vector2d measured = simulated(truth);
  for (double& value : measured) value += deviation * normal();
  Eigen::MatrixXd places = space_filling(8, 2, seed);
  Eigen::MatrixXd outputs = simulated_at(places, scatter, normal);
  for (;;) {
    Likelihood likelihood(data_for(places, outputs, measured, deviation, both));
    Region region = sample_region([&](const auto& at) { return likelihood.log_at(at); }, 2, seed, 0.9, 2000);
    std::vector<Eigen::VectorXd> taken;
    for (Eigen::Index k = 0; k < places.rows(); ++k) taken.push_back(places.row(k).transpose());
    const NextPoints next = next_points(likelihood, region, taken, 2, seed);
    if (!next.worthwhile() || places.rows() > 40)
      return {region, likelihood, static_cast<std::size_t>(places.rows()), !next.worthwhile()};
    for (const auto& place : next.places) {
      places.conservativeResize(places.rows() + 1, 2);
      outputs.conservativeResize(outputs.rows() + 1, 2);
      places.bottomRows(1) = place.transpose();
      outputs.bottomRows(1) = simulated_at(place.transpose(), scatter, normal);
    }
  }
}

TEST(Search, FindsPlantedParametersAndStopsByItself) {
  const Eigen::Vector2d truth(0.62, 0.35);
  const Found found = search(truth, 0.05, 0.01, 3);
  EXPECT_TRUE(found.stopped);
  EXPECT_LE(found.places, 30U);
  EXPECT_NEAR(found.region.best[0], truth[0], 0.05);
  EXPECT_NEAR(found.region.best[1], truth[1], 0.05);
}

TEST(Search, TheRegionHoldsTheTruthAsOftenAsItSays) {
  constexpr int kTrials = 40;
  Normal normal(77);
  int held = 0;
  for (unsigned trial = 0; trial < kTrials; ++trial) {
    const Eigen::Vector2d truth(0.15 + 0.7 * normal.uniform(), 0.15 + 0.7 * normal.uniform());
    const Found found = search(truth, 0.15, 0.05, trial + 1);
    held += found.region.contains(found.likelihood.log_at(truth)) ? 1 : 0;
  }
  // 90 % of 40 trials are 36; fewer than 31 or all of 40 are rare (2 % each).
  EXPECT_GE(held, 31);
}

TEST(Insight, ParametersThatOneMeasurementFixesOnlyTogetherAreNamed) {
  const Found found = search({0.5, 0.5}, 0.05, 0.01, 4, false);
  EXPECT_LT(found.region.correlation(0, 1), -0.8);
  const auto sentences = insights(found.region, {"friction", "adhesion"}, {"discharge"});
  ASSERT_FALSE(sentences.empty());
  const std::string& last = sentences.back();
  EXPECT_NE(last.find("discharge alone fixes friction and adhesion only along a line"), std::string::npos)
      << last;
  EXPECT_NE(last.find("more of one makes up for less of the other"), std::string::npos) << last;
  const Found both = search({0.5, 0.5}, 0.05, 0.01, 4, true);
  for (const auto& sentence : insights(both.region, {"friction", "adhesion"}, {"discharge", "heap"}))
    EXPECT_EQ(sentence.find("only along a line"), std::string::npos) << sentence;
}

TEST(Insight, AParameterWithoutInfluenceIsSaidToBeOpen) {
  const Region region =
      sample_region([](const Eigen::VectorXd& at) { return -0.5 * std::pow((at[0] - 0.5) / 0.05, 2); }, 2, 1);
  const auto sentences = insights(region, {"friction", "damping"}, {"discharge", "heap"});
  ASSERT_EQ(sentences.size(), 1U);
  EXPECT_NE(sentences[0].find("discharge and heap together say next to nothing about damping"),
            std::string::npos)
      << sentences[0];
  const std::string alone = insights(region, {"friction", "damping"}, {"discharge"}).front();
  EXPECT_NE(alone.find("discharge alone says next to nothing"), std::string::npos) << alone;
}

TEST(Insight, ARangeThatCutsTheRegionOffIsNamed) {
  // Half of each likelihood lies beyond an end; the third parameter ends well within its range.
  const Region region = sample_region(
      [](const Eigen::VectorXd& at) {
        return -0.5 * (std::pow(at[0] / 0.1, 2) + std::pow((at[1] - 1) / 0.2, 2) +
                       std::pow((at[2] - 0.12) / 0.03, 2));
      },
      3, 1);
  const auto sentences = insights(region, {"friction", "adhesion", "damping"}, {"discharge", "heap"});
  ASSERT_EQ(sentences.size(), 2U);
  EXPECT_NE(sentences[0].find("cut off where the range of friction begins"), std::string::npos)
      << sentences[0];
  EXPECT_NE(sentences[1].find("cut off where the range of adhesion ends"), std::string::npos) << sentences[1];
}

TEST(Insight, TheMeasurementAcrossTheValleyIsWorthMost) {
  const Region region = sample_region(normal_around({0.5, 0.5}, narrow_valley()), 2, 1);
  const Eigen::MatrixXd along = region.samples.col(0) - region.samples.col(1),
                        across = region.samples.col(0) + region.samples.col(1);
  const Eigen::VectorXd deviation = Eigen::VectorXd::Constant(1, 0.02);
  const auto worth =
      informativeness_of(region.samples, {{"repeat", across, deviation}, {"heap", along, deviation}});
  ASSERT_EQ(worth.size(), 2U);
  EXPECT_EQ(worth[0].name, "heap");  // it tells apart what the valley leaves open
  // Variance along the valley 2 (0.01 + 0.0095) = 0.039 falls to 0.039 * 0.0004 / 0.0394.
  EXPECT_NEAR(worth[0].volume, std::sqrt(0.0004 / 0.0394), 0.02);
  EXPECT_NEAR(worth[1].volume, std::sqrt(0.0004 / 0.0014), 0.06);
  EXPECT_LT(worth[0].deviations[0], worth[1].deviations[0]);
  EXPECT_THROW(informativeness_of(region.samples, {{"none", Eigen::MatrixXd::Ones(3, 1), deviation}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace diefill::process::calibration
