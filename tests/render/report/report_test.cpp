// Reports: escaping, self-contained pages, grouping of runs, critical shoe speed.
#include "render/report/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "render/report/comparison.h"
#include "render/report/figure_text.h"
#include "render/report/html.h"
#include "render/report/pdf.h"
#include "render/report/sections/critical_speed.h"
#include "render/report/sections/over_time.h"
#include "render/report/sections/run_sections.h"
#include "render/report/sections/strategies.h"
#include "render/report/sections/timeline.h"
#include "tests/render/fields/drawing_test.h"

namespace diefill::render::report {
namespace {

const double kNone = std::nan("");

Run run_at(const std::string& name, double speed, double fill_ratio, std::uint64_t seed = 1) {
  Run run;
  run.name = name;
  run.result.title = "Ring";
  run.result.powder_name = "Distaloy AE";
  run.result.seed = seed;
  run.result.strategy = "1 passage at " + std::to_string(speed) + " m/s";
  run.result.scene_text = "title = \"seed " + std::to_string(seed) + "\"\nseed = " + std::to_string(seed) +
                          "  # any\n[[step]]\nvelocity = \"" + std::to_string(speed) + " m/s\"\n";
  run.result.figures = {
      {"fill_ratio", fill_ratio}, {"shoe_speed_m_s", speed}, {"filled_mass_kg", 1e-3 * fill_ratio}};
  return run;
}

class ReportDrawing : public test::Drawing {};

TEST(HtmlReport, EscapesWhatMeansSomethingInHtml) {
  EXPECT_EQ(escaped("<script>alert(\"x\" & 'y')</script>"),
            "&lt;script&gt;alert(&quot;x&quot; &amp; &#39;y&#39;)&lt;/script&gt;");
  EXPECT_EQ(escaped("a\tb\nc\x01\x1b[0m"), "a\tb\nc[0m");
  EXPECT_EQ(escaped("\xff"), "\xEF\xBF\xBD");
  EXPECT_EQ(escaped("µ ± 日本"), "µ ± 日本");
}

TEST(HtmlReport, HoldsEveryBlockAndNeedsNothingElse) {
  Document document{"<title> & \"more\"", "sub", {}};
  document.sections.push_back({"One <b>", 1, {Paragraph{"plain"}, Paragraph{"remark", true}}});
  document.sections.push_back({"Two", 2, {Table{"caption", {"a", "b"}, {{"<c>", "1"}}, true}}});
  document.sections.push_back({"Three", 1, {Listing{"x < y\n  z"}, Figures{{{QByteArray("png"), "c\"'<"}}}}});
  const std::string page = html_page(document);
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_EQ(page.find("<c>"), std::string::npos);
  EXPECT_NE(page.find("<pre>x &lt; y\n  z</pre>"), std::string::npos);
  EXPECT_NE(page.find("alt=\"c&quot;&#39;&lt;\" src=\"data:image/png;base64,cG5n\""), std::string::npos);
  const std::regex reference("(src|href)=\"(?!data:|#)[^\"]*\"|https?:|url\\(|@import|<script");
  EXPECT_FALSE(std::regex_search(page, reference));
}

TEST_F(ReportDrawing, ChartsOverTimeAreThoseOfProbesAndOfAllZonesTogether) {
  results::FillResult result;
  EXPECT_TRUE(over_time_section(result).blocks.empty());
  const std::vector<std::string> columns = {"time", "mass", "share of mass", "solid fraction"};
  result.probes = {{"filled mass", {"time", "filled mass"}, {"s", "kg"}, {0, 0, 1, 0.001}},
                   {"zone upper", columns, {"s", "kg", "1", "1"}, {0, 0, 0, kNone, 1, 1e-3, 0.5, 0.3}},
                   {"zone lower", columns, {"s", "kg", "1", "1"}, {0, 0, 0, 0.2, 1, 1e-3, 0.5, 0.4}}};
  const Section section = over_time_section(result);
  ASSERT_EQ(section.blocks.size(), 1U);
  EXPECT_EQ(std::get<Figures>(section.blocks[0]).figures.size(), 2U);
}

TEST(ReportOverTime, AxesAreCalledByTheWordsThatTheColumnsShare) {
  EXPECT_EQ(common_words({"force x", "force y", "force z"}), "force");
  EXPECT_EQ(common_words({"mean level", "lowest level"}), "level");
  EXPECT_EQ(common_words({"filled mass"}), "filled mass");
  EXPECT_EQ(common_words({"kinetic", "potential"}), "value");
}

TEST(CriticalSpeed, FindsThePowerLawThatTheRunsFollow) {
  std::vector<double> speed = {0.1, 0.3, 0.4, 0.6}, ratio = {1.02};
  for (std::size_t n = 1; n < speed.size(); ++n) ratio.push_back(std::pow(0.25 / speed[n], 1.3));
  const auto critical = critical_speed(speed, ratio);
  EXPECT_NEAR(critical.speed, 0.25, 1e-12);
  EXPECT_NEAR(critical.exponent, 1.3, 1e-12);
  EXPECT_EQ(critical.points, 3);
}

TEST(CriticalSpeed, IsNotToldFromTooLittle) {
  EXPECT_TRUE(std::isnan(critical_speed({}, {}).speed));
  EXPECT_TRUE(std::isnan(critical_speed({0.1, 0.2}, {1.0, 0.9}).speed));    // one incomplete
  EXPECT_TRUE(std::isnan(critical_speed({0.2, 0.2}, {0.8, 0.9}).speed));    // one speed
  EXPECT_TRUE(std::isnan(critical_speed({0.1, 0.2}, {0.5, 0.6}).speed));    // rising
  EXPECT_TRUE(std::isnan(critical_speed({0.1, 0.2}, {kNone, 0.6}).speed));  // unknown
}

TEST(CriticalSpeed, HasAnIntervalFromResidualsOrFromTheScatterOverSeeds) {
  const auto exact =
      critical_speed({0.1, 0.3, 0.4, 0.6},
                     {1.02, std::pow(0.25 / 0.3, 1.3), std::pow(0.25 / 0.4, 1.3), std::pow(0.25 / 0.6, 1.3)});
  EXPECT_NEAR(exact.lower, 0.25, 1e-9);
  EXPECT_NEAR(exact.upper, 0.25, 1e-9);
  EXPECT_EQ(exact.fastest_full, 0.1);
  EXPECT_EQ(exact.slowest_incomplete, 0.3);
  const auto noisy = critical_speed({0.2, 0.3, 0.4, 0.6}, {0.93, 0.75, 0.62, 0.42});
  EXPECT_LT(noisy.lower, noisy.speed);
  EXPECT_GT(noisy.upper, noisy.speed);
  EXPECT_TRUE(std::isnan(critical_speed({0.2, 0.4}, {0.9, 0.6}).lower));
  // Two points: the zero is u1 + (u2 - u1) w1 / (w1 - w2), moved by the first alone as its derivative says.
  const double w1 = std::log(0.9), w2 = std::log(0.6), span = std::log(2.0);
  const auto seeds = critical_speed({0.2, 0.4}, {0.9, 0.6}, {0.009, 0});
  const double by_first = span * -w2 / ((w1 - w2) * (w1 - w2)) * 0.01;
  EXPECT_NEAR(std::log(seeds.upper / seeds.speed), 1.96 * by_first, 1e-9);
}

TEST(CriticalSpeed, IsNotExtrapolatedFarAndNeverInSilence) {
  const auto far = critical_speed({0.4, 0.8}, {0.5, 0.4});
  EXPECT_TRUE(far.too_far);
  EXPECT_TRUE(std::isnan(far.speed));
  EXPECT_NE(description(far).find("No critical speed: the estimate is"), std::string::npos);
  const auto near = critical_speed({0.2, 0.4}, {0.8, 0.5});
  EXPECT_FALSE(near.too_far);
  EXPECT_GT(near.extrapolation, 1.2);
  EXPECT_NE(description(near).find("extrapolated 1.4 times beyond"), std::string::npos) << description(near);
  const auto among = critical_speed({0.1, 0.3, 0.4}, {0.99, 0.8, 0.6});
  EXPECT_EQ(among.extrapolation, 1);
  EXPECT_EQ(description(among).find("extrapolated"), std::string::npos);
  EXPECT_NE(description(among).find("full up to 0.1 m/s"), std::string::npos) << description(among);
}

TEST(CriticalSpeed, CountsADieOf98PerCentAsFull) {
  const auto critical = critical_speed({0.1, 0.2, 0.3}, {0.98, 0.9, 0.7});
  EXPECT_EQ(critical.points, 2);
  EXPECT_EQ(critical.fastest_full, 0.1);
}

TEST(Tables, LeaveOutColumnsThatNoRowHas) {
  Table table{"", {"a", "b", "c"}, {{"1", "–", "2"}, {"–", "–", "3"}}};
  leave_out_empty_columns(table);
  EXPECT_EQ(table.header, (std::vector<std::string>{"a", "c"}));
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"–", "3"}));
}

