// A measured curve as a chart: fill level against azimuth and the like.
#include "render/charts/profile_axes.h"
#include "render/charts/variation_charts.h"
#include "render/fields/pictures.h"

namespace diefill::render {

void draw_profile(const std::filesystem::path& png, const results::Profile& profile, const std::string& title,
                  const std::string& subtitle) {
  Chart chart;
  chart.title = title;
  chart.subtitle = subtitle;
  set_profile_axes(chart, profile);
  chart.curves.push_back({"", profile.x, profile.y, profile_style(profile), {}});
  draw_chart(png, chart);
}

void draw_fill_level(const std::filesystem::path& png, const results::Profile& level, double depth,
                     const std::string& title, const std::string& subtitle) {
  Chart chart = fill_level_chart({{"", level}}, {depth}, subtitle);
  chart.title = title;
  chart.curves.front().style = profile_style(level);
  draw_chart(png, chart);
}

}  // namespace diefill::render
