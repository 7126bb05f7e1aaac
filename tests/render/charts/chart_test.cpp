#include "render/charts/chart.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "render/charts/chart_layout.h"
#include "render/charts/curve_painter.h"
#include "render/charts/variation_charts.h"
#include "render/fields/pictures.h"
#include "tests/render/fields/drawing_test.h"
#include "tests/render/synthetic_ring.h"

namespace diefill::render::test {
namespace {

using ChartTest = Drawing;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Rgb colour_of(std::size_t curve) {
  const QColor colour = curve_colour(curve);
  return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
          static_cast<std::uint8_t>(colour.blue())};
}

Curve parabola(const std::string& name, double scale, CurveStyle style) {
  Curve curve{name, {}, {}, style, {}};
  for (int k = 0; k <= 10; ++k) {
    curve.x.push_back(k);
    curve.y.push_back(scale * k * k);
  }
  return curve;
}

Chart collapse_chart() {
  Chart chart;
  chart.title = "Mass flow through a slit collapses on one curve";
  chart.subtitle = "four grain sizes, three slit widths";
  chart.x.label = "(D − 1.4 d) / d [–]";
  chart.y.label = "Mass flow per depth [kg/(m s)]";
  chart.x.logarithmic = chart.y.logarithmic = true;
  for (int k = 0; k < 5; ++k) {
    Curve curve{"d = " + std::to_string(k + 1) + " mm", {}, {}, CurveStyle::kMarkers, {}};
    for (int j = 1; j < 12; ++j) {
      curve.x.push_back((1 + 0.2 * k) * std::pow(1.6, j));
      curve.y.push_back(0.8 * std::pow(curve.x.back(), 1.5) * (1 + 0.05 * std::sin(7.0 * j + k)));
      curve.y_error.push_back(0.2 * curve.y.back());
    }
    chart.curves.push_back(curve);
  }
  chart.curves.push_back({"0.8 x^1.5", {1, 400}, {0.8, 0.8 * std::pow(400, 1.5)}, CurveStyle::kLine, {}});
  return chart;
}

TEST_F(ChartTest, CurvesPassThroughTheirPoints) {
  Chart chart;
  chart.x.label = "Time [s]";
  chart.y.label = "Mass [g]";
  chart.curves = {parabola("measured", 1, CurveStyle::kLineAndMarkers),
                  parabola("model", 0.6, CurveStyle::kMarkers)};
  const auto picture = compose_chart(chart);
  keep(picture.image, "chart.png");
  EXPECT_EQ(picture.image.size(), QSize(1600, 1000));
  EXPECT_TRUE(has_white_border(picture.image, 8));
  for (const std::size_t k : {3U, 5U, 8U}) {
    for (std::size_t curve = 0; curve < 2; ++curve) {
      const auto& data = chart.curves[curve];
      EXPECT_TRUE(
          close_to(pixel_at(picture.image, picture.plot.pixel(data.x[k], data.y[k])), colour_of(curve), 3));
    }
  }
}

TEST_F(ChartTest, ALineWithoutANameHasTheColourOfTheCurveBeforeIt) {
  Chart chart;
  chart.x.lower = 0, chart.x.upper = 10;
  chart.y.lower = 0, chart.y.upper = 10;
  chart.curves = {{"points", {1}, {1}, CurveStyle::kMarkers, {}},
                  {"", {0, 10}, {3, 3}, CurveStyle::kLine, {}},
                  {"others", {1}, {5}, CurveStyle::kMarkers, {}},
                  {"", {0, 10}, {7, 7}, CurveStyle::kLine, {}}};
  const auto picture = compose_chart(chart);
  const auto at = [&](double x, double y) { return pixel_at(picture.image, picture.plot.pixel(x, y)); };
  EXPECT_TRUE(close_to(at(1, 1), colour_of(0), 3));
  EXPECT_TRUE(close_to(at(0.1, 3), colour_of(0), 3));
  EXPECT_TRUE(close_to(at(1, 5), colour_of(1), 3));
  EXPECT_TRUE(close_to(at(0.1, 7), colour_of(1), 3));
}

TEST_F(ChartTest, LongLegendsStandCloserAndInSmallerType) {
  constexpr double kWidth = 1400, kRow = 42;
  const auto height_of = [](std::size_t names, const std::string& words, const std::string& first) {
    std::vector<Curve> curves(names, {words, {}, {}, CurveStyle::kLine, {}});
    curves[0].name = first;
    return draw_legend(nullptr, curves, 0, 0, kWidth);
  };
  const std::string name = "grains of 1 mm", long_name(60, 'm');
  EXPECT_EQ(height_of(3, long_name, name), 3 * kRow);
  EXPECT_EQ(height_of(4, name, name), kRow);
  // One long name leaves the others side by side; in columns of its width they would take twelve rows.
  EXPECT_LE(height_of(12, name, long_name), 5 * kRow);
  EXPECT_LT(height_of(24, "measured, friction 0.3, grains of 1 mm", name), 9 * kRow);
}

TEST_F(ChartTest, MissingValuesLeaveAGap) {
  Chart chart;
  chart.curves = {{"", {0, 1, 2, 3, 4}, {1, 1, kNone, 1, 1}, CurveStyle::kLine, {}}};
  chart.y.lower = 0;
  chart.y.upper = 3;
  chart.x.lower = -0.3;
  chart.x.upper = 4.3;
  const auto picture = compose_chart(chart);
  EXPECT_TRUE(close_to(pixel_at(picture.image, picture.plot.pixel(0.5, 1)), colour_of(0), 3));
  EXPECT_FALSE(close_to(pixel_at(picture.image, picture.plot.pixel(1.5, 1)), colour_of(0), 60));
  EXPECT_FALSE(close_to(pixel_at(picture.image, picture.plot.pixel(2.5, 1)), colour_of(0), 60));
}

TEST_F(ChartTest, LogarithmicAxesPlaceDecadesEvenly) {
  const auto picture = compose_chart(collapse_chart());
  keep(picture.image, "chart_log.png");
  EXPECT_TRUE(has_white_border(picture.image, 8));
  const auto x = [&](double value) { return picture.plot.pixel(value, 1).x(); };
  EXPECT_NEAR(x(100) - x(10), x(10) - x(1), 1e-6);
  EXPECT_NEAR(picture.plot.pixel(1, picture.plot.y.range.lower).y(), picture.plot.rect.bottom(), 1e-9);
}

TEST_F(ChartTest, LogarithmicAxisRefusesLimitsThatAreNotPositive) {
  Chart chart = collapse_chart();
  chart.y.lower = 0;
  EXPECT_THROW(compose_chart(chart), std::runtime_error);
}

TEST_F(ChartTest, HistogramStandsOnZero) {
  Chart chart;
  chart.title = "Solid fraction of the grains";
  chart.x.label = "Solid fraction [–]";
  chart.y.label = "Grains [–]";
  Curve bars{"1 passage", {}, {}, CurveStyle::kBars, {}};
  Curve more{"6 passages", {}, {}, CurveStyle::kBars, {}};
  for (int k = 0; k < 20; ++k) {
    bars.x.push_back(0.25 + 0.01 * k);
    bars.y.push_back(400 + 300 * std::exp(-std::pow((k - 8) / 4.0, 2)));
    more.x.push_back(bars.x.back());
    more.y.push_back(380 + 320 * std::exp(-std::pow((k - 12) / 3.0, 2)));
  }
  chart.curves = {bars, more};
  const auto picture = compose_chart(chart);
  keep(picture.image, "chart_histogram.png");
  EXPECT_DOUBLE_EQ(picture.plot.y.range.lower, 0);
  EXPECT_NE(pixel_at(picture.image, picture.plot.pixel(0.30, 10)), (Rgb{255, 255, 255}));
  EXPECT_LE(picture.plot.x.range.lower, 0.245);
}

TEST_F(ChartTest, LegendTakesRoomOnlyForNamedCurves) {
  Chart chart;
  chart.curves = {parabola("", 1, CurveStyle::kLine)};
  const double top = compose_chart(chart).plot.rect.top();
  chart.curves[0].name = "measured";
  const double with_legend = compose_chart(chart).plot.rect.top();
  EXPECT_GT(with_legend, top + 20);
  for (int k = 0; k < 12; ++k)
    chart.curves.push_back(parabola("a curve of a longer name " + std::to_string(k), k, CurveStyle::kLine));
  const auto crowded = compose_chart(chart);
  keep(crowded.image, "chart_crowded.png");
  EXPECT_GT(crowded.plot.rect.top(), with_legend + 60);
  EXPECT_TRUE(has_white_border(crowded.image, 8));
}

TEST_F(ChartTest, AxisRangesComeFromTheData) {
  const auto range = [](std::vector<double> values) { return axis_range({}, values, false); };
  EXPECT_DOUBLE_EQ(range({16, 17.9}).lower, 16);
  EXPECT_DOUBLE_EQ(range({1, 17.9}).lower, 0);
  EXPECT_DOUBLE_EQ(range({1, 17.9}).upper, 20);
  EXPECT_LT(range({5, 5}).lower, 5);
  EXPECT_GT(range({5, 5}).upper, 5);
  EXPECT_DOUBLE_EQ(range({kNone}).upper, 1);
  EXPECT_DOUBLE_EQ(axis_range({}, {16.2, 17.9}, true).lower, 0);
}

TEST_F(ChartTest, MarksKeepAMarginToTheFrame) {
  Chart chart;
  chart.curves = {{"", {0.3, 0.5, 0.8}, {100, 12, 1}, CurveStyle::kMarkers, {}}};
  for (const bool logarithmic : {false, true}) {
    chart.y.logarithmic = logarithmic;
    const auto picture = compose_chart(chart);
    keep(picture.image, logarithmic ? "chart_margin_log.png" : "chart_margin.png");
    const QRectF& rect = picture.plot.rect;
    const QRectF inside = rect.adjusted(0.04 * rect.width(), 0.04 * rect.height(), -0.04 * rect.width(),
                                        logarithmic ? -0.04 * rect.height() : 0);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_TRUE(inside.contains(picture.plot.pixel(chart.curves[0].x[k], chart.curves[0].y[k]))) << k;
    EXPECT_LT(picture.plot.x.range.upper, 0.9);
  }
}

// Marks up to a round number: a twentieth of the axis, and not the next round number as well.
TEST_F(ChartTest, MarksGetOneMarginAndLinesARoundNumber) {
  Chart chart;
  chart.curves = {{"", {0, 1, 2}, {0, 4, 10}, CurveStyle::kMarkers, {}}};
  EXPECT_NEAR(compose_chart(chart).plot.y.range.upper, 10.5, 1e-9);
  chart.curves[0].style = CurveStyle::kLine;
  EXPECT_GE(compose_chart(chart).plot.y.range.upper, 10.2);
  EXPECT_EQ(compose_chart(chart).plot.x.range.upper, 2);
  // Each keeps its own where there are both.
  chart.curves.push_back({"", {0, 1}, {0, 1}, CurveStyle::kMarkers, {}});
  EXPECT_GE(compose_chart(chart).plot.y.range.upper, 10.2);
}

TEST_F(ChartTest, ReferencesAreGreyAndTakeNoColourOfTheData) {
  Chart chart;
  chart.curves = {parabola("limit", 1, CurveStyle::kReference), parabola("model", 0.6, CurveStyle::kMarkers)};
  chart.curves[0].y[4] = kNone;  // no line joins the point before it
  chart.curves[0].y[2] = kNone;
  const auto picture = compose_chart(chart);
  keep(picture.image, "chart_reference.png");
  const auto at = [&](std::size_t curve, std::size_t k) {
    return pixel_at(picture.image, picture.plot.pixel(chart.curves[curve].x[k], chart.curves[curve].y[k]));
  };
  for (const std::size_t k : {3U, 8U}) EXPECT_TRUE(close_to(at(0, k), {90, 90, 90}, 3)) << k;
  EXPECT_TRUE(close_to(at(1, 8), colour_of(0), 3));
}

// A band of the picture just beyond one side of the data rectangle, clear of the frame's own line.
QRect beyond_right(const QRectF& frame) {
  return {static_cast<int>(frame.right()) + 4, static_cast<int>(frame.top()), 24,
          static_cast<int>(frame.height())};
}

QRect beyond_top(const QRectF& frame) {
  return {static_cast<int>(frame.left()), static_cast<int>(frame.top()) - 11, static_cast<int>(frame.width()),
          8};
}

TEST_F(ChartTest, CurvesEndAtTheFrame) {
  for (const CurveStyle style : {CurveStyle::kLine, CurveStyle::kLineAndMarkers, CurveStyle::kMarkers,
                                 CurveStyle::kBars, CurveStyle::kReference}) {
    Chart chart;
    chart.x = {.label = "x", .lower = 0, .upper = 5.1};
    chart.y = {.label = "y", .lower = 0, .upper = 24.5};
    chart.curves = {parabola("", 1, style), {"", {0, 10}, {12, 12}, style, {}}};
    for (Curve& curve : chart.curves) curve.y_error = curve.band = std::vector<double>(curve.y.size(), 1.5);
    const auto picture = compose_chart(chart);
    keep(picture.image, "chart_frame_" + std::to_string(static_cast<int>(style)) + ".png");
    EXPECT_EQ(ink(picture.image, beyond_right(picture.plot.rect)), 0) << static_cast<int>(style);
    EXPECT_EQ(ink(picture.image, beyond_top(picture.plot.rect)), 0) << static_cast<int>(style);
  }
}

TEST_F(ChartTest, ACurveAndAMarkOnTheFrameAreWhole) {
  Chart chart;
  chart.x = {.label = "x", .lower = 0, .upper = 4};
  chart.y = {.label = "y", .lower = 0, .upper = 1};
  chart.curves = {{"", {0, 4}, {1, 1}, CurveStyle::kLine, {}}, {"", {4}, {0.5}, CurveStyle::kMarkers, {}}};
  const auto picture = compose_chart(chart);
  keep(picture.image, "chart_on_the_frame.png");
  const QPointF line = picture.plot.pixel(2, 1), mark = picture.plot.pixel(4, 0.5);
  EXPECT_TRUE(close_to(pixel_at(picture.image, line - QPointF(0, 1.5)), colour_of(0), 3));
  EXPECT_TRUE(close_to(pixel_at(picture.image, mark + QPointF(4, 0)), colour_of(1), 3));
}

TEST_F(ChartTest, TheFillPlaneIsAReferenceAcrossTheFillLevels) {
  const results::Profile along{"fill level", "mm", "distance", "mm", {1, 2, 3}, {9, 8, 9}},
      round{"fill level", "mm", "azimuth", "deg", {10, 120, 350}, {9, 8, 9}};
  for (const auto& [profile, from, to] : {std::tuple{along, 1, 3}, std::tuple{round, 0, 360}}) {
    const Chart chart = fill_level_chart({{"", profile}}, {10}, "");
    const Curve& plane = chart.curves.back();
    EXPECT_EQ(plane.name, "fill plane");
    EXPECT_EQ(plane.style, CurveStyle::kReference);
    EXPECT_EQ(plane.x, (std::vector<double>{static_cast<double>(from), static_cast<double>(to)}));
    EXPECT_EQ(plane.y, (std::vector<double>{10, 10}));
  }
}

TEST_F(ChartTest, ANaturalZeroAndGivenLimitsAreKept) {
  Chart chart;
  chart.curves = {parabola("", 1, CurveStyle::kMarkers)};
  const auto from_zero = compose_chart(chart).plot;
  EXPECT_EQ(from_zero.x.range.lower, 0);
  EXPECT_EQ(from_zero.y.range.lower, 0);
  EXPECT_GT(from_zero.x.range.upper, 10.4);
  // Positive values next to zero do not make the axis negative.
  chart.curves = {{"", {0.01, 1}, {0.01, 1}, CurveStyle::kMarkers, {}}};
  EXPECT_EQ(compose_chart(chart).plot.x.range.lower, 0);
  EXPECT_EQ(compose_chart(chart).plot.y.range.lower, 0);
  chart.x.lower = 0.01;
  chart.x.upper = 1;
  EXPECT_EQ(compose_chart(chart).plot.x.range.lower, 0.01);
  EXPECT_EQ(compose_chart(chart).plot.x.range.upper, 1);
}

TEST_F(ChartTest, UnequalArraysAreRefusedByName) {
  Chart chart;
  chart.curves = {{"odd one", {1, 2, 3}, {1, 2}, CurveStyle::kLine, {}}};
  try {
    compose_chart(chart);
    FAIL() << "3 x and 2 y values";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("odd one"), std::string::npos);
  }
}

