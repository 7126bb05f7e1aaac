#include "render/fields/comparison_picture.h"

#include <stdexcept>

#include "render/fields/field_sampler.h"
#include "tests/render/fields/drawing_test.h"
#include "tests/render/synthetic_ring.h"

namespace diefill::render::test {
namespace {

using ComparisonPictures = Drawing;
const std::string kTitle = "Narrow ring, shoe speed and number of passages";

/// Maps of a ring, each 0.01 denser than the one before.
std::vector<ComparedField> maps(int number) {
  std::vector<ComparedField> fields;
  for (int k = 0; k < number; ++k) {
    fields.push_back({"variant " + std::to_string(k + 1), make_map()});
    for (double& value : fields.back().field.value) value += 0.01 * k;
  }
  return fields;
}

TEST_F(ComparisonPictures, StandSideBySideWithinTheCanvas) {
  for (const int number : {1, 2, 6, 9}) {
    const auto picture = compose_comparison(maps(number), kTitle);
    keep(picture.image, "comparison_" + std::to_string(number) + ".png");
    EXPECT_TRUE(has_white_border(picture.image, 8)) << number;
    ASSERT_EQ(picture.plots.size(), static_cast<std::size_t>(number));
    for (std::size_t a = 0; a < picture.plots.size(); ++a) {
      EXPECT_TRUE(QRectF(picture.image.rect()).contains(picture.plots[a].rect));
      EXPECT_EQ(picture.plots[a].rect.size(), picture.plots[0].rect.size());
      for (std::size_t b = 0; b < a; ++b)
        EXPECT_FALSE(picture.plots[a].rect.intersects(picture.plots[b].rect)) << number;
    }
  }
}

// The same colour means the same solid fraction in every panel.
TEST_F(ComparisonPictures, ShareOneScale) {
  const auto fields = maps(4);
  const auto picture = compose_comparison(fields, kTitle);
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const FieldSampler sampler(fields[k].field);
    for (const double azimuth : {40.0, 155.0, 300.0}) {
      const auto colour = pixel_at(picture.image, picture.plots[k].pixel(azimuth, 8.1));
      const auto expected =
          value_colour(sampler.at(azimuth, 8.1), picture.bar.range.lower, picture.bar.range.upper);
      EXPECT_TRUE(close_to(colour, expected, 6)) << k << ' ' << azimuth;
    }
  }
}

TEST_F(ComparisonPictures, SayHowManySeedsAFieldIsTheMeanOf) {
  auto fields = maps(3);
  fields[0].seeds = 3;
  fields[1].seeds = 1;
  fields[0].name = std::string(200, 'w');
  const auto names = compose_comparison(fields, kTitle).names;
  EXPECT_TRUE(names[0].ends_with(", mean of 3 seeds")) << names[0];
  EXPECT_LT(names[0].size(), 100U);
  EXPECT_EQ(names[1], "variant 2, one seed");
  EXPECT_EQ(names[2], "variant 3");
}

// Variants differ at the end of their names or at the beginning; as many seeds of all are said once, in the
// foot.
TEST_F(ComparisonPictures, KeepBothEndsOfLongNames) {
  auto fields = maps(10);
  for (std::size_t k = 0; k < fields.size(); ++k) {
    fields[k].name = std::to_string(k) +
                     " passages, vibrated across the shoe, then oscillated about the axis at " +
                     std::to_string(k) + " Hz";
    fields[k].seeds = 3;
  }
  const auto picture = compose_comparison(fields, kTitle);
  keep(picture.image, "comparison_long_names.png");
  EXPECT_TRUE(has_white_border(picture.image, 8));
  for (std::size_t k = 0; k < fields.size(); ++k) {
    EXPECT_TRUE(picture.names[k].starts_with(std::to_string(k) + " passages")) << picture.names[k];
    EXPECT_TRUE(picture.names[k].ends_with(std::to_string(k) + " Hz")) << picture.names[k];
  }
}

TEST_F(ComparisonPictures, LookLikeTheirReference) {
  expect_like_reference(compose_comparison(maps(4), kTitle).image, "comparison.png");
}

// A variant whose powder is heaped higher does not stretch the others: equal heights stand level.
TEST_F(ComparisonPictures, PutEqualHeightsLevel) {
  auto fields = maps(2);
  const std::size_t columns = fields[1].field.first.size();
  fields[1].field.second.pop_back();
  fields[1].field.value.resize(fields[1].field.value.size() - columns);
  const auto picture = compose_comparison(fields, kTitle);
  EXPECT_EQ(picture.plots[0].pixel(90, 10).y(), picture.plots[1].pixel(90, 10).y());
  const QPointF above = picture.plots[1].pixel(90, fields[0].field.second.back()) + QPointF(0, 4);
  EXPECT_EQ(pixel_at(picture.image, above), kNoValueColour);
  const FieldSampler sampler(fields[1].field);
  const auto colour = pixel_at(picture.image, picture.plots[1].pixel(90, 5.05));
  EXPECT_TRUE(close_to(
      colour, value_colour(sampler.at(90, 5.05), picture.bar.range.lower, picture.bar.range.upper), 6));
}

TEST_F(ComparisonPictures, TakeSectionsOfOtherCavities) {
  std::vector<ComparedField> fields = {{"fast", make_section().field}, {"slow", make_section().field}};
  const auto picture = compose_comparison(fields, kTitle);
  keep(picture.image, "comparison_sections.png");
  EXPECT_TRUE(has_white_border(picture.image, 8));
  EXPECT_THROW(compose_comparison({}, kTitle), std::runtime_error);
  fields[1].field.value.pop_back();
  EXPECT_THROW(compose_comparison(fields, kTitle), std::runtime_error);
}

TEST_F(ComparisonPictures, AreWrittenAsPng) {
  draw_comparison(file("comparison.png"), maps(3), kTitle);
  EXPECT_EQ(contents(file("comparison.png")).substr(0, 8), "\x89PNG\r\n\x1a\n");
}

}  // namespace
}  // namespace diefill::render::test
