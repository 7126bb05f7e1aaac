// Discharge formulas against the tables of the source, kinematic models against exact solutions.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "process/continuum/discharge.h"
#include "process/continuum/kinematic_model.h"

namespace diefill::process::continuum {
namespace {

constexpr double kMm = 1e-3;

/// m_B / (rho_a b) in mm^2.
double area(const TransientCoefficients& numbers, double width, double shoe, double speed) {
  return mass_of_passage(numbers, {1, width * kMm, 1}, shoe * kMm, speed) / (kMm * kMm);
}

struct Row {
  double speed, area;
};

TEST(Discharge, OfAMovingShoeIsTheMeasuredCurve) {
  for (const Row& row : {Row{0.10, 202.6}, {0.15, 95.5}, {0.18, 69.4}, {0.30, 32.2}, {0.80, 16.4}})
    EXPECT_NEAR(area(kMeasuredDischarge, 6, 32, row.speed), row.area, 0.06) << row.speed;
  for (const Row& row : {Row{0.10, 548.9}, {0.20, 150.3}, {0.40, 51.6}, {0.80, 29.7}})
    EXPECT_NEAR(area(kMeasuredDischarge, 10, 32, row.speed), row.area, 0.06) << row.speed;
}

TEST(Discharge, OfAMovingShoeIsTheSimulatedCurve) {
  for (const Row& row : {Row{0.10, 333.4}, {0.20, 133.5}, {0.40, 49.9}, {0.80, 18.1}})
    EXPECT_NEAR(area(kSimulatedDischarge, 6, 32, row.speed), row.area, 0.06) << row.speed;
  for (const Row& row : {Row{0.20, 868.2}, {0.40, 337.9}})
    EXPECT_NEAR(area(kSimulatedDischarge, 15, 45, row.speed), row.area, 0.06) << row.speed;
}

TEST(Discharge, MassIsTheIntegralOfTheRateAndTheBurst) {
  const SlitFlow slit{3000, 6 * kMm, 10 * kMm};
  const double begin = burst_time(slit), end = 0.2;
  const int steps = 2000;
  double mass = kMeasuredDischarge.burst * slit.density * slit.length * slit.width * slit.width;
  for (int k = 0; k < steps; ++k)
    mass += rate(kMeasuredDischarge, slit, begin + (k + 0.5) * (end - begin) / steps) * (end - begin) / steps;
  EXPECT_NEAR(discharged_mass(kMeasuredDischarge, slit, end), mass, 1e-6 * mass);
}

TEST(Discharge, OfAShoeIsWhatRunsOutWhileItPassesTimesItsLengthOverTheSlits) {
  const SlitFlow slit{3000, 6 * kMm, 10 * kMm};
  const double speed = 0.2, shoe = 32 * kMm;
  EXPECT_NEAR(mass_of_passage(kMeasuredDischarge, slit, shoe, speed),
              shoe / slit.width * discharged_mass(kMeasuredDischarge, slit, slit.width / speed), 1e-12);
}

TEST(Discharge, RefusesShoesTooFastForTheFormula) {
  const SlitFlow slit{3000, 6 * kMm, 10 * kMm};
  EXPECT_THROW(mass_of_passage(kMeasuredDischarge, slit, 0.03, 1.01 * largest_valid_speed(slit)),
               std::invalid_argument);
  EXPECT_NO_THROW(mass_of_passage(kMeasuredDischarge, slit, 0.03, 0.99 * largest_valid_speed(slit)));
  EXPECT_THROW(mass_of_passage(kMeasuredDischarge, slit, 0.03, 0), std::invalid_argument);
}

TEST(Discharge, CoarseGrainsNarrowTheOpening) {
  EXPECT_DOUBLE_EQ(effective_width(6 * kMm, 1 * kMm), 4.6 * kMm);
  EXPECT_EQ(effective_width(1 * kMm, 1 * kMm), 0);
}

/// Vertical velocity above a slit of uniform outflow between two walls (kinematic model with constant B):
/// mirrored slits, each spread by the error function.
double above_slit(double x, double z, double b, double slit, double width, double speed) {
  double sum = 0;
  for (int m = -20; m <= 20; ++m) {
    const double root = std::sqrt(4 * b * z);
    sum += std::erf((x - m * width + slit / 2) / root) - std::erf((x - m * width - slit / 2) / root);
  }
  return speed / 2 * sum;
}

HopperFlow hopper(int refinement) {
  const HopperGrid grid{45 * kMm, 60 * kMm, 180 * refinement, 240 * refinement};
  std::vector<double> opening;
  for (int c = 0; c < grid.columns; ++c) opening.push_back(std::abs(grid.x(c)) < 7.5 * kMm ? -0.4 : 0);
  return solve_kinematic(grid, opening, constant_length(1.8 * kMm));
}

TEST(KinematicModel, IsTheExactSolutionAboveASlit) {
  const HopperFlow flow = hopper(1);
  for (const double z : {7.5, 15.0, 30.0, 45.0, 60.0}) {
    const int row = static_cast<int>(std::lround(z * kMm / flow.grid.spacing_z()));
    const int middle = flow.grid.columns / 2;
    const double exact = above_slit(flow.grid.x(middle), z * kMm, 1.8 * kMm, 15 * kMm, 45 * kMm, -0.4);
    EXPECT_NEAR(flow.vertical_at(middle, row), exact, 1e-4) << z;
  }
}

TEST(KinematicModel, CarriesTheSameFluxThroughEveryRow) {
  const HopperFlow flow = hopper(1);
  const auto flux = [&](int row) {
    double sum = 0;
    for (int c = 0; c < flow.grid.columns; ++c) sum += flow.vertical_at(c, row);
    return sum;
  };
  for (const int row : {1, 17, 240}) EXPECT_NEAR(flux(row), flux(0), 1e-12 * std::abs(flux(0)));
}

TEST(KinematicModel, MovesPowderTowardsTheSlitAndNotThroughTheWalls) {
  const HopperFlow flow = hopper(1);
  const int columns = flow.grid.columns;
  EXPECT_LT(flow.horizontal_at(columns * 2 / 3, 30), 0);
  EXPECT_GT(flow.horizontal_at(columns / 3, 30), 0);
  EXPECT_EQ(flow.horizontal_at(0, 30), 0);
  EXPECT_EQ(flow.horizontal_at(columns, 30), 0);
}

/// Largest error of the model against v n = -(1 + cos(k x) exp(-k^2 integral of B dz)): a solid fraction that
/// grows with height makes the momentum n v diffuse as velocities do where it is constant.
double smooth_error(int columns) {
  const HopperGrid grid{20 * kMm, 30 * kMm, columns, columns};
  const double wave = 2 * std::numbers::pi / grid.width;
  const auto fraction_at = [&](double z) { return 0.2 + 3 * z; };
  const auto length = [](double fraction) { return 1 * kMm + 5 * kMm * fraction; };
  const auto spread = [&](double z) { return 1 * kMm * z + 5 * kMm * (0.2 * z + 1.5 * z * z); };
  const auto exact = [&](double x, double z) {
    return -(1 + std::cos(wave * x) * std::exp(-wave * wave * spread(z))) / fraction_at(z);
  };
  std::vector<double> opening, fraction;
  for (int c = 0; c < columns; ++c) opening.push_back(exact(grid.x(c), 0));
  for (int k = 0; k <= columns; ++k)
    for (int c = 0; c < columns; ++c) fraction.push_back(fraction_at(k * grid.spacing_z()));
  const HopperFlow flow = solve_kinematic(grid, opening, length, fraction);
  double error = 0;
  for (int k = 0; k <= columns; ++k)
    for (int c = 0; c < columns; ++c)
      error = std::max(error, std::abs(flow.vertical_at(c, k) - exact(grid.x(c), k * grid.spacing_z())));
  return error;
}

TEST(KinematicModel, OfCompressiblePowderConvergesToTheExactSolutionInSecondOrder) {
  const double coarse = smooth_error(80), middle = smooth_error(160), fine = smooth_error(320);
  EXPECT_NEAR(std::log2(coarse / middle), 2, 0.2);
  EXPECT_NEAR(std::log2(middle / fine), 2, 0.2);
}

TEST(KinematicModel, DiffusionLengthHasThePublishedValues) {
  const LengthOfFraction length;
  for (const auto& [fraction, expected] : {std::pair{0.25, 0.398},
                                           {0.30, 0.773},
                                           {0.32, 1.241},
                                           {0.34, 3.150},
                                           {0.347, 6.825},
                                           {0.35, 4.550},
                                           {0.36, 2.155},
                                           {0.365, 1.706}})
    EXPECT_NEAR(length(fraction) / kMm, expected, 6e-4) << fraction;
}

TEST(KinematicModel, AFittedDiffusionLengthRisesUpToTheDensestPoint) {
  const LengthOfFraction planted{1e-4, 0.6, 0.55};
  std::vector<LengthPoint> points;
  for (const double fraction : {0.40, 0.45, 0.50, 0.55}) points.push_back({fraction, planted(fraction), 1});
  const LengthOfFraction fitted = fit_length(points);
  EXPECT_EQ(fitted.peak, 0.55);
  // B = B_0 / (1 - 0.55 / 0.6) = 12 B_0; n_div is searched in steps of 3.5 % of its excess over 0.55.
  EXPECT_NEAR(fitted(0.55) / fitted.smallest, 12, 0.5);
  EXPECT_NEAR(fitted(0.55), planted(0.55), 0.01 * planted(0.55));
  EXPECT_LT(fitted(0.56), fitted(0.55));
}

TEST(KinematicModel, RefusesFractionsAtWhichTheDiffusionLengthHasNoValue) {
  EXPECT_THROW(LengthOfFraction{}(-0.1), std::domain_error);
  EXPECT_THROW((LengthOfFraction{1e-4, 0.3, 0.35}(0.32)), std::domain_error);
  const HopperGrid grid{0.02, 0.02, 4, 1};
  EXPECT_THROW(solve_kinematic(grid, {0, -1, -1, 0}, LengthOfFraction{}, {1, 1, 0, 1, 1, 1, 1, 1}),
               std::invalid_argument);
  EXPECT_THROW(solve_kinematic(grid, {0, -1}, constant_length(1e-3)), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::process::continuum
