// Deviations of a fitted outflow against those of repeated outflows.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "process/continuum/cumulated_mass.h"
#include "process/continuum/discharge_fit.h"

namespace diefill::process::continuum {
namespace {

constexpr double kMm = 1e-3;
constexpr double kGrain = 7.7e-8;  // kg, of 0.47 mm
const SlitFlow kSlit = {2000, 15 * kMm, 2.16 * kMm};

/// Mass over 0.3 s, grain by grain at random, every `step` s.
DischargeData random_outflow(std::mt19937& random, double step) {
  DischargeData data;
  data.density = kSlit.density;
  double mass = 0, expected = 0;
  for (int k = 0; k * step <= 0.3; ++k) {
    DischargePoint point;
    point.time = k * step;
    point.width = kSlit.width;
    point.length = kSlit.length;
    const double next = discharged_mass(kSimulatedDischarge, kSlit, point.time);
    if (next > expected) mass += kGrain * std::poisson_distribution<int>((next - expected) / kGrain)(random);
    expected = next;
    point.value = mass;
    data.points.push_back(point);
  }
  return data;
}

/// Share of repeated outflows whose interval of 95 % holds the planted number, of each.
Eigen::Vector4d coverage(double step) {
  constexpr int kRepeats = 200;
  constexpr double kInterval = 1.96;
  const Eigen::Vector4d planted(kSimulatedDischarge.burst, kSimulatedDischarge.initial,
                                kSimulatedDischarge.steady, kSimulatedDischarge.beta);
  std::mt19937 random(11);
  Eigen::Vector4d within = Eigen::Vector4d::Zero();
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    const auto fit = fit_discharge(DischargeLaw::transient, random_outflow(random, step));
    for (Eigen::Index k = 0; k < 4; ++k)
      within[k] +=
          std::abs(fit.fit.numbers[k] - planted[k]) < kInterval * std::sqrt(fit.fit.covariance(k, k));
  }
  return within / kRepeats;
}

TEST(TransientFit, ItsDeviationsAreThoseOfRepeatedOutflows) {
  for (const double step : {1 * kMm, 15 * kMm}) {
    const Eigen::Vector4d within = coverage(step);
    for (Eigen::Index k = 0; k < 4; ++k) {
      EXPECT_GE(within[k], 0.85) << "number " << k << " every " << step << " s";
      EXPECT_LE(within[k], 0.99) << "number " << k << " every " << step << " s";
    }
  }
}

// Two outflows, of 100 and 50 g, whose increments are off by 1, -1, 1 and -1 g.
TEST(CumulatedMass, VariesAsTheSumOfItsIncrements) {
  const std::vector<Outflow> outflows = {{0, 1}, {2, 3}};
  const Eigen::Vector4d fitted(40, 100, 30, 50), measured(41, 100, 31, 50);
  const double per_mass = variance_per_mass(outflows, measured, fitted, 2);
  EXPECT_NEAR(per_mass, 4.0 / 150 * 4 / 2, 1e-12);
  const Eigen::MatrixXd covariance =
      covariance_of_sums(Eigen::MatrixXd::Identity(4, 4), outflows, fitted, 0.5);
  Eigen::Matrix4d expected;
  expected << 20, 20, 0, 0, 20, 50, 0, 0, 0, 0, 15, 15, 0, 0, 15, 25;
  EXPECT_LT((covariance - expected).norm(), 1e-12) << covariance;
}

TEST(TransientFit, AnotherOutflowOfTheSlitHalvesTheVariance) {
  std::mt19937 random(3);
  DischargeData one = random_outflow(random, 5 * kMm), two = one;
  two.points.insert(two.points.end(), one.points.begin(), one.points.end());
  const auto of_one = fit_discharge(DischargeLaw::transient, one),
             of_two = fit_discharge(DischargeLaw::transient, two);
  EXPECT_NEAR(of_two.number("C_F"), of_one.number("C_F"), 1e-6);
  // N / (N - 4) with 59 points and with 118.
  const double freedom = (118.0 / 114) / (59.0 / 55);
  EXPECT_NEAR(of_two.fit.covariance(2, 2) / of_one.fit.covariance(2, 2), 0.5 * freedom, 1e-3);
}

}  // namespace
}  // namespace diefill::process::continuum