TEST(FigureText, LabelsUnitsAndDigitsAreThoseOfTheTable) {
  EXPECT_EQ(row_title("filled_mass_kg"), "Filled mass of model powder");
  EXPECT_EQ(column_title("fill_height_mm"), "Fill height [mm]");
  EXPECT_EQ(column_title("fill_ratio"), "Fill ratio");
  EXPECT_EQ(axis_title("fill_ratio"), "Fill ratio [–]");
  EXPECT_EQ(shown("fill_density_kg_m3", 1234.56), "1235 kg/m³");
  EXPECT_EQ(shown("expected_fill_density_kg_m3", 3012), "3.01 g/cm³");
  EXPECT_EQ(shown("solid_fraction_harmonic_1_azimuth_deg", 30), "30 °");
  EXPECT_EQ(shown("azimuthal_variation", 0.123), "12 %");
  Table table;
  add_figure(table, run_at("a", 0.1, 0.9).result, "filled_mass_kg");
  add_figure(table, run_at("a", 0.1, 0.9).result, "cycle_time_s");
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"Filled mass of model powder", "0.9 g"}));
}

TEST_F(ReportDrawing, EnergyLostIsNoNegativeShareAndNoSilence) {
  results::FillResult result;
  result.figures = {{"energy_balance_error", -0.097}, {"energy_error_limit", 0.05}};
  std::string page;
  Document document{"", "", {}};
  for (const auto& section : run_sections(result, 1))
    if (section.title == "Warnings" || section.title == "Stability margins")
      document.sections.push_back(section);
  page = html_page(document);
  EXPECT_EQ(page.find("-194"), std::string::npos);
  EXPECT_NE(page.find("±0.05"), std::string::npos);
  EXPECT_NE(page.find(", exceeded"), std::string::npos);
  EXPECT_EQ(page.find("The run reported no warnings"), std::string::npos);
}

