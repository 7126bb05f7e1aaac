#include "render/fields/field_sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "process/results/places_without_value.h"
#include "tests/render/synthetic_ring.h"

namespace diefill::render::test {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

results::Field2D bilinear_field() {
  results::Field2D field{"solid fraction", "x", "mm", "z", "mm", {0, 1, 3, 7}, {-2, 0, 5}, {}, 0};
  for (const double z : field.second)
    for (const double x : field.first) field.value.push_back(2 + 3 * x - 0.5 * z + 0.25 * x * z);
  return field;
}

std::string message_of(const results::Field2D& field) {
  try {
    check_field(field);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(FieldSampler, ReproducesABilinearFunctionBetweenUnevenNodes) {
  const auto field = bilinear_field();
  const FieldSampler sampler(field);
  for (const double x : {0.0, 0.3, 1.0, 2.2, 6.9, 7.0})
    for (const double z : {-2.0, -1.1, 0.0, 3.3, 5.0})
      EXPECT_NEAR(sampler.at(x, z), 2 + 3 * x - 0.5 * z + 0.25 * x * z, 1e-12);
}

TEST(FieldSampler, HoldsTheEdgeValueOutside) {
  const auto field = bilinear_field();
  const FieldSampler sampler(field);
  EXPECT_DOUBLE_EQ(sampler.at(-4, 0), sampler.at(0, 0));
  EXPECT_DOUBLE_EQ(sampler.at(9, 9), sampler.at(7, 5));
}

TEST(FieldSampler, HoleReachesHalfWayToTheNextNode) {
  auto field = bilinear_field();
  for (std::size_t row = 0; row < 3; ++row) field.value[row * 4 + 1] = kNone;  // the column x = 1
  const FieldSampler sampler(field);
  EXPECT_TRUE(std::isnan(sampler.at(1, 0)));
  EXPECT_TRUE(std::isnan(sampler.at(1.98, 0)));
  EXPECT_TRUE(std::isnan(sampler.at(0.52, 0)));
  EXPECT_DOUBLE_EQ(sampler.at(2.02, 0), sampler.at(3, 0));
  EXPECT_DOUBLE_EQ(sampler.at(0.48, 0), sampler.at(0, 0));
}

TEST(FieldSampler, OutsideToolsOnlyNodesOutsideThemCount) {
  auto field = bilinear_field();
  for (std::size_t row = 0; row < 3; ++row) field.value[row * 4 + 1] = results::inside_tool();  // x = 1
  const FieldSampler sampler(field);
  EXPECT_TRUE(results::is_inside_tool(sampler.at(0.9, 0)));
  EXPECT_DOUBLE_EQ(sampler.at_outside_tools(0.9, 0), sampler.at(0, 0));
  EXPECT_DOUBLE_EQ(sampler.at_outside_tools(1.1, -1), sampler.at(3, -1));
  EXPECT_TRUE(results::is_inside_tool(sampler.at_outside_tools(1, 0))) << "no other node counts there";
}

TEST(FieldSampler, AzimuthGoesRoundAtTheSeam) {
  const auto map = make_map();
  const auto round = continued_round(map);
  EXPECT_DOUBLE_EQ(round.first.front(), -5);
  EXPECT_DOUBLE_EQ(round.first.back(), 360);
  const FieldSampler sampler(round);
  EXPECT_DOUBLE_EQ(sampler.at(360, 5), sampler.at(0, 5));
  EXPECT_NEAR(sampler.at(357.5, 5), 0.5 * (sampler.at(355, 5) + sampler.at(0, 5)), 1e-12);
}

TEST(FieldSampler, ClosedCircleIsNotDoubled) {
  results::Field2D map{"solid fraction",       "azimuth", "deg", "height", "mm",
                       {0, 90, 180, 270, 360}, {0, 1},    {},    0};
  map.value = {1, 2, 3, 4, 1, 1, 2, 3, 4, 1};
  const auto round = continued_round(map);
  EXPECT_EQ(round.first, (std::vector<double>{-90, 0, 90, 180, 270, 360, 450}));
  EXPECT_EQ(round.value.front(), 4);
  EXPECT_EQ(round.value[6], 2);
}

TEST(FieldSampler, OtherFieldsStayAsTheyAre) {
  const auto field = bilinear_field();
  EXPECT_EQ(continued_round(field).first, field.first);
}

TEST(FieldCheck, NamesWhatIsWrong) {
  EXPECT_EQ(message_of(bilinear_field()), "");
  auto field = bilinear_field();
  field.value.pop_back();
  EXPECT_NE(message_of(field).find("11 values for 12 grid nodes"), std::string::npos);
  field = bilinear_field();
  field.first[2] = field.first[1];
  EXPECT_NE(message_of(field).find("rising order"), std::string::npos);
  field = bilinear_field();
  field.second[0] = kNone;
  EXPECT_NE(message_of(field).find("finite"), std::string::npos);
}

}  // namespace
}  // namespace diefill::render::test
