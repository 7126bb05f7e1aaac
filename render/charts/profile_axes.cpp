#include "render/charts/profile_axes.h"

#include <algorithm>
#include <cmath>

#include "render/style/axes.h"
#include "render/style/text.h"

namespace diefill::render {

void set_profile_axes(Chart& chart, const results::Profile& profile) {
  chart.x.label = axis_label(profile.x_name, profile.x_unit).toStdString();
  chart.y.label = axis_label(profile.quantity, profile.unit).toStdString();
  if (profile.x_name == "height")
    chart.x.label = axis_label("height above cavity floor", profile.x_unit).toStdString();
  if (profile.x_name != "azimuth") return;
  chart.x.lower = 0;
  chart.x.upper = 360;
  for (const auto& marker : shoe_markers()) chart.markers.push_back({marker.x, marker.text.toStdString()});
}

CurveStyle profile_style(const results::Profile& profile) {
  constexpr long kFew = 16;
  const auto points = std::ranges::count_if(profile.y, [](double value) { return std::isfinite(value); });
  return points < kFew ? CurveStyle::kLineAndMarkers : CurveStyle::kLine;
}

}  // namespace diefill::render