TEST_F(ChartTest, ProfileFileIsTheSameTwice) {
  const auto profile = make_ring().profiles.front();
  for (const char* name : {"one.png", "two.png"})
    draw_profile(file(name), profile, "1 passage at 0.2 m/s", "Dist. AE, grain size 1.88 mm");
  EXPECT_EQ(contents(file("one.png")), contents(file("two.png")));
  const QImage image(QString::fromStdString(file("one.png").string()));
  keep(image, "fill_level.png");
  EXPECT_EQ(image.size(), QSize(1600, 1000));
  EXPECT_TRUE(has_white_border(image, 8));
}

TEST_F(ChartTest, AxesInDegreesHaveTicksAtPartsOfAFullTurn) {
  Chart chart;
  chart.y.label = "Fill level [mm]";
  chart.curves = {{"level", {4, 90, 200, 356}, {1, 2, 3, 4}, CurveStyle::kLine, {}}};
  for (const char* unit : {"[deg]", "[°]"}) {
    chart.x.label = std::string("Azimuth ") + unit;
    const PlotArea plot = compose_chart(chart).plot;
    EXPECT_DOUBLE_EQ(plot.x.range.upper, 360);
    EXPECT_EQ(plot.x.ticks.at, (std::vector<double>{0, 45, 90, 135, 180, 225, 270, 315, 360}));
    EXPECT_EQ(plot.x.label, QStringLiteral("Azimuth [°]"));
  }
  chart.x.label = "Time [s]";
  EXPECT_DOUBLE_EQ(compose_chart(chart).plot.x.ticks.at.at(1), 50);
}

}  // namespace
}  // namespace diefill::render::test
