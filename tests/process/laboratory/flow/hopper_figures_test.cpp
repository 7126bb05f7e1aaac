// Figures of the hopper, found in fields that are known.
#include "process/laboratory/flow/hopper_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "process/laboratory/flow/registry.h"
#include "process/scene/powder/powder_presets.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kMm = 1e-3, kSlit = 15 * kMm, kBulk = 0.365;

/// The kinematic model itself, loose below 30 mm.
HopperFields fields(double slit, double speed) {
  HopperFields made;
  made.grid = {45 * kMm, 50 * kMm, 90, 100};
  std::vector<double> opening;
  for (int c = 0; c < made.grid.columns; ++c)
    opening.push_back(std::abs(made.grid.x(c)) < slit / 2 ? -speed : 0);
  const auto flow = continuum::solve_kinematic(made.grid, opening, continuum::constant_length(1.8 * kMm));
  made.vertical = flow.vertical;
  for (int row = 0; row <= made.grid.rows; ++row)
    for (int c = 0; c < made.grid.columns; ++c) {
      made.horizontal.push_back(0.5 * (flow.horizontal_at(c, row) + flow.horizontal_at(c + 1, row)));
      made.fraction.push_back(row * made.grid.spacing_z() < 30.2 * kMm ? 0.9 * kBulk : kBulk);
    }
  made.bulk_fraction = kBulk;
  made.outflow = speed * slit;
  return made;
}

HopperStudy study() {
  HopperStudy all;
  for (int k = 0; k < 5; ++k) {
    HopperSetup setup;
    setup.powder = powder_preset("ASC100.29 initial D");
    all.setups.push_back(setup);
    all.fields.push_back(fields(kSlit, 0.4));
  }
  all.length = {0.116 * kMm, 0.37, 0.347};
  const auto& grid = all.fields[0].grid;
  all.incompressible = {grid, all.fields[0].vertical,
                        std::vector<double>((grid.rows + 1) * (grid.columns + 1))};
  all.compressible = all.incompressible;
  return all;
}

results::ExperimentFigure figure_of(const std::vector<results::ExperimentFigure>& figures,
                                    const std::string& id) {
  const auto found =
      std::find_if(figures.begin(), figures.end(), [&](const auto& figure) { return figure.id == id; });
  return found == figures.end() ? results::ExperimentFigure{id, std::nan(""), ""} : *found;
}

double value_of(const std::vector<results::ExperimentFigure>& figures, const std::string& id) {
  return figure_of(figures, id).value;
}

/// Local lengths of Eq. 5.5 itself at solid fractions up to `densest`.
std::vector<continuum::LengthPoint> lengths(double smallest, double diverging, double densest) {
  std::vector<continuum::LengthPoint> points;
  for (int k = 0; k < 100; ++k) {
    const double fraction = 0.22 + (densest - 0.22) * k / 99;
    points.push_back({fraction, smallest / (1 - fraction / diverging), 1});
  }
  return points;
}

TEST(HopperFigures, AreThoseOfTheFields) {
  const auto figures = hopper_figures(study());
  EXPECT_NEAR(value_of(figures, "D01"), kBulk, 1e-9);
  EXPECT_NEAR(value_of(figures, "D02"), 30, 0.5);
  EXPECT_NEAR(value_of(figures, "D07"), 0.116, 1e-9);
  EXPECT_NEAR(value_of(figures, "D10"), 0.116 / 15, 1e-9);
  EXPECT_NEAR(value_of(figures, "D12"), 0.4 * 15 / 45, 0.005);  // plug flow carries the flux of the slit
  EXPECT_NEAR(value_of(figures, "D13"), 0, 1e-12);
  EXPECT_NEAR(value_of(figures, "D14"), 1, 1e-9);
  EXPECT_NEAR(value_of(figures, "D15"), 0, 1e-9);
}

TEST(HopperFigures, AreThoseThatTheExperimentIsComparedWith) {
  std::vector<std::string> ids;
  for (const auto& figure : hopper_figures(study())) ids.push_back(figure.id);
  EXPECT_EQ(ids, flow_experiments().at(0).published_figures);
}

