// Laws of discharge fitted to planted measurements.
#include "process/continuum/discharge_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace diefill::process::continuum {
namespace {

constexpr double kMm = 1e-3;
constexpr double kSpeeds[] = {0.1, 0.12, 0.15, 0.18, 0.25, 0.4, 0.6, 0.8};

DischargePoint passage(double speed, double width) {
  DischargePoint point;
  point.speed = speed;
  point.width = width;
  point.length = 33 * kMm;
  point.shoe_length = 32 * kMm;
  return point;
}

/// Masses of the published law at eight speeds and two slits.
DischargeData planted(const TransientCoefficients& numbers, double grain = 0) {
  DischargeData data;
  data.density = 3000;
  data.grain_diameter = grain;
  for (const double width : {6 * kMm, 10 * kMm})
    for (const double speed : kSpeeds) {
      DischargePoint point = passage(speed, width);
      point.value = mass_of_passage(numbers, {3000, effective_width(width, grain), point.length},
                                    point.shoe_length, speed);
      data.points.push_back(point);
    }
  return data;
}

double deviation(const DischargeFit& fit, Eigen::Index k) {
  return std::sqrt(fit.fit.covariance(k, k));
}

TEST(DischargeFit, FindsTheNumbersThatWerePlanted) {
  const auto fit = fit_discharge(DischargeLaw::moving_shoe, planted(kSimulatedDischarge));
  EXPECT_NEAR(fit.number("C_B"), kSimulatedDischarge.burst, 1e-5);
  EXPECT_NEAR(fit.number("C_I"), kSimulatedDischarge.initial, 1e-4);
  EXPECT_NEAR(fit.number("C_F"), kSimulatedDischarge.steady, 1e-5);
  EXPECT_NEAR(fit.number("beta"), kSimulatedDischarge.beta, 1e-4);
  EXPECT_LT(fit.relative_scatter, 1e-6);
  EXPECT_NEAR(fit.largest_x, std::sqrt(9.81 * 10 * kMm) / 0.1 - 0.2, 1e-12);
}

TEST(DischargeFit, FindsThemBehindTheEmptyAnnulusOfCoarseGrains) {
  const auto fit = fit_discharge(DischargeLaw::moving_shoe, planted(kSimulatedDischarge, 0.94 * kMm));
  EXPECT_NEAR(fit.number("C_F"), kSimulatedDischarge.steady, 1e-5);
  auto as_drawn = planted(kSimulatedDischarge, 0.94 * kMm);
  as_drawn.grain_diameter = 0;
  EXPECT_GT(
      std::abs(fit_discharge(DischargeLaw::moving_shoe, as_drawn).number("C_F") / kSimulatedDischarge.steady -
               1),
      0.1);
}

TEST(DischargeFit, IsTheSameToTheLastBitForAnyOrderOfThePoints) {
  std::mt19937 random(1);
  for (const DischargeLaw law : {DischargeLaw::moving_shoe, DischargeLaw::power_law,
                                 DischargeLaw::beverloo_slit, DischargeLaw::beverloo_round}) {
    DischargeData data = planted(kSimulatedDischarge);
    for (std::size_t k = 0; k < data.points.size(); ++k) data.points[k].value *= 1 + 0.01 * std::sin(3.0 * k);
    const auto first = fit_discharge(law, data);
    for (int turn = 0; turn < 3; ++turn) {
      std::shuffle(data.points.begin(), data.points.end(), random);
      const auto again = fit_discharge(law, data);
      EXPECT_EQ(again.fit.numbers, first.fit.numbers);
      EXPECT_EQ(again.fit.covariance, first.fit.covariance);
      EXPECT_EQ(again.fit.values, first.fit.values);
      EXPECT_EQ(again.relative_scatter, first.relative_scatter);
    }
  }
}

TEST(DischargeFit, FindsThePowerLaw) {
  DischargeData data = planted(kMeasuredDischarge);
  for (auto& point : data.points)
    point.value =
        mass_of_passage(kMeasuredPowerLaw, {3000, point.width, point.length}, point.shoe_length, point.speed);
  const auto fit = fit_discharge(DischargeLaw::power_law, data);
  EXPECT_NEAR(fit.number("C_S"), 0.25, 1e-6);
  EXPECT_NEAR(fit.number("n"), 0.20, 1e-6);
  EXPECT_NEAR(predicted(fit, data, data.points[3]), data.points[3].value, 1e-9);
}

TEST(DischargeFit, FindsTheOutflowOfASlitThatOpens) {
  DischargeData data;
  data.density = 2000;
  const SlitFlow slit{2000, 15 * kMm, 2.16 * kMm};
  for (int k = 0; k <= 300; ++k) {
    DischargePoint point;
    point.time = k * kMm;
    point.width = slit.width;
    point.length = slit.length;
    point.value = discharged_mass(kSimulatedDischarge, slit, point.time);
    data.points.push_back(point);
  }
  const auto fit = fit_discharge(DischargeLaw::transient, data);
  EXPECT_NEAR(fit.number("C_B"), kSimulatedDischarge.burst, 1e-5);
  EXPECT_NEAR(fit.number("C_I"), kSimulatedDischarge.initial, 1e-4);
  EXPECT_NEAR(fit.number("C_F"), kSimulatedDischarge.steady, 1e-5);
  EXPECT_NEAR(fit.number("beta"), kSimulatedDischarge.beta, 1e-4);
  EXPECT_EQ(fit.left_out, 8U);  // 0 to 7 ms: the burst takes 7.8 ms
}

TEST(DischargeFit, RefusesWhatIsNoFlow) {
  DischargeData data = planted(kSimulatedDischarge);
  for (auto& point : data.points) point.value = 0.01 * point.speed;  // more mass at higher speeds
  EXPECT_THROW(fit_discharge(DischargeLaw::moving_shoe, data), std::invalid_argument);
  EXPECT_THROW(fit_discharge(DischargeLaw::power_law, data), std::invalid_argument);
  EXPECT_THROW(fit_discharge(DischargeLaw::moving_shoe, planted(kSimulatedDischarge, 5 * kMm)),
               std::invalid_argument);  // grains that do not pass
}

DischargeData orifices(double coefficient, double k, double grain, bool round) {
  DischargeData data;
  data.density = 3000;
  data.grain_diameter = grain;
  for (const double width : {4.0, 6.0, 8.0, 10.0, 14.0}) {
    DischargePoint point;
    point.width = width * kMm;
    point.length = 33 * kMm;
    const double effective = point.width - k * grain;
    point.value = coefficient * 3000 * std::sqrt(9.81) *
                  (round ? std::pow(effective, 2.5) : point.length * std::pow(effective, 1.5));
    data.points.push_back(point);
  }
  return data;
}

TEST(DischargeFit, FindsBeverloosNumbersOfHolesAndSlits) {
  for (const bool round : {true, false}) {
    const auto law = round ? DischargeLaw::beverloo_round : DischargeLaw::beverloo_slit;
    const auto fit = fit_discharge(law, orifices(0.58, 1.7, 0.3 * kMm, round));
    EXPECT_NEAR(fit.number("C"), 0.58, 1e-5);
    EXPECT_NEAR(fit.number("k"), 1.7, 1e-4);
    const auto fine = fit_discharge(law, orifices(0.58, 1.4, 0, round));
    EXPECT_NEAR(fine.number("C"), 0.58, 1e-9);
    EXPECT_THROW(fine.number("k"), std::out_of_range);  // not to be had without the grains' size
  }
}

TEST(DischargeFit, ItsDeviationsAreThoseOfRepeatedMeasurements) {
  constexpr int kRepeats = 300;
  constexpr double kScatter = 0.03;
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  int within = 0;
  double claimed = 0, square = 0;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    DischargeData data = planted(kMeasuredDischarge);
    for (auto& point : data.points) {
      point.value = mass_of_passage(kMeasuredPowerLaw, {3000, point.width, point.length}, point.shoe_length,
                                    point.speed) *
                    (1 + kScatter * normal(random));
      point.error = kScatter * point.value;
    }
    const auto fit = fit_discharge(DischargeLaw::power_law, data);
    const double off = fit.number("n") - kMeasuredPowerLaw.exponent;
    claimed += deviation(fit, 1) / kRepeats;
    square += off * off / kRepeats;
    within += std::abs(off) < deviation(fit, 1) ? 1 : 0;
  }
  // One standard deviation holds in 68 % of all cases; errors are widened where chi^2 asks for it.
  EXPECT_NEAR(static_cast<double>(within) / kRepeats, 0.71, 0.08);
  EXPECT_NEAR(claimed / std::sqrt(square), 1.07, 0.12);
}

