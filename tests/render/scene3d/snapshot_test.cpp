#include "render/scene3d/snapshot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/fields/pictures.h"
#include "tests/render/fields/drawing_test.h"
#include "tests/render/synthetic_ring.h"

namespace diefill::render::test {
namespace {

using Snapshot = Drawing;

// Pixels of the scene whose channels differ by more than `least`: coloured, not grey metal or grey grains.
int colourful(const SnapshotPicture& picture, int least) {
  const QRect scene = picture.scene.toRect();
  int count = 0;
  for (int row = scene.top(); row <= scene.bottom(); ++row)
    for (int column = scene.left(); column <= scene.right(); ++column) {
      const QRgb pixel = picture.image.pixel(column, row);
      const auto [low, high] = std::minmax({qRed(pixel), qGreen(pixel), qBlue(pixel)});
      count += high - low > least;
    }
  return count;
}

results::FillResult only_powder() {
  auto result = make_ring();
  result.tools.clear();
  result.cavity = {};
  return result;
}

// One grain, in the middle of nowhere, with its cell closed.
results::FillResult one_grain(const Eigen::Vector3d& place) {
  auto result = make_ring();
  result.tools.clear();
  result.powder.position = {place};
  result.powder.orientation = {{1, 0, 0, 0}};
  result.solid_fraction.solid_fraction = {0.35};
  result.solid_fraction.open = {0};
  return result;
}

// Pixel of a point in the scene, by the parallel projection that the view describes.
QPointF project(const SnapshotPicture& picture, const Eigen::Vector3d& point) {
  const auto& view = picture.view;
  const double scale = picture.scene.width() / view.width;
  const Eigen::Vector3d away = point - view.target;
  const double up = away.z() * std::cos(view.elevation) + away.y() * std::sin(view.elevation);
  return picture.scene.center() + QPointF(scale * away.x(), -scale * up);
}

TEST_F(Snapshot, ShowsColouredPowderInCutTools) {
  const auto picture = compose_snapshot(make_ring());
  keep(picture.image, "snapshot.png");
  EXPECT_EQ(picture.image.size(), QSize(1600, 1200));
  EXPECT_TRUE(has_white_border(picture.image, 8));
  EXPECT_GT(colourful(picture, 60), 20000);
  EXPECT_FALSE(picture.bar_rect.isEmpty());
  EXPECT_TRUE(close_to(pixel_at(picture.image, picture.bar_rect.center()), map_colour(0.5), 4));
}

TEST_F(Snapshot, CutFacesAreFlatAndDarkerThanTheSurface) {
  const auto picture = compose_snapshot(make_ring());
  const Rgb face = pixel_at(picture.image, project(picture, {0, 0, -10e-3}));
  EXPECT_TRUE(close_to(face, pixel_at(picture.image, project(picture, {4e-3, 0, -3e-3})), 1));
  const Rgb top = pixel_at(picture.image, project(picture, {0, 4e-3, 0}));
  EXPECT_LT(face.green + 15, top.green);
  EXPECT_LT(top.green, 250);
}

TEST_F(Snapshot, ScaleBarIsTrueAndRound) {
  const auto picture = compose_snapshot(make_ring());
  const double pixels =
      project(picture, {1e-3 * picture.scale_bar, 0, 0}).x() - project(picture, {0, 0, 0}).x();
  EXPECT_NEAR(picture.scale_pixels, pixels, 1e-6);
  EXPECT_DOUBLE_EQ(picture.scale_bar, 10);
}

TEST_F(Snapshot, GrainStandsWhereItIsProjected) {
  const Eigen::Vector3d place(10e-3, 3e-3, -8e-3);
  const auto picture = compose_snapshot(one_grain(place));
  const Rgb found = pixel_at(picture.image, project(picture, place));
  EXPECT_FALSE(close_to(found, {255, 255, 255}, 20));
  const double radius_pixels = 0.31e-3 * picture.scene.width() / picture.view.width;
  const Rgb beside = pixel_at(picture.image, project(picture, place) + QPointF(20 * radius_pixels, 0));
  EXPECT_EQ(beside, (Rgb{255, 255, 255}));
}

TEST_F(Snapshot, PowderInFrontOfTheCutIsTakenAway) {
  EXPECT_GT(colourful(compose_snapshot(one_grain({10e-3, 3e-3, -8e-3})), 40), 100);
  EXPECT_EQ(colourful(compose_snapshot(one_grain({10e-3, -3e-3, -8e-3})), 40), 0);
}

TEST_F(Snapshot, OpenCellsAreGreyAndLeaveOutTheScale) {
  auto result = make_ring();
  std::fill(result.solid_fraction.open.begin(), result.solid_fraction.open.end(), std::uint8_t{1});
  result.tools.clear();
  const auto picture = compose_snapshot(result);
  keep(picture.image, "snapshot_grey.png");
  EXPECT_TRUE(picture.bar_rect.isEmpty());
  EXPECT_EQ(colourful(picture, 40), 0);
  EXPECT_GT(ink(picture.image, picture.scene.toRect()), 50000);
}

TEST_F(Snapshot, PowderNeverMeasuredIsGrey) {
  auto result = only_powder();
  result.solid_fraction = {};
  EXPECT_TRUE(compose_snapshot(result).bar_rect.isEmpty());
}

TEST_F(Snapshot, SceneWithoutCavityIsFramedByItsPowder) {
  const auto picture = compose_snapshot(only_powder());
  keep(picture.image, "snapshot_no_cavity.png");
  EXPECT_GT(colourful(picture, 60), 20000);
}

TEST_F(Snapshot, SlitPlatesWithOpenMeshAreDrawn) {
  auto result = only_powder();
  results::ToolState plate{"plate", "plate", {}, {}, {}, 0, ""};
  plate.vertices = {
      {-40e-3, -40e-3, -21e-3}, {40e-3, -40e-3, -21e-3}, {40e-3, 40e-3, -21e-3}, {-40e-3, 40e-3, -21e-3}};
  plate.triangles = {{0, 1, 2}, {0, 2, 3}};
  result.tools = {plate};
  const auto picture = compose_snapshot(result);
  keep(picture.image, "snapshot_plate.png");
  const Rgb plate_colour = pixel_at(picture.image, project(picture, {0, 20e-3, -21e-3}));
  EXPECT_FALSE(close_to(plate_colour, {255, 255, 255}, 10));
}

TEST_F(Snapshot, KindsHaveALegendInPlaceOfAScale) {
  const auto result = make_ring();
  ViewOptions options;
  options.kinds = {"graphite, very fine, lubricated", "iron"};
  for (std::size_t k = 0; k < result.powder.position.size(); ++k)
    options.values.push_back(static_cast<double>(1 + k % 2));
  const auto picture = compose_snapshot(result, options);
  keep(picture.image, "snapshot_kinds.png");
  EXPECT_TRUE(has_white_border(picture.image, 8));
  EXPECT_TRUE(picture.bar_rect.isEmpty());
  ASSERT_EQ(picture.swatches.size(), 2U);
  EXPECT_FALSE(picture.swatches[0].intersects(picture.swatches[1]));
  EXPECT_TRUE(close_to(pixel_at(picture.image, picture.swatches[0].center()), map_colour(0), 2));
  EXPECT_TRUE(close_to(pixel_at(picture.image, picture.swatches[1].center()), map_colour(1), 2));
}

TEST_F(Snapshot, AxesOfATurnedViewStayOnThePicture) {
  ViewOptions options;
  options.camera.azimuth = 0.5 * std::numbers::pi;
  options.camera.elevation = 20 * std::numbers::pi / 180;
  EXPECT_TRUE(has_white_border(compose_snapshot(make_ring(), options).image, 8));
}

TEST_F(Snapshot, NothingToShowIsSaid) {
  results::FillResult result;
  result.strategy = "nothing yet";
  const auto picture = compose_snapshot(result);
  EXPECT_TRUE(picture.view.empty);
  EXPECT_GT(ink(picture.image, picture.scene.toRect()), 500);
}

TEST_F(Snapshot, DrawnTwiceIsTheSameFile) {
  const auto result = make_ring();
  draw_snapshot(file("one.png"), result);
  draw_snapshot(file("two.png"), result);
  EXPECT_EQ(contents(file("one.png")), contents(file("two.png")));
}

}  // namespace
}  // namespace diefill::render::test
