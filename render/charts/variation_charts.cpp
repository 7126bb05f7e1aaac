#include "render/charts/variation_charts.h"

#include <cmath>

#include "render/charts/profile_axes.h"
#include "render/style/text.h"

namespace diefill::render {

Chart spread_chart(const std::vector<Named<results::SpreadProfile>>& profiles, const std::string& title,
                   const std::string& subtitle, const std::string& across) {
  Chart chart;
  chart.title = title;
  chart.subtitle = subtitle;
  if (profiles.empty()) return chart;
  set_profile_axes(chart, profiles.front().data.mean);
  for (const auto& [name, profile] : profiles)
    chart.curves.push_back(
        {name, profile.mean.x, profile.mean.y, profile_style(profile.mean), {}, profile.spread});
  const std::string over = profiles.front().data.mean.x_name == "azimuth" ? "height" : across;
  chart.note = "Mean over " + over + "; band: +- one standard deviation over " + over;
  return chart;
}

Chart histogram_chart(const std::vector<Named<results::Histogram>>& histograms, const std::string& title,
                      const std::string& subtitle) {
  Chart chart;
  chart.title = title;
  chart.subtitle = subtitle;
  if (histograms.empty()) return chart;
  chart.x.label = axis_label(histograms.front().data.quantity, histograms.front().data.unit).toStdString();
  chart.y.label = "Share of grains [%]";
  chart.y.lower = 0;
  for (const auto& [name, histogram] : histograms) {
    const QString summary = QStringLiteral("mean over these grains %1, standard deviation %2, %3 grains")
                                .arg(histogram.mean, 0, 'g', 3)
                                .arg(histogram.std, 0, 'g', 2)
                                .arg(histogram.grains);
    Curve curve{(name.empty() ? "" : name + ": ") + summary.toStdString(),
                histogram.middle,
                histogram.share,
                histograms.size() > 1 ? CurveStyle::kLineAndMarkers : CurveStyle::kBars,
                {}};
    for (double& share : curve.y) share *= 100;
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

Chart profile_chart(const std::vector<Named<results::Profile>>& profiles, const std::string& title,
                    const std::string& subtitle) {
  Chart chart;
  chart.title = title;
  chart.subtitle = subtitle;
  if (profiles.empty()) return chart;
  set_profile_axes(chart, profiles.front().data);
  for (const auto& [name, profile] : profiles)
    chart.curves.push_back({name, profile.x, profile.y, CurveStyle::kLine, {}});
  return chart;
}

Chart fill_level_chart(const std::vector<Named<results::Profile>>& levels, double depth,
                       const std::string& subtitle) {
  Chart chart = profile_chart(levels, "Fill level", subtitle);
  if (levels.empty() || levels.front().data.x.empty()) return chart;
  const auto& places = levels.front().data.x;
  const std::vector<double> ends = std::isnan(chart.x.lower)
                                       ? std::vector<double>{places.front(), places.back()}
                                       : std::vector<double>{chart.x.lower, chart.x.upper};
  chart.curves.push_back({"fill plane", ends, {depth, depth}, CurveStyle::kReference, {}});
  return chart;
}

}  // namespace diefill::render