TEST(DischargeFit, APointWithALargeErrorCountsLittle) {
  DischargeData data = planted(kMeasuredDischarge);
  for (auto& point : data.points) {
    point.value =
        mass_of_passage(kMeasuredPowerLaw, {3000, point.width, point.length}, point.shoe_length, point.speed);
    point.error = 0.01 * point.value;
  }
  data.points[2].value *= 1.5;
  data.points[2].error = data.points[2].value;
  EXPECT_NEAR(fit_discharge(DischargeLaw::power_law, data).number("n"), 0.20, 1e-3);
  data.points[2].error = 0.01 * data.points[2].value;
  EXPECT_GT(std::abs(fit_discharge(DischargeLaw::power_law, data).number("n") - 0.20), 1e-2);
}

TEST(DischargeFit, NamesTheColumnThatDoesNotChange) {
  const auto said = [](DischargeLaw law, const DischargeData& data) -> std::string {
    try {
      fit_discharge(law, data);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "none";
  };
  const auto expect = [](const std::string& found, const std::string& part) {
    EXPECT_NE(found.find(part), std::string::npos) << found;
  };
  DischargeData data = planted(kSimulatedDischarge);
  for (auto& point : data.points) point.value = 0.01;
  expect(said(DischargeLaw::moving_shoe, data), "column mass: all points have 10 g");
  for (auto& point : data.points) point = data.points.front();
  expect(said(DischargeLaw::power_law, data), "column speed: all points have the same speed");
  DischargeData outflow;
  outflow.density = 3000;
  for (int k = 0; k < 10; ++k) {
    DischargePoint point = passage(0, 6 * kMm);
    point.time = 0.1 + 0.05 * k;
    outflow.points.push_back(point);
  }
  expect(said(DischargeLaw::transient, outflow), "column mass: all points have 0 g");
  for (auto& point : outflow.points) point.value = 1e-3 * (1 - point.time);
  expect(said(DischargeLaw::transient, outflow), "no point has more than the first in time");
}

TEST(DischargeFit, RefusesPointsThatDoNotDetermineIt) {
  DischargeData data = planted(kSimulatedDischarge);
  data.points.resize(4);
  EXPECT_THROW(fit_discharge(DischargeLaw::moving_shoe, data), std::invalid_argument);
  data = planted(kSimulatedDischarge);
  const DischargePoint first = data.points.front();
  for (auto& point : data.points) point = first;  // one speed only
  EXPECT_THROW(fit_discharge(DischargeLaw::power_law, data), std::invalid_argument);
  for (auto& point : data.points) point.speed = 10;  // beyond 5 sqrt(gD)
  EXPECT_THROW(fit_discharge(DischargeLaw::moving_shoe, data), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::process::continuum
