#include <gtest/gtest.h>

#include <numeric>

#include "process/measure/coordination.h"
#include "process/measure/earlier_instant.h"
#include "process/measure/fields/motion_field.h"
#include "process/measure/fields/time_average.h"
#include "process/measure/figures/variation.h"
#include "process/measure/measure.h"
#include "tests/process/measure_sample.h"

namespace diefill::process {
namespace {

const double kNan = std::nan("");

results::Field2D small_map() {
  return {"solid fraction",
          "azimuth",
          "deg",
          "height",
          "mm",
          {0, 180, 360},
          {1, 2},
          {0.3, 0.4, 0.3, kNan, 0.5, kNan},
          1e-3};
}

TEST(Variation, ProfilesCountBothEndsOfTheTurnOnce) {
  const auto over_height = profile_over_height(small_map());
  EXPECT_EQ(over_height.mean.x, (std::vector<double>{1, 2}));
  EXPECT_NEAR(over_height.mean.y[0], 0.35, 1e-15);
  EXPECT_NEAR(over_height.spread[0], 0.05, 1e-15);
  EXPECT_EQ(over_height.mean.y[1], 0.5);
  EXPECT_EQ(over_height.spread[1], 0);
  const auto over_azimuth = profile_over_azimuth(small_map());
  EXPECT_EQ(over_azimuth.mean.y[0], 0.3);
  EXPECT_NEAR(over_azimuth.mean.y[1], 0.45, 1e-15);
}

TEST(Variation, DifferenceIsAfterMinusBeforeWhereBothHavePowder) {
  auto after = small_map();
  after.second = {1, 2, 3};
  after.value = {0.31, kNan, 0.31, 0.2, 0.7, 0.2, 1, 1, 1};
  const auto change = difference(small_map(), after);
  EXPECT_NEAR(change.value[0], 0.01, 1e-15);
  EXPECT_TRUE(std::isnan(change.value[1]));
  EXPECT_TRUE(std::isnan(change.value[3]));
  EXPECT_NEAR(change.value[4], 0.2, 1e-15);
  after.first = {10, 170, 350};
  EXPECT_THROW(difference(small_map(), after), std::invalid_argument);
  after.first_name = "x";
  EXPECT_THROW(difference(small_map(), after), std::invalid_argument);
}

TEST(Variation, HistogramSharesSumToOne) {
  const auto counts = histogram("x", "1", {0.305, 0.307, 0.335, kNan, 0.349}, 0.01);
  EXPECT_EQ(counts.grains, 4U);
  ASSERT_EQ(counts.middle.size(), 5U);
  EXPECT_NEAR(counts.middle.front(), 0.305, 1e-12);
  EXPECT_NEAR(counts.share.front(), 0.5, 1e-15);
  EXPECT_NEAR(std::accumulate(counts.share.begin(), counts.share.end(), 0.0), 1, 1e-15);
  EXPECT_NEAR(counts.mean, 0.324, 1e-12);
  EXPECT_TRUE(histogram("x", "1", {}, 0.1).middle.empty());
}

TEST(Coordination, CubicLatticeHasSixNeighboursInside) {
  std::vector<Eigen::Vector3d> places;
  for (int n = 0; n < 27; ++n) places.emplace_back(n % 3, n / 3 % 3, n / 9);
  const auto numbers = coordination_numbers(powder_of(places, 1.0));
  EXPECT_EQ(numbers[13], 6);
  EXPECT_EQ(numbers[0], 3);
  EXPECT_EQ(coordination_numbers(powder_of(places, 0.99))[13], 0);
}

TEST(Coordination, PeriodicLatticeHasSixNeighboursEverywhere) {
  std::vector<Eigen::Vector3d> places;
  for (int n = 0; n < 27; ++n) places.emplace_back(n % 3 - 1, n / 3 % 3 - 1, n / 9);
  auto powder = powder_of(places, 1.0);
  powder.period = {3, 3, 0};
  const auto numbers = coordination_numbers(powder);
  for (std::size_t k = 0; k < numbers.size(); ++k)
    EXPECT_EQ(numbers[k], k / 9 == 1 ? 6 : 5) << k;      // the layers at the bottom and on top end there
  for (auto& place : powder.position) place.x() += 1.2;  // as grains that have left the box
  EXPECT_EQ(coordination_numbers(powder), numbers);
}

TEST(Coordination, AGrainDoesNotTouchItselfAcrossThePeriod) {
  auto powder = powder_of({{0, 0, 0}, {0, 0, 1}}, 1.0);
  powder.period = {1, 1, 0};
  EXPECT_EQ(coordination_numbers(powder), (std::vector<int>{1, 1}));
}

TEST(Coordination, SeveralContactsOfTwoGrainsCountOnce) {
  auto powder = powder_of({{0, 0, 0}, {0, 1, 0}}, 1.0);
  powder.sphere_offsets = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(coordination_numbers(powder), (std::vector<int>{1, 1}));
}

results::CavityState wide_ring() {
  results::CavityState cavity;
  cavity.is_ring = true;
  cavity.inner_radius = 4e-3;
  cavity.outer_radius = 8e-3;
  cavity.lower_corner = {-8e-3, -8e-3, -6e-3};
  cavity.upper_corner = {8e-3, 8e-3, 0};
  return cavity;
}

std::vector<Eigen::Vector3d> ring_places() {
  std::vector<Eigen::Vector3d> places;
  for (double x = -7.75e-3; x < 8e-3; x += 0.5e-3)
    for (double y = -7.75e-3; y < 8e-3; y += 0.5e-3)
      for (double z = -5.75e-3; z < 0; z += 0.5e-3)
        if (std::hypot(x, y) > 4e-3 && std::hypot(x, y) < 8e-3) places.emplace_back(x, y, z);
  return places;
}

TEST(MotionField, TurnedAndSettledRingMovesRoundAndDown) {
  const auto before = powder_of(ring_places());
  auto after = before;
  const Eigen::AngleAxisd turn(0.01, Eigen::Vector3d::UnitZ());
  for (auto& place : after.position) place = turn * place - Eigen::Vector3d(0, 0, 0.02e-3);
  const auto field =
      unrolled_vectors(displacements(before, after, wide_ring()), wide_ring(), kDiameter, 0.5e-3);
  ASSERT_GT(field.arrows.size(), 20U);
  for (const auto& arrow : field.arrows) {
    EXPECT_NEAR(arrow.along_first, 0.06, 0.006);  // mm at the middle radius
    EXPECT_NEAR(arrow.along_second, -0.02, 1e-9);
  }
}

TEST(MotionField, GrainsThatAreNotThereTwiceStayOut) {
  const auto before = powder_of({{6e-3, 0, -3e-3}, {-6e-3, 0, -3e-3}, {20e-3, 0, -3e-3}});
  auto after = before;
  after.id = {0, 99, 2};
  EXPECT_EQ(displacements(before, after, wide_ring()).place.size(), 1U);
}

TEST(EarlierInstant, MovesPowderAndToolsBack) {
  results::FillResult result;
  result.powder = powder_of({{1, 0, 0}});
  result.powder.time = 3;
  result.tools.push_back({"shoe", "shoe", {{1, 0, 0}}, {}, {{0, 1, 0}}, 0.1, ""});
  results::Instant instant{
      1,          {7}, {{5, 0, 0}}, {{1, 0, 0, 0}}, {{0, 0, -1}}, {{std::sqrt(0.5), 0, 0, std::sqrt(0.5)}},
      {{0, 0, 2}}};
  result.instants = {instant};
  instant.time = 2;
  result.instants.push_back(instant);
  const auto earlier = result_at(result, 1.1, false);
  EXPECT_EQ(earlier.powder.time, 1);
  EXPECT_EQ(earlier.powder.position.front(), Eigen::Vector3d(5, 0, 0));
  EXPECT_TRUE(earlier.tools.front().vertices.front().isApprox(Eigen::Vector3d(0, 1, 2), 1e-12));
  EXPECT_TRUE(earlier.tools.front().wall_sphere_centres.front().isApprox(Eigen::Vector3d(-1, 0, 2), 1e-12));
  EXPECT_EQ(result_at(result, 2.9, false).powder.time, 3);
  EXPECT_THROW(result_at(result, 9), std::invalid_argument);
  result.instants.clear();
  EXPECT_THROW(result_at(result, 1), std::invalid_argument);
}

/// A ring in which `places` stand at 1 s, one lower and faster at 2 s, and none at the end.
results::FillResult two_instants() {
  results::FillResult result;
  result.powder = powder_of({});
  result.powder.time = 3;
  result.cavity = wide_ring();
  for (const double time : {1.0, 2.0}) {
    const auto powder = powder_of(ring_places());
    results::Instant instant;
    instant.time = time;
    instant.id = powder.id;
    instant.position = powder.position;
    instant.orientation = powder.orientation;
    instant.velocity.assign(powder.id.size(), Eigen::Vector3d(0, 0, -time));
    result.instants.push_back(instant);
  }
  return result;
}

TEST(TimeAverage, IsTheMeanOverTheInstantsBetween) {
  std::size_t instants = 0;
  const auto average = time_average(two_instants(), 0.5, 2.5, &instants);
  EXPECT_EQ(instants, 2U);
  EXPECT_EQ(average.powder.position.size(), 2 * ring_places().size());
  EXPECT_EQ(average.solid_fraction.open.size(), average.powder.position.size());
  const auto field = unrolled_vectors(velocities(average.powder), wide_ring(), kDiameter, 0.5e-3);
  ASSERT_FALSE(field.arrows.empty());
  for (const auto& arrow : field.arrows) EXPECT_NEAR(arrow.along_second, -1.5, 1e-12);
}

TEST(TimeAverage, SolidFractionOfUnchangedPowderIsThatOfOneInstant) {
  const auto result = two_instants();
  const auto one = result_at(result, 1), average = time_average(result, 1, 2);
  const auto before = cylindrical_map(one.powder, one.solid_fraction, {}, one.cavity, 0.5e-3);
  const auto after = cylindrical_map(average.powder, average.solid_fraction, {}, average.cavity, 0.5e-3);
  ASSERT_EQ(before.value.size(), after.value.size());
  int compared = 0;
  for (std::size_t n = 0; n < before.value.size(); ++n) {
    if (std::isnan(before.value[n])) continue;
    EXPECT_NEAR(after.value[n], before.value[n], 1e-12);
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TEST(TimeAverage, RefusesFewerThanTwoInstants) {
  EXPECT_THROW(time_average(two_instants(), 0.5, 1.5), std::invalid_argument);
  EXPECT_THROW(time_average(two_instants(), 5, 9), std::invalid_argument);
}

TEST(MotionField, GrainsThatCrossAPeriodWentTheShortWay) {
  auto before = powder_of({{0, 2.9e-3, -3e-3}});
  before.position.front().x() = 6e-3;
  auto after = before;
  after.position.front().y() = -3.0e-3;
  after.period = {0, 6e-3};
  EXPECT_NEAR(displacements(before, after, wide_ring()).vector.front().y(), 0.1, 1e-12);
}

}  // namespace
}  // namespace diefill::process
