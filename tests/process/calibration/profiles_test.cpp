// Profiles of an objective over many parameters.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "process/calibration/methods/region.h"

namespace diefill::process::calibration {
namespace {

TEST(Profiles, OfManyParametersInANarrowValleyAreLeast) {
  constexpr Eigen::Index kParameters = 6;
  Eigen::MatrixXd steepness = Eigen::MatrixXd::Constant(kParameters, kParameters, 400.0 / 36);
  for (Eigen::Index k = 0; k + 1 < kParameters; ++k) {
    steepness.block<2, 2>(k, k).diagonal().array() += 2500;
    steepness(k, k + 1) -= 2500;
    steepness(k + 1, k) -= 2500;
  }
  const auto objective = [&](const Eigen::VectorXd& at) {
    const Eigen::VectorXd off = at.array() - 0.5;
    return off.dot(steepness * off);
  };
  const auto along = profiles(objective, kParameters, 31).front();
  const double variance = steepness.inverse()(0, 0);
  for (const ProfilePoint& point : along) {
    if (std::abs(point.place - 0.5) > 0.21) continue;
    const double least = std::pow(point.place - 0.5, 2) / variance;
    EXPECT_NEAR(point.value, least, 0.1 * least + 0.05) << point.place;
  }
}

}  // namespace
}  // namespace diefill::process::calibration
