// Fields of a hopper made of the kinematic model itself: what comes back out of them is known.
#include "process/laboratory/flow/hopper_models.h"

#include <gtest/gtest.h>

#include <cmath>

#include "process/laboratory/flow/field_mean.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kMm = 1e-3, kSlit = 15 * kMm;

continuum::HopperGrid grid() {
  return {45 * kMm, 40 * kMm, 180, 160};
}

/// The fields that grains would have if they moved as the model says.
HopperFields fields_of(const continuum::HopperFlow& flow, double fraction) {
  HopperFields fields;
  fields.grid = flow.grid;
  fields.bulk_fraction = fraction;
  fields.vertical = flow.vertical;
  for (int row = 0; row <= flow.grid.rows; ++row)
    for (int c = 0; c < flow.grid.columns; ++c)
      fields.horizontal.push_back(0.5 * (flow.horizontal_at(c, row) + flow.horizontal_at(c + 1, row)));
  fields.fraction.assign(fields.vertical.size(), fraction);
  return fields;
}

/// A smooth profile in the slit, at most -0.4 m/s.
continuum::HopperFlow flow_with(double length) {
  std::vector<double> opening;
  for (int c = 0; c < grid().columns; ++c) {
    const double x = grid().x(c);
    opening.push_back(std::abs(x) < kSlit / 2 ? -0.4 * std::pow(std::cos(M_PI * x / kSlit), 2) : 0);
  }
  return continuum::solve_kinematic(grid(), opening, continuum::constant_length(length));
}

TEST(HopperModels, LocalLengthsOfTheModelAreItsOwn) {
  const HopperFields fields = fields_of(flow_with(1.8 * kMm), 0.3);
  const auto points = local_lengths(fields, 0.01);
  ASSERT_GT(points.size(), 1000U);
  std::size_t close = 0;
  for (const auto& point : points) {
    EXPECT_EQ(point.fraction, 0.3);
    close += std::abs(point.length - 1.8 * kMm) < 0.02 * kMm;
  }
  // Rows at the slit, where the profile has a corner, are off.
  EXPECT_GT(static_cast<double>(close), 0.97 * static_cast<double>(points.size()));
}

TEST(HopperModels, AModelHasNoErrorAgainstItselfAndOneAgainstAnother) {
  const HopperFields fields = fields_of(flow_with(1.8 * kMm), 0.3);
  const auto same = solve_for(fields, kSlit, continuum::constant_length(1.8 * kMm), true);
  EXPECT_LT(error_of(same, fields, 0, 30 * kMm).vertical, 1e-12);
  EXPECT_LT(error_of(same, fields, 0, 30 * kMm).horizontal, 1e-12);
  const auto other = solve_for(fields, kSlit, continuum::constant_length(3.6 * kMm), false);
  EXPECT_GT(error_of(other, fields, 5 * kMm, 30 * kMm).vertical, 0.1);
}

TEST(HopperModels, ClassesHoldAllPointsButThinOnes) {
  std::vector<continuum::LengthPoint> points;
  for (int k = 0; k < 200; ++k) points.push_back({0.2 + 0.099 * k / 199.0, k % 2 == 0 ? 1e-3 : 3e-3, 1});
  points.push_back({0.4, 9e-3, 1});
  const auto classes = in_classes(points, 8);
  double count = 0;
  for (const auto& one : classes) {
    count += one.count;
    EXPECT_NEAR(one.mean, 2e-3, 1e-4);
    EXPECT_NEAR(one.deviation, 1e-3, 1e-4);
  }
  EXPECT_EQ(count, 200);
  EXPECT_TRUE(in_classes({}, 8).empty());
}

TEST(FieldMean, OfEqualValuesIsThatValueWhereThereAreGrains) {
  const continuum::HopperGrid small{10 * kMm, 10 * kMm, 20, 20};
  FieldMean mean(small, 0.5 * kMm, false);
  for (int k = 0; k < 50; ++k) mean.add(4 * kMm * std::sin(k), 3 * kMm + 2 * kMm * std::cos(3 * k), 7);
  const auto values = mean.mean();
  int there = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    ++there;
    EXPECT_NEAR(value, 7, 1e-12);
  }
  EXPECT_GT(there, 50);
  EXPECT_TRUE(std::isnan(values.back()));  // 5 mm above the highest grain
}

TEST(FieldMean, OfAnOddQuantityTurnsItsSignInTheMirror) {
  const continuum::HopperGrid small{10 * kMm, 10 * kMm, 20, 20};
  FieldMean odd(small, 0.5 * kMm, true);
  odd.add(2.25 * kMm, 5 * kMm, 3);
  const auto values = odd.mean();
  const auto at = [&](int column, int row) { return values[static_cast<std::size_t>(row) * 20 + column]; };
  EXPECT_NEAR(at(14, 10), 3, 1e-12);
  EXPECT_NEAR(at(5, 10), -3, 1e-12);
}

}  // namespace
}  // namespace diefill::process::laboratory
