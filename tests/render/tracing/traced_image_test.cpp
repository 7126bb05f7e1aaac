#include "render/tracing/traced_image.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

namespace diefill::render {
namespace {

constexpr Rgb kRed{200, 60, 60}, kSteel{200, 205, 212};

TracedSpheres spheres(const std::vector<Eigen::Vector4f>& all) {
  return {all, std::vector<Rgb>(all.size(), kRed)};
}

/// A square plate of this half width in the plane y = `y`, facing the eye.
TracedTriangles plate(float half, float y) {
  TracedTriangles plate;
  plate.corners = {{-half, y, -half}, {half, y, -half}, {half, y, half}, {-half, y, half}};
  plate.normals.assign(4, Eigen::Vector3f(0, -1, 0));
  plate.triangles = {{0, 1, 2}, {0, 2, 3}};
  plate.colours.assign(2, kSteel);
  return plate;
}

/// Looks along +y at 4 x 4 units.
TracedCamera camera() {
  TracedCamera camera;
  camera.height = 4;
  camera.distance = 20;
  return camera;
}

QImage image_of(const RayScene& scene, const RayScene* translucent = nullptr) {
  return trace_image(scene, translucent, 0.13F, camera(), {2}, 120, 120);
}

int brightness(QRgb pixel) {
  return qRed(pixel) + qGreen(pixel) + qBlue(pixel);
}

TEST(TracedImage, ShowsASphereWhereItIsAndWhiteBeside) {
  const RayScene scene(spheres({{1, 0, 1, 0.5F}}), {});
  const QImage image = image_of(scene);
  EXPECT_EQ(image.pixel(10, 110), qRgb(255, 255, 255));
  EXPECT_EQ(image.pixel(30, 30), qRgb(255, 255, 255));  // mirrored it would be here
  const QRgb middle = image.pixel(90, 30);
  EXPECT_GT(qRed(middle), 150);
  EXPECT_LT(qGreen(middle), 90);
  // Its radius is 15 pixels.
  EXPECT_NE(image.pixel(90 + 14, 30), qRgb(255, 255, 255));
  EXPECT_EQ(image.pixel(90 + 16, 30), qRgb(255, 255, 255));
}

TEST(TracedImage, TheNearerBodyHidesTheFartherOne) {
  const RayScene hidden(spheres({{0, 2, 0, 0.5F}}), plate(2, 0)),
      seen(spheres({{0, -2, 0, 0.5F}}), plate(2, 0));
  const QRgb plate_colour = image_of(hidden).pixel(60, 60), grain = image_of(seen).pixel(60, 60);
  EXPECT_LT(qRed(plate_colour) - qBlue(plate_colour), 20);
  EXPECT_GT(qRed(grain) - qBlue(grain), 80);
}

TEST(TracedImage, ABodyShadesWhatIsBehindItFromTheLamp) {
  const RayScene free({}, plate(2, 0)), shaded(spheres({{-0.5F, -1.2F, 0.5F, 0.3F}}), plate(2, 0));
  const QImage lit = image_of(free), dark = image_of(shaded);
  int darkest = 0;
  for (int row = 0; row < 120; ++row)
    for (int column = 0; column < 120; ++column) {
      const bool plate_there = qRed(dark.pixel(column, row)) - qBlue(dark.pixel(column, row)) < 20;
      if (plate_there)
        darkest = std::max(darkest, brightness(lit.pixel(column, row)) - brightness(dark.pixel(column, row)));
    }
  EXPECT_GT(darkest, 100);
}

TEST(TracedImage, AGapBetweenSpheresIsDarkerThanTheirTops) {
  std::vector<Eigen::Vector4f> all;
  for (int i = -3; i <= 3; ++i)
    for (int k = -3; k <= 3; ++k) all.emplace_back(0.8F * i, 0, 0.8F * k, 0.4F);
  const RayScene scene(spheres(all), plate(3, 0.2F));
  const QImage image = image_of(scene);
  EXPECT_LT(brightness(image.pixel(60 + 11, 60 + 1)) + 60, brightness(image.pixel(60, 60)));
}

TEST(TracedImage, IsSeenThroughTranslucentBodies) {
  const RayScene scene(spheres({{0, 0, 0, 0.5F}}), {}), glass({}, plate(1, -1));
  const QImage image = image_of(scene, &glass);
  const QRgb behind = image.pixel(60, 60), beside = image.pixel(60 + 22, 60);
  EXPECT_GT(qRed(behind) - qBlue(behind), 60);
  EXPECT_NE(beside, qRgb(255, 255, 255));
  EXPECT_GT(brightness(beside), 3 * 225);
  EXPECT_EQ(image.pixel(115, 60), qRgb(255, 255, 255));
}

TEST(TracedImage, IsTheSameOnOneThreadAndMany) {
  std::vector<Eigen::Vector4f> all;
  for (int n = 0; n < 400; ++n)
    all.emplace_back(2 * std::sin(1.7F * n), std::cos(2.3F * n), 2 * std::sin(3.1F * n + 1), 0.2F);
  const auto image = [&] { return image_of(RayScene(spheres(all), plate(2, 0.5F))); };
  const QImage many = image();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(image(), many);
}

}  // namespace
}  // namespace diefill::render
