// Tools, air, empty cavity and powder without value look different, and pictures say where they are.
#include "render/fields/field_places.h"

#include <set>

#include "process/results/places_without_value.h"
#include "render/fields/density_map.h"
#include "tests/render/fields/drawing_test.h"
#include "tests/render/synthetic_ring.h"

namespace diefill::render::test {
namespace {

using FieldPlaces = Drawing;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Strips over x of everything that a section can show, 4 mm wide each.
results::Field2D strips() {
  results::Field2D field{"solid fraction", "x", "mm", "z", "mm", {}, {}, {}, 1e-3};
  for (int i = 0; i <= 100; ++i) field.first.push_back(0.2 * i);
  for (int j = 0; j <= 50; ++j) field.second.push_back(-8 + 0.2 * j);
  for (const double z : field.second)
    for (const double x : field.first)
      field.value.push_back(x < 4    ? 0.3 + 0.01 * z
                            : x < 8  ? results::unvalued_powder()
                            : x < 12 ? results::inside_tool()
                                     : kNone);
  return field;
}

FieldStyle pocket() {
  FieldStyle style;
  style.in_cavity = [](double x, double z) { return x < 16 && z < 0; };
  style.fill_plane = 0;
  return style;
}

/// The colours within half a millimetre of a place.
std::set<QRgb> colours(const FieldPicture& picture, double x, double z) {
  std::set<QRgb> found;
  const QPoint from = picture.plot.pixel(x - 0.5, z + 0.5).toPoint(),
               to = picture.plot.pixel(x + 0.5, z - 0.5).toPoint();
  for (int row = from.y(); row < to.y(); ++row)
    for (int column = from.x(); column < to.x(); ++column) found.insert(picture.image.pixel(column, row));
  return found;
}

TEST_F(FieldPlaces, LookDifferentAndAreExplained) {
  const auto picture = compose_field(strips(), "Strips", "", kRangeFromData, pocket());
  keep(picture.image, "places.png");
  EXPECT_TRUE(has_white_border(picture.image, 8));
  const auto unvalued = colours(picture, 6, -4), tool = colours(picture, 10, -4),
             empty = colours(picture, 14, -4), air = colours(picture, 18, -4);
  EXPECT_EQ(air, (std::set<QRgb>{qRgb(255, 255, 255)}));
  EXPECT_EQ(empty.size(), 1U);
  EXPECT_GE(unvalued.size(), 2U);  // dotted
  EXPECT_GE(tool.size(), 2U);      // hatched
  std::set<QRgb> all;
  for (const auto& some : {unvalued, tool, empty, air}) all.insert(some.begin(), some.end());
  EXPECT_EQ(all.size(), unvalued.size() + tool.size() + empty.size() + air.size());
  EXPECT_EQ(colours(picture, 14, 1), air);  // above the fill plane
  // A legend of four entries stands in a line of its own.
  EXPECT_GT(ink(picture.image, {30, picture.image.height() - 112, picture.image.width() - 60, 30}), 2000);
}

/// Lines round a rectangle, as tool_outlines() gives them: one per side, the same way round.
std::vector<Outline> rectangle(double left, double right, double bottom, double top) {
  const std::vector<Eigen::Vector2d> corners = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
  std::vector<Outline> lines;
  for (std::size_t k = 0; k < 4; ++k) lines.push_back({corners[k], corners[(k + 1) % 4]});
  return lines;
}

TEST_F(FieldPlaces, ToolsEndAtTheirOutlinesAndNotAtNodes) {
  FieldStyle style = pocket();
  // Two tools that overlap, and end beyond and before the nodes that know of them.
  auto outlines = rectangle(7.5, 10, -9, -0.05);
  for (const auto& line : rectangle(9, 12.5, -9, -0.05)) outlines.push_back(line);
  style.tool_levels = {outlines};
  const auto picture = compose_field(strips(), "Strips", "", kRangeFromData, style);
  keep(picture.image, "places_outlines.png");
  const auto is_tool = [&](double x, double z) {
    const QPointF at = picture.plot.pixel(x, z);
    std::set<QRgb> found;
    for (int column = -2; column <= 2; ++column)
      for (int row = -9; row <= 9; ++row)
        found.insert(picture.image.pixel(static_cast<int>(at.x()) + column, static_cast<int>(at.y()) + row));
    return found.contains(qRgb(96, 96, 96)) && found.contains(qRgb(196, 196, 196));
  };
  EXPECT_TRUE(is_tool(7.7, -4));
  EXPECT_FALSE(is_tool(7.3, -4));
  EXPECT_TRUE(is_tool(9.5, -4)) << "in both tools";
  EXPECT_TRUE(is_tool(12.3, -4));
  EXPECT_FALSE(is_tool(12.7, -4));
  EXPECT_FALSE(is_tool(12.3, 0.5)) << "above the tool";
}

TEST_F(FieldPlaces, FillPlaneIsALineWithItsName) {
  auto field = strips();
  const auto with = compose_field(field, "Strips", "", kRangeFromData, pocket());
  const QPointF line = with.plot.pixel(18, 0);
  int red = 0;
  for (int column = 0; column < 60; ++column) {
    const QRgb colour =
        with.image.pixel(static_cast<int>(with.plot.rect.left()) + 20 + column, static_cast<int>(line.y()));
    red += qRed(colour) > 150 && qGreen(colour) < 60;
  }
  EXPECT_GT(red, 10);
  const QRect label(static_cast<int>(with.plot.rect.right()) - 130, static_cast<int>(line.y()) - 34, 120, 28);
  EXPECT_GT(ink(with.image, label), 200);
}

TEST_F(FieldPlaces, PowderIsDrawnWhereItsValueIsNotKnown) {
  auto map = make_map();
  for (double& value : map.value) value = std::isnan(value) ? value : results::unvalued_powder();
  FieldStyle style;
  add_map_places(style, make_ring(), map);
  const auto picture = compose_field(map, "Coarse grains", "", {0.3, 0.4}, style);
  keep(picture.image, "places_unvalued.png");
  const auto low = colours(picture, 90, 5);
  EXPECT_TRUE(low.contains(place_colour(Place::kUnvalued, picture.bar, 8, 8)));
  EXPECT_FALSE(low.contains(place_colour(Place::kEmptyCavity, picture.bar, 0, 0)));
  EXPECT_TRUE(colours(picture, 180, 17.5).contains(place_colour(Place::kEmptyCavity, picture.bar, 0, 0)));
}

TEST_F(FieldPlaces, SectionsTellWhereTheyAre) {
  results::SectionPlane plane{"", {0, 12e-3, -5e-3}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(section_text(plane), "section y = 12 mm");
  plane.normal = {0, -1, 0};
  EXPECT_EQ(section_text(plane), "section y = 12 mm");
  plane.name = "through the hub";
  EXPECT_EQ(section_text(plane), "section y = 12 mm (through the hub)");
  plane = {"section", {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(section_text(plane), "section z = 0 mm");
  plane.normal = Eigen::Vector3d(1, 1, 0).normalized();
  plane.origin = 5e-3 * plane.normal;
  EXPECT_EQ(section_text(plane), "section with normal (0.7071, 0.7071, 0), 5 mm from the origin along it");
}

TEST_F(FieldPlaces, FillPlaneOfASectionIsInItsOwnCoordinates) {
  const auto ring = make_ring();
  results::SectionPlane plane = ring.sections.front().plane;
  plane.origin.z() = -4e-3;
  FieldStyle style;
  add_section_places(style, ring, plane);
  EXPECT_NEAR(style.fill_plane, 1e3 * ring.cavity.upper_corner.z() + 4, 1e-9);
  EXPECT_TRUE(style.in_cavity(10, style.fill_plane - 1));
  EXPECT_FALSE(style.in_cavity(10, style.fill_plane + 1));
  EXPECT_FALSE(style.in_cavity(0, style.fill_plane - 1));  // the core is no cavity
}

}  // namespace
}  // namespace diefill::render::test
