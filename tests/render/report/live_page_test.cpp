// Pages about work under way.
#include "render/report/live_page.h"

#include <gtest/gtest.h>

namespace diefill::render::report {
namespace {

LivePage some_page() {
  LivePage page;
  page.title = "<ring>";
  page.state = "running: 3 min left";
  page.share = 0.25;
  page.curves = {{"powder in the cavity", "g", {0, 1, 2}, {0, 5, 12}}};
  page.margins = {{"deepest overlap", 0.3, 0.6, false}, {"energy", 0.1, 0.05, true}};
  page.header = {"Run", "State"};
  page.rows = {{"slow & fast", "running"}, {"other", "waiting"}};
  page.links = {"slow/seed-1/live.html", ""};
  return page;
}

TEST(LivePage, ShowsItselfAnewUntilTheWorkIsOver) {
  LivePage page = some_page();
  EXPECT_NE(live_html(page).find("http-equiv=\"refresh\""), std::string::npos);
  page.over = true;
  EXPECT_EQ(live_html(page).find("http-equiv=\"refresh\""), std::string::npos);
}

TEST(LivePage, TellsProgressMarginsAndRuns) {
  const std::string html = live_html(some_page());
  EXPECT_NE(html.find("<title>25 % &lt;ring&gt;</title>"), std::string::npos);
  EXPECT_NE(html.find("width: 25%"), std::string::npos);
  EXPECT_NE(html.find("running: 3 min left"), std::string::npos);
  EXPECT_NE(html.find("number\">50 %"), std::string::npos);
  EXPECT_NE(html.find("exceeded\">200 %"), std::string::npos);
  EXPECT_NE(html.find("<a href=\"slow/seed-1/live.html\">slow &amp; fast</a>"), std::string::npos);
  EXPECT_EQ(html.find("<script"), std::string::npos);
}

TEST(LivePage, DrawsCurvesToTheScaleOfTheirAxes) {
  LivePage page = some_page();
  const std::string html = live_html(page);
  // 0 to 2 s over 384, 0 to 15 g over 164: 5 g lie 54.7 above the lower axis at 192, 12 g 131.2.
  EXPECT_NE(html.find("d=\"M62 192L254 137.3L446 60.8\""), std::string::npos)
      << html.substr(html.find("<path fill"));
  page.curves[0] = {"nothing yet", "g", {}, {}};
  EXPECT_NE(live_html(page).find("nothing yet [g]"), std::string::npos);
}

}  // namespace
}  // namespace diefill::render::report
