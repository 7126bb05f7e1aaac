// Space-filling points, optimiser and Gaussian process against functions that are known.
#include "process/calibration/methods/emulator.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "process/calibration/methods/minimise.h"
#include "process/calibration/methods/space_filling.h"
#include "tests/process/calibration/normal.h"

namespace diefill::process::calibration {
namespace {

double smooth(double a, double b) {
  return 3 + 2 * a - b + std::sin(3 * a) * std::exp(-b);
}

Eigen::MatrixXd outputs_of(const Eigen::MatrixXd& inputs) {
  Eigen::MatrixXd outputs(inputs.rows(), 2);
  for (Eigen::Index k = 0; k < inputs.rows(); ++k) {
    outputs(k, 0) = smooth(inputs(k, 0), inputs(k, 1));
    outputs(k, 1) = 100 * std::cos(inputs(k, 0) * inputs(k, 1));
  }
  return outputs;
}

TEST(SpaceFilling, EveryPartOfTheCubeGetsItsShareOfPoints) {
  for (const std::uint64_t seed : {1U, 2U, 9U}) {
    const Eigen::MatrixXd points = space_filling(64, 3, seed);
    EXPECT_GE(points.minCoeff(), 0);
    EXPECT_LT(points.maxCoeff(), 1);
    for (Eigen::Index d = 0; d < 3; ++d) {
      Eigen::Array<int, 8, 1> count = Eigen::Array<int, 8, 1>::Zero();
      for (Eigen::Index k = 0; k < 64; ++k) ++count[static_cast<Eigen::Index>(8 * points(k, d))];
      EXPECT_GE(count.minCoeff(), 6) << "seed " << seed << ", axis " << d;
      EXPECT_LE(count.maxCoeff(), 10) << "seed " << seed << ", axis " << d;
    }
  }
}

TEST(SpaceFilling, IsTheSameForASeedAndGoesOnWhereAShorterSetEnds) {
  const Eigen::MatrixXd few = space_filling(5, 4, 3), many = space_filling(20, 4, 3);
  EXPECT_EQ(few, many.topRows(5));
  EXPECT_NE(few, space_filling(5, 4, 4));
  EXPECT_THROW(space_filling(5, 0, 1), std::invalid_argument);
}

TEST(Minimise, FindsTheLowerOfTwoValleys) {
  const auto two_valleys = [](const Eigen::VectorXd& x) {
    const double near = std::pow(x[0] - 0.15, 2) + std::pow(x[1] - 0.2, 2),
                 far = std::pow(x[0] - 0.8, 2) + std::pow(x[1] - 0.7, 2);
    return -std::exp(-20 * near) - 1.5 * std::exp(-60 * far);
  };
  const auto best = minimum_in_box(two_valleys, Eigen::Vector2d::Zero(), Eigen::Vector2d::Ones());
  EXPECT_NEAR(best.at[0], 0.8, 2e-3);
  EXPECT_NEAR(best.at[1], 0.7, 2e-3);
}

TEST(Minimise, StaysInTheBoxAndPassesExceptionsOn) {
  const auto best = minimum_in_box([](const Eigen::VectorXd& x) { return x[0]; },
                                   Eigen::VectorXd::Constant(1, 2), Eigen::VectorXd::Constant(1, 5));
  EXPECT_NEAR(best.at[0], 2, 1e-3);
  EXPECT_GE(best.at[0], 2);
  const auto failing = [](const Eigen::VectorXd&) -> double { throw std::logic_error("no value"); };
  EXPECT_THROW(minimum_in_box(failing, Eigen::Vector2d::Zero(), Eigen::Vector2d::Ones()), std::logic_error);
  const auto hole = [](const Eigen::VectorXd& x) { return x[0] < 0.5 ? std::nan("") : x[0]; };
  EXPECT_NEAR(minimum_in_box(hole, Eigen::VectorXd::Zero(1), Eigen::VectorXd::Ones(1)).at[0], 0.5, 1e-2);
}

TEST(Emulator, GoesThroughRunsWithoutScatterAndPredictsBetweenThem) {
  const Eigen::MatrixXd inputs = space_filling(20, 2, 1);
  const Emulator emulator(inputs, outputs_of(inputs));
  for (Eigen::Index k = 0; k < inputs.rows(); ++k) {
    const auto there = emulator.at(inputs.row(k).transpose());
    EXPECT_NEAR(there.mean[0], smooth(inputs(k, 0), inputs(k, 1)), 1e-3);
    EXPECT_LT(there.factor * emulator.covariance()(0, 0), 1e-4);
  }
  const Eigen::MatrixXd elsewhere = space_filling(50, 2, 5);
  double squares = 0;
  for (Eigen::Index k = 0; k < elsewhere.rows(); ++k)
    squares += std::pow(
        emulator.at(elsewhere.row(k).transpose()).mean[0] - smooth(elsewhere(k, 0), elsewhere(k, 1)), 2);
  EXPECT_LT(std::sqrt(squares / 50), 0.03);
}

TEST(Emulator, AStraightLineIsContinuedBeyondItsRuns) {
  Eigen::MatrixXd inputs(6, 1), outputs(6, 1);
  inputs << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6;
  outputs = (5 - 4 * inputs.array()).matrix();
  const Emulator emulator(inputs, outputs);
  EXPECT_NEAR(emulator.at(Eigen::VectorXd::Constant(1, 0.9)).mean[0], 1.4, 0.02);
}

TEST(Emulator, RepeatsTellTheScatterOverSeeds) {
  Normal normal(4);
  constexpr double kScatter = 0.2;
  double ratio = 0;
  constexpr int kTrials = 10;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Eigen::MatrixXd places = space_filling(15, 2, static_cast<std::uint64_t>(trial));
    Eigen::MatrixXd inputs(30, 2), outputs(30, 1);
    for (Eigen::Index k = 0; k < 30; ++k) {
      inputs.row(k) = places.row(k / 2);
      outputs(k, 0) = smooth(inputs(k, 0), inputs(k, 1)) + kScatter * normal();
    }
    ratio += Emulator(inputs, outputs).scatter()[0] / kScatter / kTrials;
  }
  EXPECT_NEAR(ratio, 1, 0.15);
}

/// Errors of predictions over their stated standard deviations, from many emulators of runs that scatter.
std::vector<double> errors_over_stated(Eigen::Index places, Eigen::Index repeats) {
  Normal normal(8);
  std::vector<double> errors;
  for (std::uint64_t trial = 0; trial < 20; ++trial) {
    const Eigen::MatrixXd inputs =
        space_filling(static_cast<std::size_t>(places), 2, trial).replicate(repeats, 1);
    Eigen::MatrixXd outputs = outputs_of(inputs).leftCols(1);
    for (double& value : outputs.reshaped()) value += 0.05 * normal();
    const Emulator emulator(inputs, outputs);
    const Eigen::MatrixXd elsewhere = space_filling(20, 2, trial + 100);
    for (Eigen::Index k = 0; k < elsewhere.rows(); ++k) {
      const auto there = emulator.at(elsewhere.row(k).transpose());
      errors.push_back((there.mean[0] - smooth(elsewhere(k, 0), elsewhere(k, 1))) /
                       std::sqrt(there.factor * emulator.covariance()(0, 0)));
    }
  }
  return errors;
}

TEST(Emulator, StatedUncertaintyIsWhatPredictionsMissBy) {
  for (const Eigen::Index repeats : {1, 2}) {
    const auto errors = errors_over_stated(14, repeats);
    double squares = 0, inside = 0;
    for (const double error : errors) {
      squares += error * error;
      inside += std::abs(error) < 1.645 ? 1 : 0;
    }
    const double count = static_cast<double>(errors.size());
    EXPECT_NEAR(inside / count, 0.9, 0.07) << repeats << " runs at each place";
    EXPECT_LT(std::sqrt(squares / count), 1.4) << repeats << " runs at each place";
  }
}

/// Places of a line, each with two seeds.
struct Repeated {
  Eigen::MatrixXd inputs, outputs;
  double variance = 0, noise = 0;  ///< of the emulator's process

