// A measured curve as a chart: fill level against azimuth and the like.
#include "render/charts/chart.h"
#include "render/fields/pictures.h"
#include "render/style/axes.h"
#include "render/style/text.h"

namespace diefill::render {

void draw_profile(const std::filesystem::path& png, const results::Profile& profile, const std::string& title,
                  const std::string& subtitle) {
  Chart chart;
  chart.title = title;
  chart.subtitle = subtitle;
  chart.x.label = axis_label(profile.x_name, profile.x_unit).toStdString();
  if (profile.x_name == "height")
    chart.x.label = axis_label("height above cavity floor", profile.x_unit).toStdString();
  chart.y.label = axis_label(profile.quantity, profile.unit).toStdString();
  chart.curves.push_back({"", profile.x, profile.y, CurveStyle::kLine, {}});
  if (profile.x_name == "azimuth") {
    chart.x.lower = 0;
    chart.x.upper = 360;
    chart.x.degrees = true;
    for (const auto& marker : shoe_markers()) chart.markers.push_back({marker.x, marker.text.toStdString()});
  }
  draw_chart(png, chart);
}

}  // namespace diefill::render
