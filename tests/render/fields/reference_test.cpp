// Pictures of fields, charts and views compared with stored ones.
#include "render/charts/chart_layout.h"
#include "render/charts/variation_charts.h"
#include "render/fields/arrow_map.h"
#include "render/fields/density_map.h"
#include "render/fields/difference_map.h"
#include "render/fields/field_places.h"
#include "render/scene3d/snapshot.h"
#include "tests/render/fields/drawing_test.h"
#include "tests/render/synthetic_ring.h"
#include "tests/support/image_compare.h"

namespace diefill::render::test {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

using Reference = Drawing;

results::ArrowField swirl() {
  results::ArrowField arrows;
  arrows.field = make_map();
  arrows.unit = "mm";
  for (std::size_t j = 0; j < arrows.field.second.size(); ++j)
    for (std::size_t i = 0; i < arrows.field.first.size(); ++i) {
      const double height = arrows.field.second[j];
      double& value = arrows.field.value[j * arrows.field.first.size() + i];
      if (!std::isnan(value)) value = 0.02 * height;
      if (std::isnan(value) || i % 4 != 2 || j % 5 != 2) continue;
      const double angle = arrows.field.first[i] * 3.14159265358979 / 180;
      arrows.arrows.push_back({arrows.field.first[i], height, 0.02 * height * std::cos(angle),
                               -0.02 * height * std::abs(std::sin(angle))});
    }
  return arrows;
}

results::Field2D change_map() {
  results::Field2D change = make_map();
  change.quantity = "change of solid fraction";
  for (std::size_t n = 0; n < change.value.size(); ++n) change.value[n] -= 0.34;
  return change;
}

results::SpreadProfile height_profile(double shift) {
  results::SpreadProfile profile{{"solid fraction", "1", "height", "mm", {}, {}}, {}};
  for (int k = 0; k <= 20; ++k) {
    profile.mean.x.push_back(k);
    profile.mean.y.push_back(k == 13 ? kNone : 0.36 + shift - 0.002 * k);
    profile.spread.push_back(k == 13 ? kNone : 0.004 + 0.0005 * k);
  }
  return profile;
}

TEST_F(Reference, MapWithMean) {
  FieldStyle style;
  style.mark_mean = true;
  style.outlines = {{{0, 19}, {360, 19}}};
  expect_like_reference(
      compose_field(make_map(), "1 passage at 0.2 m/s", "Dist. AE", {0.3, 0.4}, style).image, "map.png");
}

TEST_F(Reference, SectionWithToolOutlines) {
  FieldStyle style;
  auto section = make_section();
  section.plane.normal = {0, 1, 0};
  add_section_places(style, make_ring(), section.plane);
  EXPECT_GT(style.outlines.size(), 8U);
  expect_like_reference(compose_field(section.field, "Section", "y = 0", {0.3, 0.4}, style).image,
                        "section.png");
}

TEST_F(Reference, DifferenceAboutZero) {
  const auto picture = compose_difference(change_map(), "Passage 4 minus passage 2", "Dist. AE", kNone, {});
  EXPECT_DOUBLE_EQ(picture.bar.range.lower, -picture.bar.range.upper);
  expect_like_reference(picture.image, "difference.png");
}

TEST_F(Reference, DisplacementArrows) {
  expect_like_reference(
      compose_arrows(swirl(), "displacement", "Passages 3 to 6", "Dist. AE", kNone, {}).image,
      "displacement.png");
}

TEST_F(Reference, ProfilesWithBands) {
  expect_like_reference(
      compose_chart(
          spread_chart({{"one", height_profile(0)}, {"two", height_profile(0.01)}}, "Over height", ""))
          .image,
      "height_profile.png");
}

TEST(SpreadChart, SaysWhatTheMeanIsOver) {
  const auto note = [](const std::string& across) {
    return spread_chart({{"", height_profile(0)}}, "Over height", "", across).note;
  };
  EXPECT_NE(note("azimuth").find("Mean over azimuth"), std::string::npos);
  EXPECT_NE(note("the cross-section").find("Mean over the cross-section"), std::string::npos);
}

TEST_F(Reference, HistogramOfOneRun) {
  const results::Histogram histogram{
      "solid fraction", "1", {0.295, 0.305, 0.315, 0.325}, {0.1, 0.4, 0.35, 0.15}, 1000, 0.31, 0.009};
  expect_like_reference(compose_chart(histogram_chart({{"", histogram}}, "Grains", "Dist. AE")).image,
                        "histogram.png");
}

TEST_F(Reference, ViewsOfEveryLook) {
  const auto ring = make_ring();
  expect_like_reference(compose_snapshot(ring).image, "view_cut.png");
  ViewOptions options;
  options.camera = {0.6, 0.5};
  options.look.tools = ToolLook::kTranslucent;
  options.look.cut_powder = false;
  options.quantity = "height";
  options.unit = "mm";
  for (const auto& place : ring.powder.position) options.values.push_back(1e3 * place.z());
  expect_like_reference(compose_snapshot(ring, options).image, "view_translucent.png");
  options.look.tools = ToolLook::kHidden;
  options.look.ambient_occlusion = true;
  options.camera = {0, 1.5707963};
  expect_like_reference(compose_snapshot(ring, options).image, "view_top.png");
}

TEST_F(Reference, CompareToolTellsPicturesApart) {
  const QImage one = compose_difference(change_map(), "A", "", 0.05, {}).image;
  EXPECT_EQ(support::image_distance(one, one).mean, 0);
  const auto other = support::image_distance(one, compose_difference(change_map(), "A", "", 0.1, {}).image);
  EXPECT_GT(other.worst, 8);
  EXPECT_FALSE(std::isfinite(support::image_distance(one, compose_snapshot(make_ring()).image).mean));
}

TEST_F(Reference, TwiceThePixelsShowTheSame) {
  FieldStyle style;
  const auto once = compose_field(make_map(), "Map", "Dist. AE", {0.3, 0.4}, style).image;
  style.pixels = 2;
  const auto twice = compose_field(make_map(), "Map", "Dist. AE", {0.3, 0.4}, style).image;
  EXPECT_EQ(twice.width(), 2 * once.width());
  EXPECT_LT(support::image_distance(once, twice).mean, 0.5);
}

}  // namespace
}  // namespace diefill::render::test
