#include "tests/render/fields/drawing_test.h"

#include <cstdlib>

#include "project_paths.h"
#include "render/fields/pictures.h"
#include "render/offscreen/start_offscreen.h"
#include "tests/support/image_compare.h"

namespace diefill::render::test {

void Drawing::SetUpTestSuite() {
  static std::string name = "render_tests";
  static char* arguments[] = {name.data(), nullptr};
  int count = 1;
  unsetenv("DISPLAY");
  start_offscreen(count, arguments);
}

void Drawing::keep(const QImage& image, const std::string& name) {
  const char* folder = std::getenv("DIEFILL_PICTURES");
  if (!folder) return;
  std::filesystem::create_directories(folder);
  image.save(QString::fromStdString((std::filesystem::path(folder) / name).string()), "PNG");
}

void Drawing::expect_like_reference(const QImage& image, const std::string& name) {
  keep(image, "reference_" + name);
  const auto path =
      QString::fromStdString(std::string(DIEFILL_SOURCE_DIR) + "/tests/render/references/" + name);
  if (std::getenv("DIEFILL_NEW_REFERENCES")) {
    ASSERT_TRUE(support::as_reference(image).save(path, "PNG"));
  }
  const QImage reference(path);
  ASSERT_FALSE(reference.isNull()) << path.toStdString();
  const auto distance = support::image_distance(support::as_reference(image), reference);
  EXPECT_LT(distance.mean, 0.5) << name;
  EXPECT_LT(distance.worst, 8) << name;
}

Rgb pixel_at(const QImage& image, const QPointF& place) {
  const QRgb pixel = image.pixel(static_cast<int>(place.x()), static_cast<int>(place.y()));
  return {static_cast<std::uint8_t>(qRed(pixel)), static_cast<std::uint8_t>(qGreen(pixel)),
          static_cast<std::uint8_t>(qBlue(pixel))};
}

bool close_to(const Rgb& one, const Rgb& other, int tolerance) {
  return std::abs(one.red - other.red) <= tolerance && std::abs(one.green - other.green) <= tolerance &&
         std::abs(one.blue - other.blue) <= tolerance;
}

int ink(const QImage& image, const QRect& area) {
  const QRect inside = area.intersected(image.rect());
  int count = 0;
  for (int row = inside.top(); row <= inside.bottom(); ++row)
    for (int column = inside.left(); column <= inside.right(); ++column)
      count += (image.pixel(column, row) & 0xFFFFFFU) != 0xFFFFFFU;
  return count;
}

bool has_white_border(const QImage& image, int border) {
  const QRect all = image.rect();
  return ink(image, all) == ink(image, all.adjusted(border, border, -border, -border));
}

}  // namespace diefill::render::test
