// Stars and lines of one level stand out from the colours of a field and are explained.
#include "render/fields/field_marks.h"

#include "render/fields/density_map.h"
#include "tests/render/fields/drawing_test.h"

namespace diefill::render::test {
namespace {

using FieldMarks = Drawing;

/// A slope along the first coordinate, 0 to 10.
results::Field2D slope() {
  results::Field2D field;
  field.quantity = "misfit";
  field.first_name = "friction";
  field.second_name = "adhesion";
  field.second_unit = "J/m^2";
  for (int k = 0; k <= 10; ++k) field.first.push_back(k);
  for (int k = 0; k <= 6; ++k) field.second.push_back(k);
  for (std::size_t j = 0; j < field.second.size(); ++j)
    for (const double first : field.first) field.value.push_back(first);
  return field;
}

bool is_white(const Rgb& colour) {
  return close_to(colour, {255, 255, 255}, 12);
}

/// Whether there is white within `reach` pixels to the right of a place, after what is dark or coloured.
bool white_beside(const QImage& image, const QPointF& at, int reach) {
  for (int k = 1; k <= reach; ++k)
    if (is_white(pixel_at(image, at + QPointF(k, 0)))) return true;
  return false;
}

FieldStyle marked() {
  FieldStyle style;
  style.stars = {{{2, 3}, "best powder"}};
  style.level_lines = {{7.5, "edge of the powders that agree (90 %)"}};
  return style;
}

TEST_F(FieldMarks, AStarHasAWhiteOutlineOnEveryColour) {
  FieldStyle style = marked();
  for (const double first : {0.5, 5.0, 9.5}) {
    style.stars[0].place = {first, 3};
    const auto picture = compose_field(slope(), "Misfit", "", kRangeFromData, style);
    keep(picture.image, "field_marks.png");
    const QPointF at = picture.plot.pixel(first, 3);
    EXPECT_TRUE(close_to(pixel_at(picture.image, at), {213, 94, 0}, 6)) << first;
    EXPECT_TRUE(white_beside(picture.image, at, 24)) << first;
  }
}

TEST_F(FieldMarks, ALevelLineRunsWhereTheFieldHasTheLevel) {
  const auto picture = compose_field(slope(), "Misfit", "", kRangeFromData, marked());
  for (const double second : {0.5, 2.2, 5.7}) {
    const QPointF at = picture.plot.pixel(7.5, second);
    EXPECT_TRUE(close_to(pixel_at(picture.image, at), {0, 0, 0}, 40)) << second;
    EXPECT_TRUE(white_beside(picture.image, at, 6)) << second;
  }
  EXPECT_FALSE(close_to(pixel_at(picture.image, picture.plot.pixel(6.5, 2.2)), {0, 0, 0}, 40));
}

TEST_F(FieldMarks, AreExplainedInALegendAboveTheField) {
  const auto plain = compose_field(slope(), "Misfit", "", kRangeFromData);
  const auto picture = compose_field(slope(), "Misfit", "", kRangeFromData, marked());
  const double more = picture.plot.rect.top() - plain.plot.rect.top();
  EXPECT_NEAR(more, marks_legend_height(marked()), 1);
  EXPECT_EQ(marks_legend_height({}), 0);
  EXPECT_TRUE(has_white_border(picture.image, 8));
}

}  // namespace
}  // namespace diefill::render::test