TEST(Strategies, RunsThatDifferInTheSeedAloneAreOne) {
  const std::vector<report::Run> runs = {run_at("a", 0.1, 0.9, 1), run_at("b", 0.2, 0.6, 1),
                                         run_at("c", 0.1, 0.8, 2)};
  const auto strategies = strategies_of(runs);
  ASSERT_EQ(strategies.size(), 2U);
  EXPECT_EQ(strategies[0].runs.size(), 2U);
  const Scatter ratio = strategies[0].of("fill_ratio");
  EXPECT_NEAR(ratio.mean, 0.85, 1e-15);
  EXPECT_NEAR(ratio.deviation, 0.1 / std::sqrt(2.0), 1e-15);
  EXPECT_EQ(strategies[1].of("fill_ratio").count, 1);
  EXPECT_TRUE(std::isnan(strategies[1].of("unknown").mean));
  EXPECT_TRUE(series_over_speed(strategies));
}

TEST(Strategies, OtherToolsOrSettingsMakeAnotherStrategyAndNoSeries) {
  std::vector<report::Run> runs = {run_at("a", 0.1, 0.9), run_at("b", 0.2, 0.9)};
  runs[1].result.scene_text += "friction = 0.3 # \"other\"\n";
  EXPECT_FALSE(series_over_speed(strategies_of(runs)));
  runs[1] = runs[0];
  runs[1].result.tools.resize(1);
  runs[1].result.tools[0].mesh_hash = "other";
  EXPECT_EQ(strategies_of(runs).size(), 2U);
}

TEST(Strategies, CommentsAreNoDifferenceButMarksWithinQuotesAre) {
  EXPECT_EQ(effective_lines("# all\nseed = 3\n a = \"x # y\"  # z\n\ntitle = \"t\"\nseeds = 1\n"),
            (std::vector<std::string>{"a = \"x # y\"", "seeds = 1"}));
}

