// Lines of equal value of fields whose lines are known, and the charts of them.
#include "process/laboratory/flow/hopper_contours.h"

#include <gtest/gtest.h>

#include <cmath>

namespace diefill::process::laboratory {
namespace {

constexpr double kMm = 1e-3;

continuum::HopperGrid contour_grid() {
  return {40 * kMm, 30 * kMm, 80, 60};
}

template <class Value>
std::vector<double> field_of(const Value& value) {
  const auto grid = contour_grid();
  std::vector<double> field;
  for (int row = 0; row <= grid.rows; ++row)
    for (int c = 0; c < grid.columns; ++c) field.push_back(value(grid.x(c), row * grid.spacing_z()));
  return field;
}

TEST(HopperContours, OfAFieldThatRisesWithHeightAreLevel) {
  const auto field = field_of([](double, double z) { return z; });
  const auto lines = contour_lines(contour_grid(), field, 10.2 * kMm);
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].size(), 80U);
  for (const auto& point : lines[0]) EXPECT_NEAR(point.y(), 10.2 * kMm, 1e-12);
  EXPECT_NEAR(std::abs(lines[0].back().x() - lines[0].front().x()), 39.5 * kMm, 1e-12);
  EXPECT_TRUE(contour_lines(contour_grid(), field, 31 * kMm).empty());
}

TEST(HopperContours, RoundAPeakAreClosed) {
  const auto field = field_of([](double x, double z) { return std::hypot(x, z - 15 * kMm); });
  const auto lines = contour_lines(contour_grid(), field, 8.1 * kMm);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_GT(lines[0].size(), 50U);
  EXPECT_EQ(lines[0].front(), lines[0].back());
  for (const auto& point : lines[0])
    EXPECT_NEAR(std::hypot(point.x(), point.y() - 15 * kMm), 8.1 * kMm, 0.02 * kMm);
}

TEST(HopperContours, EndWhereAFieldHasNoValue) {
  const auto field = field_of([](double x, double z) { return std::abs(x) < 5 * kMm ? std::nan("") : z; });
  const auto lines = contour_lines(contour_grid(), field, 10.2 * kMm);
  ASSERT_EQ(lines.size(), 2U);
  for (const auto& line : lines)
    for (const auto& point : line) EXPECT_GT(std::abs(point.x()), 5 * kMm);
}

TEST(HopperContours, OfAModelAgainstItselfLieOnEachOther) {
  const auto grid = contour_grid();
  std::vector<double> opening;
  for (int c = 0; c < grid.columns; ++c) opening.push_back(std::abs(grid.x(c)) < 7.5 * kMm ? -0.45 : 0);
  const auto flow = continuum::solve_kinematic(grid, opening, continuum::constant_length(1.8 * kMm));
  HopperFields fields;
  fields.grid = grid;
  fields.vertical = flow.vertical;
  for (int row = 0; row <= grid.rows; ++row)
    for (int c = 0; c < grid.columns; ++c)
      fields.horizontal.push_back(0.5 * (flow.horizontal_at(c, row) + flow.horizontal_at(c + 1, row)));
  fields.fraction = field_of([](double, double z) { return 0.2 + 0.005 * z / kMm; });
  std::vector<results::ExperimentChart> charts;
  add_contour_charts(fields, {&flow, &flow}, charts);
  ASSERT_EQ(charts.size(), 3U);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& series = charts[k].series;
    ASSERT_EQ(series.size(), 3U);
    ASSERT_GT(series[0].x.size(), 20U);
    for (std::size_t n = 0; n < series[0].x.size(); ++n) {
      bool on_line = false;
      for (std::size_t m = 0; m < series[1].x.size() && !on_line; ++m)
        on_line = series[1].x[m] == series[0].x[n] && series[1].y[m] == series[0].y[n];
      EXPECT_TRUE(on_line) << charts[k].name << ' ' << n;
    }
  }
  EXPECT_EQ(charts[2].series.at(2).name, "0.3");
  for (const double z : charts[2].series.at(2).y) EXPECT_NEAR(z, 20, 1e-9);
}

}  // namespace
}  // namespace diefill::process::laboratory
