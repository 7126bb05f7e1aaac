#include "render/charts/tradeoff_chart.h"

#include <cmath>
#include <stdexcept>

#include "render/charts/tradeoff_marks.h"
#include "render/style/label_placement.h"
#include "tests/render/fields/drawing_test.h"

namespace diefill::render::test {
namespace {

using TradeoffCharts = Drawing;
using results::Tradeoff;
using results::TradeoffPoint;

TradeoffPoint point(const std::string& label, double cost, double error) {
  TradeoffPoint made;
  made.name = made.label = label;
  made.core_seconds = cost;
  made.error = error;
  made.seeds = 2;
  made.values = {{10 * (1 + error), 0.05, 2, error}, {0.33, 0.002, 2, 0.5 * error}};
  return made;
}

/// Fourteen settings, most of them crowded round the base.
Tradeoff crowded() {
  Tradeoff tradeoff;
  tradeoff.title = "Slit of 10 mm, one passage at 0.4 m/s";
  tradeoff.advice =
      "Take \"combined\": 14 times cheaper than \"d 1.41 mm\", error 2.4 %, within the tolerance.";
  tradeoff.quantities.resize(2);
  tradeoff.quantities[0].key = tradeoff.quantities[0].name = "filled mass";
  tradeoff.quantities[1].key = tradeoff.quantities[1].name = "mean solid fraction";
  for (auto& quantity : tradeoff.quantities) quantity.reference = 1;
  tradeoff.floor = 0.03;
  tradeoff.points = {point("base", 16, 0.02),           point("d 2.82 mm", 4.1, 0.21),
                     point("d 1.41 mm", 52, 0),         point("step 0.3", 10.5, 0.021),
                     point("step 0.4", 9.8, 0.024),     point("E~ 1 MPa", 9.9, 0.03),
                     point("wall R 0.3 mm", 9, 0.026),  point("wall spacing 1.6", 31, 0.012),
                     point("powder 5 mm", 9.5, 0.14),   point("skin 0.1 mm", 15.9, 0.019),
                     point("skin 0.3 mm", 16.2, 0.018), point("model A", 3.4, 0.45),
                     point("combined", 3.9, 0.024)};
  tradeoff.points[2].reference = tradeoff.points[2].pareto = true;
  tradeoff.points[12].recommended = tradeoff.points[12].pareto = true;
  tradeoff.points[11].pareto = tradeoff.points[7].pareto = tradeoff.points[10].pareto = true;
  tradeoff.parameters = {
      {"grain_diameter", "model grain diameter d", {1, 0, 2}, {"2.82 mm", "1.88 mm", "1.41 mm"}}};
  return tradeoff;
}

TEST_F(TradeoffCharts, LabelsStayApartFromOneAnotherAndFromMarks) {
  const auto picture = compose_tradeoff(crowded());
  keep(picture.image, "tradeoff.png");
  EXPECT_TRUE(has_white_border(picture.image, 8));
  // base, skin 0.1 and 0.3 mm lie on top of each other, and so do the four settings about 10 core s.
  ASSERT_GE(picture.labels.size(), 7U);
  ASSERT_LT(picture.labels.size(), 13U);
  for (std::size_t a = 0; a < picture.labels.size(); ++a) {
    EXPECT_TRUE(picture.plot.rect.contains(picture.labels[a])) << a;
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_FALSE(picture.labels[a].intersects(picture.labels[b])) << a << ' ' << b;
    for (const QPointF& mark : picture.places) EXPECT_FALSE(picture.labels[a].contains(mark)) << a;
  }
}

TEST_F(TradeoffCharts, LongNamesOfManySettingsStayOnThePicture) {
  Tradeoff tradeoff = crowded();
  tradeoff.points.clear();
  for (int k = 0; k < 10; ++k)
    tradeoff.points.push_back(point("shoe at 0.05 m/s, vibrated across its motion at " + std::to_string(k) +
                                        " Hz, then oscillated about the axis",
                                    4 + 9 * k * k, 0.02 * (k + 1)));
  tradeoff.points[0].reference = tradeoff.points[0].pareto = true;
  tradeoff.points[3].recommended = true;
  tradeoff.points[4].beyond = {"filled_mass"};
  for (int k = 5; k < 10; ++k) tradeoff.points[static_cast<std::size_t>(k)].reason = "energy grew";
  const auto picture = compose_tradeoff(tradeoff);
  keep(picture.image, "tradeoff_long_names.png");
  EXPECT_TRUE(has_white_border(picture.image, 8));
  for (const QRectF& label : picture.labels) EXPECT_TRUE(picture.plot.rect.contains(label));
}

TEST_F(TradeoffCharts, ALegendOfAllMarksTakesTwoRows) {
  Tradeoff tradeoff = crowded();
  const double one = draw_mark_legend(nullptr, 36, 100, 1528, tradeoff);
  tradeoff.points[1].beyond = {"filled_mass"};
  tradeoff.points[3].reason = "energy grew";
  EXPECT_EQ(draw_mark_legend(nullptr, 36, 100, 1528, tradeoff), 2 * one);
}

TEST_F(TradeoffCharts, AParameterWithOneSeedHasNoErrorBarsButAnAxis) {
  Tradeoff tradeoff = crowded();
  for (auto& one : tradeoff.points)
    for (auto& value : one.values) value.scatter = std::nan("");
  const auto axis = compose_parameter(tradeoff, tradeoff.parameters.front()).deviation.y.range;
  EXPECT_GE(axis.upper, 100 * (0.21 - 0.02) / 1.02);
  EXPECT_LE(axis.upper, 25);
}

TEST_F(TradeoffCharts, PointsStandAtTheirCostAndError) {
  const auto picture = compose_tradeoff(crowded());
  const QPointF coarse = picture.plot.pixel(4.1, 21);
  EXPECT_NEAR(picture.places[1].x(), coarse.x(), 1e-6);
  EXPECT_NEAR(picture.places[1].y(), coarse.y(), 1e-6);
  // No error at all has no place on a logarithmic axis: the lower edge.
  EXPECT_NEAR(picture.places[2].y(), picture.plot.rect.bottom(), 1e-6);
  // The chosen one's star is vermilion, those on the front are blue.
  EXPECT_TRUE(close_to(pixel_at(picture.image, picture.places[12]), {213, 94, 0}, 4));
  EXPECT_TRUE(close_to(pixel_at(picture.image, picture.places[11]), {0, 114, 178}, 4));
}

TEST_F(TradeoffCharts, PointsOnTopOfEachOtherShareALabel) {
  Tradeoff tradeoff = crowded();
  tradeoff.points = {point("base", 16, 0), point("alike", 16.01, 0), point("d 2.82 mm", 4.1, 0.21)};
  const auto picture = compose_tradeoff(tradeoff);
  ASSERT_EQ(picture.labels.size(), 2U);
  EXPECT_NEAR(picture.labels[0].height(), 2 * picture.labels[1].height(), 1e-9);
}

TEST_F(TradeoffCharts, WhatIsBeyondTheScatterOfAQuantityIsHollow) {
  Tradeoff tradeoff = crowded();
  tradeoff.points[1].beyond = {"filled_mass"};
  const auto picture = compose_tradeoff(tradeoff);
  EXPECT_TRUE(close_to(pixel_at(picture.image, picture.places[1]), {255, 255, 255}, 2));
  EXPECT_FALSE(close_to(pixel_at(picture.image, picture.places[3]), {255, 255, 255}, 2));
}

TEST_F(TradeoffCharts, WhatFailedWithASeedIsACross) {
  Tradeoff tradeoff = crowded();
  tradeoff.points[1].reason = "energy grew by 6 %";
  const auto picture = compose_tradeoff(tradeoff);
  keep(picture.image, "tradeoff_failed.png");
  const QPointF at = picture.places[1];
  EXPECT_TRUE(close_to(pixel_at(picture.image, at), {90, 90, 90}, 4));
  EXPECT_TRUE(close_to(pixel_at(picture.image, at + QPointF(6, 6)), {90, 90, 90}, 30));
  EXPECT_TRUE(close_to(pixel_at(picture.image, at + QPointF(0, -8)), {255, 255, 255}, 2));
}

TEST_F(TradeoffCharts, TheFloorIsShadedAndNothingAboveIt) {
  const auto picture = compose_tradeoff(crowded());
  const double left = picture.plot.rect.left() + 4;
  const double floor = picture.plot.pixel(16, 3).y();
  EXPECT_TRUE(close_to(pixel_at(picture.image, {left, floor + 6}), {232, 232, 226}, 2));
  EXPECT_TRUE(close_to(pixel_at(picture.image, {left, floor - 6}), {255, 255, 255}, 2));
  Tradeoff unknown = crowded();
  unknown.floor = std::nan("");
  const auto plain = compose_tradeoff(unknown);
  EXPECT_TRUE(close_to(pixel_at(plain.image, {plain.plot.rect.left() + 4, plain.plot.rect.bottom() - 6}),
                       {255, 255, 255}, 2));
}

TEST_F(TradeoffCharts, SettingsWithoutResultAreLeftOut) {
  Tradeoff tradeoff = crowded();
  tradeoff.points[1].error = std::nan("");
  tradeoff.points[3].core_seconds = std::nan("");
  EXPECT_EQ(compose_tradeoff(tradeoff).points.size(), 11U);
  tradeoff.points.clear();
  EXPECT_THROW(compose_tradeoff(tradeoff), std::runtime_error);
  Tradeoff single = crowded();
  single.points = {single.points[2]};
  EXPECT_EQ(compose_tradeoff(single).points.size(), 1U);
}

TEST_F(TradeoffCharts, AParametersChartHasACategoryForEachValue) {
  const Tradeoff tradeoff = crowded();
  const auto picture = compose_parameter(tradeoff, tradeoff.parameters.front());
  keep(picture.image, "parameter_grain_diameter.png");
  EXPECT_TRUE(has_white_border(picture.image, 8));
  EXPECT_EQ(picture.cost.x.ticks.labels, (std::vector<std::string>{"2.82 mm", "1.88 mm (base)", "1.41 mm"}));
  EXPECT_GE(picture.cost.y.range.upper, 52);
  EXPECT_EQ(picture.cost.y.range.lower, 0);
  EXPECT_GE(picture.deviation.y.range.upper, 100 * (0.21 - 0.02) / 1.02);
  draw_parameter(file("parameter.png"), tradeoff, tradeoff.parameters.front());
  EXPECT_EQ(contents(file("parameter.png")).substr(0, 8), "\x89PNG\r\n\x1a\n");
}

TEST_F(TradeoffCharts, LookLikeTheirReferences) {
  const Tradeoff tradeoff = crowded();
  expect_like_reference(compose_tradeoff(tradeoff).image, "tradeoff.png");
  expect_like_reference(compose_parameter(tradeoff, tradeoff.parameters.front()).image, "parameter.png");
}

TEST(Labels, GoBesideTheirPointsWhereThereIsRoom) {
  const QRectF area(0, 0, 400, 300);
  const auto labels = place_labels({{{200, 150}, {80, 20}, 10}}, area);
  EXPECT_LT(std::abs(labels[0].center().x() - 200), 60 + 40);
  EXPECT_FALSE(labels[0].contains(QPointF(200, 150)));
  // At the right edge there is no room on the right.
  EXPECT_LT(place_labels({{{395, 150}, {80, 20}, 10}}, area)[0].right(), 400);
}

TEST(Labels, KeepOffTheLeadersOfOthers) {
  // A column of points so close that labels must stand apart from them.
  std::vector<LabelledPoint> points;
  for (int k = 0; k < 6; ++k) points.push_back({{300, 150.0 + 8 * k}, {120, 24}, 10});
  const auto labels = place_labels(points, QRectF(0, 0, 600, 400));
  for (std::size_t a = 0; a < points.size(); ++a) {
    const QLineF leader = leader_of(labels[a], points[a]);
    EXPECT_GE(QLineF(points[a].at, leader.p1()).length(), 10 - 1e-9) << a;
    for (std::size_t b = 0; b < points.size(); ++b)
      for (int n = 0; n <= 50 && a != b; ++n)
        EXPECT_FALSE(labels[b].contains(leader.pointAt(n / 50.0))) << a << ' ' << b;
  }
}

TEST(Labels, KeepOffWhatIsTaken) {
  const QRectF area(0, 0, 400, 300), taken(210, 100, 190, 100);
  const auto labels = place_labels({{{200, 150}, {80, 20}, 8}}, area, {taken});
  EXPECT_FALSE(labels[0].intersects(taken));
}

}  // namespace
}  // namespace diefill::render::test