TEST_F(ReportDrawing, TimelineHasABarFromStartToEnd) {
  const QImage image = compose_timeline({{"", "settling until at rest", 0, 1}, {"shoe", "1 passage", 1, 2}});
  EXPECT_EQ(image.width(), 1600);
  std::vector<int> blue;  // columns of the moving stage's bar
  for (int x = 0; x < image.width(); ++x)
    for (int y = 0; y < image.height(); ++y)
      if (image.pixelColor(x, y) == QColor(59, 82, 139)) {
        blue.push_back(x);
        break;
      }
  std::vector<int> grey;
  for (int x = 0; x < image.width(); ++x)
    for (int y = 0; y < image.height(); ++y)
      if (image.pixelColor(x, y) == QColor(190, 196, 204)) {
        grey.push_back(x);
        break;
      }
  ASSERT_FALSE(blue.empty());
  ASSERT_FALSE(grey.empty());
  EXPECT_NEAR(blue.front(), grey.back(), 3);
  EXPECT_NEAR(blue.back() - blue.front(), grey.back() - grey.front(), 4);
  EXPECT_THROW(compose_timeline({}), std::invalid_argument);
}

TEST_F(ReportDrawing, TimelineLooksLikeItsReference) {
  expect_like_reference(compose_timeline({{"", "settling until at rest", 0, 0.2},
                                          {"shoe", "2 passages at 0.2 m/s", 0.2, 0.9},
                                          {"die", "vibration at 32 Hz, 1 mm", 0.3, 0.8},
                                          {"", "settling until at rest", 0.9, 1.1}}),
                        "timeline.png");
}

/// The table that a comparison opens with.
Table ranking_of(const std::vector<report::Run>& runs) {
  return std::get<Table>(comparison_sections(strategies_of(runs)).front().blocks.front());
}

TEST_F(ReportDrawing, EvenFillingRanksFirstWhereAllRunsTellHowEvenTheyAre) {
  std::vector<report::Run> runs = {run_at("full", 0.2, 0.9), run_at("even", 0.4, 0.5)};
  runs[0].result.figures["azimuthal_variation"] = 0.5;
  EXPECT_EQ(ranking_of(runs).rows.front().front(), runs[0].result.strategy);
  EXPECT_NE(ranking_of(runs).caption.find("By fill ratio"), std::string::npos);
  runs[1].result.figures["azimuthal_variation"] = 0.1;
  EXPECT_EQ(ranking_of(runs).rows.front().front(), runs[1].result.strategy);
  EXPECT_NE(ranking_of(runs).caption.find("By azimuthal variation"), std::string::npos);
}

TEST_F(ReportDrawing, FillDensityRanksWhereARunHasNoFillRatio) {
  std::vector<report::Run> runs = {run_at("cleared", 0.2, 0.9), run_at("other", 0.4, 0.5)};
  runs[0].result.figures.erase("fill_ratio");
  runs[0].result.figures["fill_density_kg_m3"] = 1500;
  runs[1].result.figures["fill_density_kg_m3"] = 1400;
  EXPECT_EQ(ranking_of(runs).rows.front().front(), runs[0].result.strategy);
  EXPECT_NE(ranking_of(runs).caption.find("By fill density"), std::string::npos);
}

TEST_F(ReportDrawing, SeveralRunsAreRankedByFillRatioWithTheCriticalSpeed) {
  const std::vector<report::Run> runs = {run_at("fast", 0.4, 0.5), run_at("slow", 0.2, 1.0 / std::sqrt(2.0))};
  const auto sections = comparison_sections(strategies_of(runs));
  EXPECT_EQ(ranking_of(runs).rows.front().front(), runs[1].result.strategy);
  bool reported = false;
  for (const auto& section : sections)
    if (section.title == "Critical shoe speed")
      reported = std::get<Paragraph>(section.blocks.front()).text.find("v_c = 0.1 m/s") != std::string::npos;
  EXPECT_TRUE(reported);
}

TEST_F(ReportDrawing, PdfIsAPdfWithItsText) {
  Document document{"A report", "sub", {}};
  document.sections.push_back({"One", 1, {Table{"", {"a", "b"}, {{"c", "1"}}, true}, Listing{"x\ny"}}});
  const std::string pdf = pdf_pages(document);
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  EXPECT_NE(pdf.find("%%EOF"), std::string::npos);
}

TEST(ReportOfSeveralRuns, NeedsRuns) {
  EXPECT_THROW(report_of({}), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::render::report
