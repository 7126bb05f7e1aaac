#include "render/scene3d/view_choice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/render/synthetic_ring.h"

namespace diefill::render::test {
namespace {

constexpr double kAspect = 1.3;

// Whether a point lies in the picture, by the view's parallel projection.
bool shows(const ViewChoice& view, const Eigen::Vector3d& point) {
  const Eigen::Vector3d away = point - view.target;
  const double up = away.z() * std::cos(view.elevation) + away.y() * std::sin(view.elevation);
  return std::abs(away.x()) <= 0.5 * view.width && std::abs(up) <= 0.5 * view.height;
}

TEST(ViewChoice, CutsThroughTheAxisAndShowsTheWholeCavity) {
  auto result = make_ring();
  result.cavity.axis_origin.y() = 2e-3;
  const auto view = choose_view(result, kAspect);
  EXPECT_DOUBLE_EQ(view.cut_y, 2e-3);
  EXPECT_NEAR(view.width / view.height, kAspect, 1e-12);
  for (const double x : {-12.46e-3, 12.46e-3})
    for (const double y : {2e-3, 12.46e-3})
      for (const double z : {-20e-3, 0.0}) EXPECT_TRUE(shows(view, {x, y, z})) << x << " " << y << " " << z;
}

TEST(ViewChoice, NearShoeIsFramedFarShoeIsNot) {
  auto result = make_ring();
  result.tools = {make_tube("shoe", 10e-3, 12e-3, 0.3e-3, 12e-3, {22e-3, 0}, 4)};
  result.powder = {};
  const auto near = choose_view(result, kAspect);
  EXPECT_TRUE(shows(near, {29e-3, 0, 5e-3}));
  result.tools = {make_tube("shoe", 10e-3, 12e-3, 0.3e-3, 12e-3, {200e-3, 0}, 4)};
  const auto far = choose_view(result, kAspect);
  EXPECT_LT(far.width, near.width);
  result.tools.clear();
  EXPECT_DOUBLE_EQ(choose_view(result, kAspect).width, far.width);
}

TEST(ViewChoice, CavityNeverShrinksToASpeck) {
  auto result = make_ring();
  result.tools = {make_tube("shoe", 300e-3, 320e-3, 0.3e-3, 60e-3, {0, 0}, 4)};
  const auto view = choose_view(result, kAspect);
  EXPECT_LT(view.width, 4 * 2 * 12.46e-3);
}

TEST(ViewChoice, FramesAllCavities) {
  auto result = make_ring();
  result.tools.clear();
  auto other = result.cavity;
  other.lower_corner.x() += 40e-3;
  other.upper_corner.x() += 40e-3;
  result.other_cavities = {other};
  const auto view = choose_view(result, kAspect);
  for (const double x : {-12.46e-3, 52.46e-3}) EXPECT_TRUE(shows(view, {x, view.cut_y, -20e-3})) << x;
}

/// A ring whose shoe is at `displacement` (m) from its place at the end in the only instant.
results::FillResult ring_with_instant(const Eigen::Vector3d& displacement) {
  auto result = make_ring();
  results::Instant instant;
  for (const auto& tool : result.tools) {
    instant.tool_orientation.emplace_back(1.0, 0.0, 0.0, 0.0);
    instant.tool_displacement.emplace_back(0.0, 0.0, 0.0);
    if (tool.role == "shoe") instant.tool_displacement.back() = displacement;
  }
  result.instants = {instant};
  return result;
}

TEST(ViewChoice, APassageIsSeenCloseToTheCavity) {
  const auto view = view_of_passage(ring_with_instant({-52e-3, 0, 0}), kAspect);
  ASSERT_TRUE(view);
  EXPECT_NEAR(view->width / view->height, kAspect, 1e-12);
  EXPECT_GT(2 * 12.46e-3, 0.4 * view->width);
  for (const double x : {-12.46e-3, 12.46e-3})
    for (const double z : {-20e-3, 10e-3}) EXPECT_TRUE(shows(*view, {x, 0, z})) << x << " " << z;
  for (const double x : {-40e-3, 40e-3}) EXPECT_FALSE(shows(*view, {x, 0, 5e-3})) << x;
  // As each camera sees it.
  const Camera side{1.57, 0.35};
  const auto from_the_side = view_of_passage(ring_with_instant({-52e-3, 0, 0}), kAspect, side);
  ASSERT_TRUE(from_the_side);
  EXPECT_EQ(from_the_side->azimuth, side.azimuth);
}

TEST(ViewChoice, WithoutACrossingThereIsNoPassage) {
  EXPECT_FALSE(view_of_passage(make_ring(), kAspect));
  EXPECT_FALSE(view_of_passage(ring_with_instant({1e-3, 0, 0}), kAspect));  // shaken
  EXPECT_FALSE(view_of_passage(ring_with_instant({0, 0, 40e-3}), kAspect));
  auto without_cavity = ring_with_instant({-52e-3, 0, 0});
  without_cavity.cavity = {};
  EXPECT_FALSE(view_of_passage(without_cavity, kAspect));
}

TEST(ViewChoice, UnitedViewsShowWhatEachShows) {
  ViewChoice left;
  left.width = 0.13;
  left.height = 0.1;
  left.elevation = 0.35;
  ViewChoice right = left;
  right.target = {0.1, 0, 0.08};
  right.width = 0.26;
  right.height = 0.2;
  const auto both = united(left, right);
  EXPECT_NEAR(both.width / both.height, 1.3, 1e-12);
  for (const auto* view : {&left, &right})
    for (const double across : {-0.499, 0.499})
      for (const double up : {-0.499, 0.499}) {
        const auto axes = view_axes(*view);
        EXPECT_TRUE(
            shows(both, view->target + across * view->width * axes.right + up * view->height * axes.up));
      }
}

TEST(ViewChoice, WithoutCavityThePowderIsFramed) {
  auto result = make_ring();
  result.cavity = {};
  const auto view = choose_view(result, kAspect);
  for (const auto& position : result.powder.position)
    EXPECT_TRUE(position.y() < view.cut_y || shows(view, position));
}

TEST(ViewChoice, NothingAtAllIsEmpty) {
  EXPECT_TRUE(choose_view(results::FillResult{}, kAspect).empty);
  auto result = make_ring();
  result.cavity = {};
  result.powder = {};
  EXPECT_FALSE(choose_view(result, kAspect).empty);
}

}  // namespace
}  // namespace diefill::render::test
