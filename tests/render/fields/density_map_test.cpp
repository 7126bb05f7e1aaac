#include "render/fields/density_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "render/style/text.h"
#include "tests/render/fields/drawing_test.h"
#include "tests/render/synthetic_ring.h"

namespace diefill::render::test {
namespace {

using DensityMap = Drawing;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr ColourRange kFromData{kNone, kNone};
const std::string kTitle = "1 passage at 0.2 m/s";
const std::string kSubtitle = "Dist. AE, grain model D, grain size 1.88 mm";

FieldPicture compose(const results::Field2D& field) {
  return compose_field(field, kTitle, kSubtitle, kFromData);
}

// A smooth field without holes over width x height mm.
results::Field2D plain_field(double width, double height, double offset, double span) {
  results::Field2D field{"solid fraction", "x", "mm", "z", "mm", {}, {}, {}, 1e-3};
  for (int k = 0; k <= 40; ++k) field.first.push_back(width * k / 40);
  for (int k = 0; k <= 40; ++k) field.second.push_back(height * k / 40);
  for (int j = 0; j <= 40; ++j)
    for (int i = 0; i <= 40; ++i)
      field.value.push_back(offset + span * std::sin(0.1 * i) * std::cos(0.12 * j));
  return field;
}

// What every picture of a field must satisfy: nothing touches the canvas' edge, no text in the data
// rectangle's way.
void expect_sound(const FieldPicture& picture) {
  EXPECT_TRUE(has_white_border(picture.image, 8));
  EXPECT_TRUE(QRectF(picture.image.rect()).contains(picture.plot.rect));
  if (picture.bar_rect.isEmpty()) return;
  EXPECT_GT(picture.bar_rect.left(), picture.plot.rect.right());
  // A white column between data and bar, and white above the data's frame within the width of the marker
  // band's gap.
  const QRect gap(static_cast<int>(picture.plot.rect.right()) + 6,
                  static_cast<int>(picture.plot.rect.top()) + 40, 12,
                  static_cast<int>(picture.plot.rect.height()) - 80);
  EXPECT_EQ(ink(picture.image, gap), 0);
}

TEST_F(DensityMap, HasSizeWhiteGroundAndBar) {
  const auto picture = compose(make_map());
  keep(picture.image, "map.png");
  EXPECT_EQ(picture.image.size(), QSize(1600, 900));
  EXPECT_EQ(pixel_at(picture.image, {2, 2}), (Rgb{255, 255, 255}));
  expect_sound(picture);
  for (const double fraction : {0.05, 0.35, 0.75, 0.95}) {
    const QPointF place(picture.bar_rect.center().x(),
                        picture.bar_rect.bottom() - fraction * picture.bar_rect.height());
    EXPECT_TRUE(close_to(pixel_at(picture.image, place), map_colour(fraction), 3)) << fraction;
  }
}

TEST_F(DensityMap, ColoursAtNodesAreThoseOfTheScale) {
  const auto map = make_map();
  const auto picture = compose(map);
  for (std::size_t j = 1; j + 8 < map.second.size(); j += 3) {
    for (std::size_t i = 1; i + 1 < map.first.size(); i += 7) {
      const Rgb wanted =
          value_colour(map.value[j * map.first.size() + i], picture.bar.range.lower, picture.bar.range.upper);
      const Rgb found = pixel_at(picture.image, picture.plot.pixel(map.first[i], map.second[j]));
      EXPECT_TRUE(close_to(found, wanted, 3)) << map.first[i] << " deg, " << map.second[j] << " mm";
    }
  }
}

TEST_F(DensityMap, HolesAreGreyAndExplained) {
  const auto picture = compose(make_map());
  EXPECT_TRUE(picture.has_holes);
  EXPECT_EQ(pixel_at(picture.image, picture.plot.pixel(180, 17)), kNoValueColour);
  EXPECT_EQ(pixel_at(picture.image, picture.plot.pixel(90, 19)), kNoValueColour);
  const auto whole = compose(plain_field(30, 20, 0.35, 0.05));
  EXPECT_FALSE(whole.has_holes);
  const auto legend = [](const QImage& image) {
    return ink(image, {image.width() - 250, image.height() - 75, 240, 50});
  };
  EXPECT_GT(legend(picture.image), 300);
  EXPECT_EQ(legend(whole.image), 0);
}

TEST_F(DensityMap, AzimuthRunsOnceRoundAndMeetsItself) {
  const auto picture = compose(make_map());
  EXPECT_DOUBLE_EQ(picture.plot.x.range.lower, 0);
  EXPECT_DOUBLE_EQ(picture.plot.x.range.upper, 360);
  EXPECT_EQ(picture.plot.x.ticks.labels.size(), 9U);
  EXPECT_EQ(picture.plot.x.ticks.labels[4], "180");
  EXPECT_EQ(picture.plot.x.label.toStdString(), "Azimuth [°]");
  EXPECT_EQ(picture.plot.y.label.toStdString(), "Height above cavity floor [mm]");
  EXPECT_EQ(picture.bar.label.toStdString(), "Solid fraction [–]");
  const auto colour = [&](double azimuth) { return pixel_at(picture.image, picture.plot.pixel(azimuth, 5)); };
  EXPECT_TRUE(close_to(colour(0.8), colour(359.2), 4));
}

TEST_F(DensityMap, ShoeMarksPointAtTheirAzimuths) {
  const auto picture = compose(make_map());
  for (const double azimuth : {0.0, 180.0, 360.0}) {
    const QPointF tip = picture.plot.pixel(azimuth, 20) - QPointF(0, 8);
    EXPECT_EQ(pixel_at(picture.image, tip), (Rgb{0, 0, 0})) << azimuth;
  }
  EXPECT_EQ(pixel_at(picture.image, picture.plot.pixel(90, 20) - QPointF(0, 8)), (Rgb{255, 255, 255}));
}

TEST_F(DensityMap, SectionKeepsEqualScales) {
  const auto picture = compose(make_section().field);
  keep(picture.image, "section.png");
  expect_sound(picture);
  const double across = picture.plot.rect.width() / picture.plot.x.range.length();
  const double along = picture.plot.rect.height() / picture.plot.y.range.length();
  EXPECT_NEAR(across / along, 1, 2e-3);
  EXPECT_EQ(pixel_at(picture.image, picture.plot.pixel(0, -10)), kNoValueColour);
  EXPECT_NE(pixel_at(picture.image, picture.plot.pixel(10, -10)), kNoValueColour);
}

TEST_F(DensityMap, TallWideAndExtremeSectionsFit) {
  const std::pair<double, double> sizes[] = {{6, 60}, {120, 12}, {1, 50}, {200, 2}, {0.02, 0.015}};
  for (const auto& [width, height] : sizes) {
    const auto picture = compose(plain_field(width, height, 0.35, 0.05));
    keep(picture.image, "section_" + std::to_string(width) + "x" + std::to_string(height) + ".png");
    expect_sound(picture);
    EXPECT_LE(picture.image.width(), 1700);
    EXPECT_LE(picture.image.height(), 1500);
    EXPECT_GE(picture.plot.x.ticks.at.size(), 1U);
  }
}

TEST_F(DensityMap, EmptyFieldSaysSoInsteadOfShowingAScale) {
  auto map = make_map();
  std::fill(map.value.begin(), map.value.end(), kNone);
  const auto picture = compose(map);
  keep(picture.image, "map_empty.png");
  expect_sound(picture);
  EXPECT_TRUE(picture.bar_rect.isEmpty());
  EXPECT_EQ(pixel_at(picture.image, picture.plot.pixel(45, 5)), kNoValueColour);
  const QPoint centre = picture.plot.rect.center().toPoint();
  int dark = 0;
  for (int column = centre.x() - 100; column < centre.x() + 100; ++column)
    for (int row = centre.y() - 20; row < centre.y() + 20; ++row)
      dark += qGray(picture.image.pixel(column, row)) < 60;
  EXPECT_GT(dark, 200);
}

TEST_F(DensityMap, ConstantFieldHasOneColourAndAReadableScale) {
  auto map = make_map();
  std::fill(map.value.begin(), map.value.end(), 0.35);
  const auto picture = compose(map);
  keep(picture.image, "map_constant.png");
  expect_sound(picture);
  EXPECT_TRUE(close_to(pixel_at(picture.image, picture.plot.pixel(20, 3)), map_colour(0.5), 1));
  EXPECT_TRUE(close_to(pixel_at(picture.image, picture.plot.pixel(200, 18)), map_colour(0.5), 1));
  EXPECT_LT(picture.bar.range.lower, 0.35);
  EXPECT_GT(picture.bar.range.upper, 0.35);
  EXPECT_FALSE(picture.bar.open_above);
}

TEST_F(DensityMap, TinyRangeKeepsItsLabelsApart) {
  const auto picture =
      compose_field(plain_field(30, 20, 0.35, 1e-6), kTitle, kSubtitle, {0.349999, 0.350001});
  keep(picture.image, "section_tiny_range.png");
  expect_sound(picture);
  const auto labels = nice_ticks(picture.bar.range, 7).labels;
  EXPECT_GE(labels.size(), 3U);
  for (std::size_t k = 1; k < labels.size(); ++k) EXPECT_NE(labels[k], labels[k - 1]);
}

TEST_F(DensityMap, GivenRangeIsKeptAndEndsPointWhereValuesLieBeyond) {
  const auto map = make_map();
  const auto picture = compose_field(map, kTitle, kSubtitle, {0.33, 0.37});
  EXPECT_DOUBLE_EQ(picture.bar.range.lower, 0.33);
  EXPECT_DOUBLE_EQ(picture.bar.range.upper, 0.37);
  EXPECT_TRUE(picture.bar.open_below && picture.bar.open_above);
  const QPointF above(picture.bar_rect.center().x(), picture.bar_rect.top() - 8);
  EXPECT_TRUE(close_to(pixel_at(picture.image, above), map_colour(1), 2));
  const auto wide = compose_field(map, kTitle, kSubtitle, {0, 1});
  EXPECT_FALSE(wide.bar.open_below || wide.bar.open_above);
  EXPECT_EQ(pixel_at(wide.image, {wide.bar_rect.center().x(), wide.bar_rect.top() - 8}),
            (Rgb{255, 255, 255}));
}

TEST_F(DensityMap, OneLimitMayComeFromTheData) {
  const auto picture = compose_field(make_map(), kTitle, kSubtitle, {kNone, 0.5});
  EXPECT_DOUBLE_EQ(picture.bar.range.upper, 0.5);
  EXPECT_DOUBLE_EQ(picture.bar.range.lower, 0.3);
}

TEST_F(DensityMap, RangeTheWrongWayRoundIsRefused) {
  EXPECT_THROW(compose_field(make_map(), kTitle, kSubtitle, {0.5, 0.4}), std::runtime_error);
}

TEST_F(DensityMap, LongTitlesWrapAndNeverReachTheData) {
  std::string title =
      "Suction filling over a ring cavity with six passages of a vibrating feed shoe at 0.2 m/s, amplitude "
      "1 mm, frequency 32 Hz, followed by rotational shaking";
  const auto picture =
      compose_field(make_map(), title, kSubtitle + ", coarse grained with factor 18.8", kFromData);
  keep(picture.image, "map_long_title.png");
  expect_sound(picture);
  EXPECT_GT(picture.plot.rect.height(), 400);
  const Heading heading(title + title + title, kSubtitle, 1500);
  EXPECT_LT(heading.height(), 180);
}

TEST_F(DensityMap, DrawnTwiceIsTheSameFile) {
  draw_field(file("one.png"), make_map(), kTitle, kSubtitle, kFromData);
  draw_field(file("two.png"), make_map(), kTitle, kSubtitle, kFromData);
  EXPECT_GT(std::filesystem::file_size(file("one.png")), 10000U);
  EXPECT_EQ(contents(file("one.png")), contents(file("two.png")));
  const QImage read(QString::fromStdString(file("one.png").string()));
  EXPECT_EQ(read.size(), QSize(1600, 900));
  EXPECT_EQ(read.dotsPerMeterX(), 10000);
}

TEST_F(DensityMap, UnwritablePlaceIsNamedInOneLine) {
  const auto target = file("missing") / "map.png";
  try {
    draw_field(target, make_map(), kTitle, kSubtitle, kFromData);
    FAIL() << "a picture in a folder that is not there";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(target.string()), std::string::npos);
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST_F(DensityMap, BrokenFieldIsRefusedAndNothingIsWritten) {
  auto map = make_map();
  map.value.resize(7);
  EXPECT_THROW(draw_field(file("map.png"), map, kTitle, kSubtitle, kFromData), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(file("map.png")));
}

}  // namespace
}  // namespace diefill::render::test