TEST(HopperFigures, FarSpeedsAreThoseOfThePlugOverTheWholeWidth) {
  HopperStudy all = study();
  // Slit 2/3 as wide: plug flow over sqrt(gD) is 2/3 of that of the others, whatever the axis is like.
  all.setups[1].equivalent_slit = 10 * kMm;
  all.fields[1] = fields(10 * kMm, 0.4 * std::sqrt(10.0 / 15));
  all.fields[4] = fields(10 * kMm, 0.4 * std::sqrt(10.0 / 15));
  all.setups[4].equivalent_slit = 10 * kMm;
  EXPECT_NEAR(value_of(hopper_figures(all), "D14"), 2.0 / 3, 0.03);
}

TEST(HopperFigures, AnNdivAtItsBoundIsNoMeasurement) {
  HopperStudy all = study();
  EXPECT_NEAR(value_of(hopper_figures(all), "D08"), 0.37, 1e-12);
  EXPECT_NE(figure_of(hopper_figures(all), "D07").how.find("B(0.30) = 0.613 mm"), std::string::npos);
  all.length_at_bound = true;
  EXPECT_TRUE(std::isnan(value_of(hopper_figures(all), "D08")));
  EXPECT_NE(figure_of(hopper_figures(all), "D08").how.find("at its bound, 0.3700"), std::string::npos);
}

TEST(LengthFit, ComesBackWhereItsDivergenceIsWithinTheBounds) {
  const FittedLength fitted = fit_rising_branch(lengths(0.116 * kMm, 0.353, 0.34), kBulk, kSlit);
  EXPECT_FALSE(fitted.at_bound);
  EXPECT_NEAR(fitted.length.diverging, 0.353, 5e-4);
  EXPECT_NEAR(fitted.length.smallest, 0.116 * kMm, 0.005 * kMm);
  EXPECT_NEAR(fitted.length.peak, 0.95 * kBulk, 1e-12);
  EXPECT_NEAR(fitted.length(0.30), 0.773 * kMm, 0.01 * kMm);
}

TEST(LengthFit, StopsWhereTheLengthAtThePeakWouldBeThatOfTheSlit) {
  // Diverges at 0.34, below the peak at 0.347.
  const auto points = lengths(0.2 * kMm, 0.34, 0.33);
  const FittedLength fitted = fit_rising_branch(points, kBulk, kSlit);
  EXPECT_TRUE(fitted.at_bound);
  EXPECT_GT(fitted.length.diverging, fitted.length.peak);
  EXPECT_NEAR(fitted.length(fitted.length.peak), kSlit, 1e-6);
  // B_0 belongs to that n_div: the mean of log B is that of the points.
  double apart = 0;
  for (const auto& point : points) apart += std::log(fitted.length(point.fraction) / point.length);
  EXPECT_NEAR(apart, 0, 1e-9);
}

TEST(LengthFit, DivergesNoLaterThanAtRest) {
  const FittedLength fitted = fit_rising_branch(lengths(0.5 * kMm, 0.45, 0.34), kBulk, kSlit);
  EXPECT_TRUE(fitted.at_bound);
  EXPECT_NEAR(fitted.length.diverging, kBulk, 1e-12);
}

TEST(HopperFigures, AnotherSpeedLeavesTheCollapse) {
  HopperStudy all = study();
  all.fields[1] = fields(kSlit, 0.2);
  EXPECT_GT(spread_of_collapse(all), 0.1);
}

TEST(HopperFigures, StraightLinesHaveNoBendAndThoseOfTheKinematicModelDo) {
  const HopperFields made = fields(kSlit, 0.4);
  EXPECT_GT(bend_of_isoline(made.grid, made.vertical, -0.1, 1.5 * kMm, kSlit), 0.05 * kMm);
  std::vector<double> wedge;
  for (int row = 0; row <= made.grid.rows; ++row)
    for (int c = 0; c < made.grid.columns; ++c)
      wedge.push_back(std::abs(made.grid.x(c)) - 5 * kMm - 0.3 * row * made.grid.spacing_z() - 0.1);
  EXPECT_LT(bend_of_isoline(made.grid, wedge, -0.1, 1.5 * kMm, kSlit), 1e-9);
}

}  // namespace
}  // namespace diefill::process::laboratory
