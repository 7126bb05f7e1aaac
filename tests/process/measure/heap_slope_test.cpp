// Slope of heaps whose surface is a known line, and how alike two fields are.
#include "process/measure/figures/heap_slope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "process/compare/compared_fields.h"
#include "tests/process/measure_sample.h"

namespace diefill::process {
namespace {

/// Grains in a wedge under a line of `degrees`, 60 d long, its toe at x = 0; a few lie about before it. It is
/// `highest` (d) high at most.
results::PowderState heap(double degrees, double highest = 1000) {
  const double d = kDiameter, gradient = std::tan(degrees * std::numbers::pi / 180);
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < 120; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k <= i && 0.5 * k * gradient <= highest; ++k)
        places.emplace_back(0.5 * i * d, j * d, 0.5 * k * gradient * d);
  for (int i = 1; i < 20; ++i) places.emplace_back(-i * d, 0, 0);
  return powder_of(places);
}

TEST(HeapSlope, IsThatOfTheSurface) {
  const Eigen::Vector3d from(-0.0201, -0.01, 0), to(0.03, 0.01, 0.05);
  // Every column's highest grain is its right-most: the same shift everywhere.
  for (const double degrees : {20.0, 35.0, 45.0})
    EXPECT_NEAR(heap_slope(heap(degrees), from, to), degrees, 0.05);
}

TEST(HeapSlope, AFlatTopIsNoPartOfIt) {
  const Eigen::Vector3d from(-0.0201, -0.01, 0), to(0.03, 0.01, 0.05);
  // The slope is a third of the surface and less, down to ten grains high.
  EXPECT_NEAR(heap_slope(heap(45, 20), from, to), 45, 0.05);
  EXPECT_NEAR(heap_slope(heap(59, 10), from, to), 59, 1.5);
}

TEST(HeapSlope, RisesAlongXOrFalls) {
  auto powder = heap(40, 25);
  for (auto& place : powder.position) place.x() = -place.x();
  EXPECT_NEAR(heap_slope(powder, {-0.0301, -0.01, 0}, {0.0201, 0.01, 0.05}), 40, 0.3);
}

TEST(HeapSlope, ADipInTheTopAndARunOutToeChangeNothing) {
  const HeapSurface clean = {{0, 0.5}, {1, 2}, {2, 4}, {3, 6}, {4, 8}, {5, 10}, {6, 10}};
  HeapSurface rough = clean;
  rough.insert(rough.begin(), {{-2, 0.5}, {-1, 0.4}});
  rough.insert(rough.end(), {{7, 5}, {8, 10}, {9, 9.8}});
  EXPECT_NEAR(line_of_slope(clean, 0, 0).slope, 2, 1e-12);
  EXPECT_NEAR(line_of_slope(rough, 0, 0).slope, 2, 1e-12);
  EXPECT_NEAR(line_of_slope(rough, 0, 0).level, 0, 1e-12);
  EXPECT_TRUE(
      std::isnan(line_of_slope({{0, 0.5}, {1, 10}, {2, 10}}, 0, 0).slope));  // steeper than columns show
  EXPECT_TRUE(std::isnan(line_of_slope(clean, 0, 9).slope));
}

TEST(HeapSlope, OnlyTheBoxCounts) {
  auto powder = heap(35);
  const std::size_t grains = powder.position.size();
  for (std::size_t k = 0; k < grains; ++k) {
    powder.position.push_back(powder.position[k] + Eigen::Vector3d(0, 0, 0.1));
    powder.position.push_back(powder.position[k] + Eigen::Vector3d(0.1, 0, 0));
  }
  EXPECT_NEAR(heap_slope(powder, {-0.0201, -0.01, 0}, {0.03, 0.01, 0.05}), 35, 0.05);
}

TEST(HeapSlope, NothingToFitGivesNone) {
  EXPECT_TRUE(std::isnan(heap_slope(powder_of({}), {0, 0, 0}, {1, 1, 1})));
  EXPECT_TRUE(std::isnan(heap_slope(heap(35), {-0.0201, -0.01, 0}, {0.001, 0.01, 0.05})));
}

TEST(HeapSlope, FigureHasANameWithoutBlanks) {
  EXPECT_EQ(heap_figure("heap on the floor"), "slope_of_heap_on_the_floor_deg");
}

results::Field2D field(const std::vector<double>& value, std::size_t columns) {
  results::Field2D made;
  for (std::size_t k = 0; k < columns; ++k) made.first.push_back(static_cast<double>(k));
  for (std::size_t k = 0; k < value.size() / columns; ++k) made.second.push_back(static_cast<double>(k));
  made.value = value;
  return made;
}

TEST(Correlation, OfFieldsAsOfPlainNumbers) {
  const auto first = field({1, 2, 3, 4}, 2);
  EXPECT_NEAR(correlation(first, field({10, 20, 30, 40}, 2)), 1, 1e-14);
  EXPECT_NEAR(correlation(first, field({4, 3, 2, 1}, 2)), -1, 1e-14);
  // Deviations (-1.5, -0.5, 0.5, 1.5) and (-1, 1, -1, 1): 2 / sqrt(5 * 4).
  EXPECT_NEAR(correlation(first, field({1, 3, 1, 3}, 2)), 2 / std::sqrt(20), 1e-14);
}

TEST(Correlation, TakesNodesWithBothValuesAndNeedsThree) {
  const double none = std::nan("");
  EXPECT_NEAR(correlation(field({1, 2, 3, none}, 2), field({3, 2, 1, 9}, 2)), -1, 1e-14);
  EXPECT_TRUE(std::isnan(correlation(field({1, 2, none, none}, 2), field({3, 2, 1, 9}, 2))));
  EXPECT_TRUE(std::isnan(correlation(field({1, 2, 3, 4}, 2), field({5, 5, 5, 5}, 2))));
}

}  // namespace
}  // namespace diefill::process