  /// `value` at `places` places, with the scatter of a run over seeds.
  template <class Value>
  Repeated(Eigen::Index places, double scatter, const Value& value)
      : inputs(2 * places, 1), outputs(2 * places, 1) {
    Normal normal(3);
    for (Eigen::Index k = 0; k < inputs.rows(); ++k) {
      inputs(k, 0) = static_cast<double>(k / 2) / static_cast<double>(places - 1);
      outputs(k, 0) = value(k / 2) + scatter * normal();
    }
  }
  void take_process_of(const Emulator& emulator) {
    noise = emulator.scatter_ratio() * std::pow(std::max(1.0, emulator.left_out_error()), 2);
    variance = std::pow(emulator.scatter()[0], 2) / noise;
  }
};

double matern(double distance) {
  const double root = std::sqrt(5.0) * distance;
  return (1 + root + root * root / 3) * std::exp(-root);
}

/// Error of predicting the mean of two runs from all others, over its standard deviation: the process is
/// fitted anew to the others, with a constant and a slope.
double refitted_without(Eigen::Index first, const Repeated& runs, double length) {
  const Eigen::Index all = runs.inputs.rows();
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < all; ++k)
    if (k != first && k != first + 1) kept.push_back(k);
  Eigen::MatrixXd covariance(all, all), trend(all, 2);
  for (Eigen::Index i = 0; i < all; ++i) {
    trend.row(i) << 1, runs.inputs(i, 0);
    for (Eigen::Index j = 0; j < all; ++j)
      covariance(i, j) = matern(std::abs(runs.inputs(i, 0) - runs.inputs(j, 0)) / length);
  }
  covariance.diagonal().array() += runs.noise;
  const Eigen::MatrixXd inverse = covariance(kept, kept).inverse(),
                        of_trend = trend(kept, Eigen::all).transpose() * inverse;
  const Eigen::Matrix2d normal = (of_trend * trend(kept, Eigen::all)).inverse();
  const Eigen::VectorXd coefficients = normal * of_trend * runs.outputs(kept, 0),
                        near = covariance(kept, first),
                        rest = runs.outputs(kept, 0) - trend(kept, Eigen::all) * coefficients,
                        missing = trend.row(first).transpose() - of_trend * near;
  const double mean = trend.row(first).dot(coefficients) + near.dot(inverse * rest);
  const double variance =
      1 + 0.5 * runs.noise - near.dot(inverse * near) + missing.dot(normal * missing);  // of two runs' mean
  return (0.5 * (runs.outputs(first, 0) + runs.outputs(first + 1, 0)) - mean) /
         std::sqrt(runs.variance * variance);
}

