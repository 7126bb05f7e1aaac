// What a section's picture says of its axes, and below them.
#include "render/fields/density_map.h"
#include "render/fields/field_places.h"
#include "tests/render/fields/drawing_test.h"
#include "tests/render/synthetic_ring.h"

namespace diefill::render::test {
namespace {

using SectionLabels = Drawing;

TEST_F(SectionLabels, OfObliqueSectionsStateTheirDirection) {
  results::SectionPlane plane = make_section().plane;
  FieldStyle straight, oblique;
  add_section_places(straight, make_ring(), plane);
  EXPECT_EQ(straight.first_label, "");
  plane.normal = Eigen::Vector3d(1, 1, 0).normalized();
  plane.first_axis = Eigen::Vector3d(1, -1, 0).normalized();
  plane.second_axis = Eigen::Vector3d::UnitZ();
  add_section_places(oblique, make_ring(), plane);
  EXPECT_EQ(oblique.first_label, "along (0.71, −0.71, 0.00)");
  EXPECT_EQ(oblique.second_label, "");
  const auto picture = compose_field(make_section().field, "", "", kRangeFromData, oblique);
  EXPECT_EQ(picture.plot.x.label.toStdString(), "Along (0.71, −0.71, 0.00) [mm]");
}

TEST_F(SectionLabels, ALongNoteTakesTwoLines) {
  FieldStyle style;
  style.note = "averaged";
  const auto one = compose_field(make_section().field, "", "", kRangeFromData, style);
  for (int k = 0; k < 6; ++k) style.note += ", compression positive";
  const auto two = compose_field(make_section().field, "", "", kRangeFromData, style);
  keep(two.image, "section_long_note.png");
  EXPECT_EQ(two.image.height(), one.image.height() + 32);
  EXPECT_TRUE(has_white_border(two.image, 8));
}

}  // namespace
}  // namespace diefill::render::test
