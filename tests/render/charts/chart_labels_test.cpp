// What charts say beside their curves: tick labels, notes, legends, levels to compare with.
#include <algorithm>
#include <cmath>
#include <limits>

#include "render/charts/chart_layout.h"
#include "render/charts/curve_painter.h"
#include "render/charts/variation_charts.h"
#include "render/fields/pictures.h"
#include "render/style/text.h"
#include "tests/render/fields/drawing_test.h"

namespace diefill::render::test {
namespace {

using ChartLabels = Drawing;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST_F(ChartLabels, OfNeighbouringTicksDoNotTouch) {
  PlotArea area;
  area.rect = QRectF(100, 0, 400, 300);
  area.x.range = {-0.5, 3.5};
  area.x.ticks = {{0, 1, 2, 3}, {"2.82 mm (base)", "step.1.velocity = \"0.2 m/s\"", "", "1 mm"}};
  const TickTexts texts = x_tick_texts(area);
  ASSERT_EQ(texts.labels.size(), 4U);
  for (const QString& label : texts.labels) EXPECT_LT(text_width(label, text_font(texts.pixels)), 100);
  EXPECT_TRUE(texts.labels[2].isEmpty());
  area.x.ticks = {{0, 1, 2, 3}, {"0", "1", "2", "3"}};
  EXPECT_EQ(x_tick_texts(area).pixels, kTickPixels);
  EXPECT_EQ(x_tick_texts(area).labels[1], QStringLiteral("1"));
}

TEST_F(ChartLabels, NotesStayOnThePicture) {
  Chart chart;
  chart.curves = {{"", {0, 1}, {0, 1}, CurveStyle::kLine, {}}};
  for (int k = 0; k < 40; ++k) chart.note += "what is said of it ";
  const auto picture = compose_chart(chart);
  keep(picture.image, "chart_long_note.png");
  EXPECT_TRUE(has_white_border(picture.image, 8));
}

TEST_F(ChartLabels, APointBetweenTwoGapsIsADot) {
  Chart chart;
  chart.curves = {{"", {0, 1, 2, 3}, {1, kNone, 1, kNone}, CurveStyle::kLine, {}}};
  chart.x.lower = -1;
  chart.x.upper = 4;
  const auto picture = compose_chart(chart);
  const QColor colour = curve_colour(0);
  const Rgb expected{static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
                     static_cast<std::uint8_t>(colour.blue())};
  for (const double x : {0.0, 2.0})
    EXPECT_TRUE(close_to(pixel_at(picture.image, picture.plot.pixel(x, 1)), expected, 3)) << x;
}

TEST_F(ChartLabels, SayThatThereAreNoValues) {
  Chart chart;
  chart.curves = {{"none", {0, 1}, {kNone, kNone}, CurveStyle::kLine, {}}};
  const auto middle = [](const ChartPicture& picture) {
    QRect words(0, 0, 160, 40);
    words.moveCenter(picture.plot.rect.center().toPoint());
    return ink(picture.image, words);
  };
  const int without = middle(compose_chart(chart));
  chart.curves = {{"some", {0, 1}, {0, 0}, CurveStyle::kLine, {}}};
  chart.y.upper = 1;
  chart.y.lower = 0;
  EXPECT_GT(without, middle(compose_chart(chart)) + 200);
}

TEST_F(ChartLabels, OfASlopingReferenceAreNoLevelDashes) {
  Chart chart;
  chart.x.lower = chart.y.lower = 0;
  chart.x.upper = chart.y.upper = 4;
  chart.curves = {{"equal", {1.1, 3}, {1.1, 3}, CurveStyle::kReference, {}}};
  const auto picture = compose_chart(chart);
  const QPointF beside = picture.plot.pixel(1.1, 1.1) + QPointF(-12, 0);
  EXPECT_TRUE(close_to(pixel_at(picture.image, beside), {255, 255, 255}, 3));
  chart.curves[0].y = {1.1, 1.1};
  EXPECT_FALSE(close_to(pixel_at(compose_chart(chart).image, beside), {255, 255, 255}, 3));
}

TEST_F(ChartLabels, CountsBeginAtTheEdgeOfTheirFirstBar) {
  results::Histogram counts, fractions;
  counts.middle = {0, 1, 2};
  fractions.middle = {0.305, 0.315, 0.325};
  counts.share = fractions.share = {0.2, 0.5, 0.3};
  EXPECT_EQ(histogram_chart({{"", counts}}, "", "").x.lower, -0.5);
  EXPECT_TRUE(std::isnan(histogram_chart({{"", fractions}}, "", "").x.lower));
}

TEST_F(ChartLabels, EachDepthHasItsFillPlane) {
  const results::Profile level{"fill level", "mm", "azimuth", "deg", {10, 120, 350}, {9, 8, 9}};
  const auto planes_of = [&](const std::vector<double>& depths) {
    std::vector<std::string> names;
    for (const Curve& curve : fill_level_chart({{"flat", level}, {"deep", level}}, depths, "").curves)
      if (curve.style == CurveStyle::kReference)
        names.push_back(curve.name + QString(" %1").arg(curve.y[0]).toStdString());
    return names;
  };
  EXPECT_EQ(planes_of({10, 10}), (std::vector<std::string>{"fill plane 10"}));
  EXPECT_EQ(planes_of({10, 20}),
            (std::vector<std::string>{"fill plane of flat 10", "fill plane of deep 20"}));
}

TEST_F(ChartLabels, TheFillLevelOfARunIsDrawnWithTheFillPlane) {
  const results::Profile level{"fill level", "mm", "azimuth", "deg", {10, 120, 350}, {2, 3, 2}};
  draw_profile(file("alone.png"), level, "", "");
  draw_fill_level(file("with_plane.png"), level, 10, "", "");
  const auto greyest_row = [&](const std::string& name) {
    const QImage image(QString::fromStdString(file(name).string()));
    int most = 0;
    for (int row = 0; row < image.height(); ++row) {
      int count = 0;
      for (int column = 0; column < image.width(); ++column)
        count += close_to(pixel_at(image, QPointF(column, row)), {90, 90, 90}, 12);
      most = std::max(most, count);
    }
    return most;
  };
  EXPECT_LT(greyest_row("alone.png"), 100);
  EXPECT_GT(greyest_row("with_plane.png"), 500);
}

TEST_F(ChartLabels, OfBandsStandPlusAndMinusInOneSign) {
  results::SpreadProfile profile;
  profile.mean = {"solid fraction", "1", "height", "mm", {1, 2}, {0.3, 0.3}};
  profile.spread = {0.01, 0.01};
  EXPECT_NE(spread_chart({{"", profile}}, "", "").note.find("±"), std::string::npos);
}

}  // namespace
}  // namespace diefill::render::test