TEST(Emulator, LeavesOutAllRunsOfAPlaceTogether) {
  // Faster than the shortest correlation length: from its neighbours each place is predicted wrongly.
  Repeated runs(25, 0.02, [](Eigen::Index place) { return place % 2 == 0 ? 1.0 : -1.0; });
  const Emulator emulator(runs.inputs, runs.outputs);
  runs.take_process_of(emulator);
  double squares = 0;
  for (Eigen::Index first = 0; first < runs.inputs.rows(); first += 2)
    squares += std::pow(refitted_without(first, runs, emulator.lengths()[0]), 2);
  const double refitted = std::sqrt(squares / 25);
  EXPECT_NEAR(emulator.left_out_error(), refitted, 1e-10 * refitted);
  EXPECT_GT(emulator.left_out_error(), 1.5);
  EXPECT_NEAR(emulator.covariance()(0, 0), runs.variance * refitted * refitted,
              1e-9 * emulator.covariance()(0, 0));
}

TEST(Emulator, RepeatsAreNoPlacesToSpareForSlopes) {
  // Six runs at three places: a constant and what varies about it.
  const Repeated runs(3, 0.01, [](Eigen::Index place) { return 5.0 - 4.0 * static_cast<double>(place); });
  const Emulator emulator(runs.inputs, runs.outputs);
  EXPECT_EQ(emulator.freedom(), 2);
  const double far = emulator.at(Eigen::VectorXd::Constant(1, 100)).mean[0];
  EXPECT_GT(far, runs.outputs.minCoeff());
  EXPECT_LT(far, runs.outputs.maxCoeff());
}

TEST(Emulator, WidensNoLessForFewerDegreesOfFreedom) {
  for (double freedom = 0; freedom < 20; ++freedom)
    EXPECT_GE(student_variance(freedom), student_variance(freedom + 1)) << freedom;
  EXPECT_EQ(student_variance(1), 3);
  EXPECT_NEAR(student_variance(12), 1.2, 1e-15);
}

TEST(Emulator, QuantitiesThatRiseTogetherAreUncertainTogether) {
  const Eigen::MatrixXd inputs = space_filling(12, 2, 2);
  Eigen::MatrixXd outputs(12, 2);
  outputs.col(0) = outputs_of(inputs).col(0);
  outputs.col(1) = 10 * outputs.col(0);
  const Eigen::MatrixXd c = Emulator(inputs, outputs).covariance();
  EXPECT_NEAR(c(0, 1) / std::sqrt(c(0, 0) * c(1, 1)), 1, 1e-6);
  EXPECT_NEAR(c(1, 1) / c(0, 0), 100, 1e-3);
}

TEST(Emulator, AQuantityThatDoesNotVaryStaysAsItIs) {
  const Eigen::MatrixXd inputs = space_filling(8, 2, 2);
  const Emulator emulator(inputs, Eigen::MatrixXd::Constant(8, 1, 7.5));
  EXPECT_NEAR(emulator.at(Eigen::Vector2d(0.3, 0.9)).mean[0], 7.5, 1e-9);
  EXPECT_NEAR(emulator.scatter()[0], 0, 1e-6);
}

TEST(Emulator, TooFewRunsAndMissingValuesAreRefused) {
  const Eigen::MatrixXd two = space_filling(2, 2, 1);
  EXPECT_THROW(Emulator(two, Eigen::MatrixXd::Ones(2, 1)), std::invalid_argument);
  const Eigen::MatrixXd five = space_filling(5, 2, 1);
  Eigen::MatrixXd hole = Eigen::MatrixXd::Ones(5, 1);
  hole(2, 0) = std::nan("");
  EXPECT_THROW(Emulator(five, hole), std::invalid_argument);
  EXPECT_THROW(Emulator(five, Eigen::MatrixXd::Ones(4, 1)), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::process::calibration
