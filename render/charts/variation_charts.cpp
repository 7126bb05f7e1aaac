#include "render/charts/variation_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/charts/profile_axes.h"
#include "render/style/text.h"

namespace diefill::render {
namespace {

/// Left edge of the first bar where that lies below zero but no value does: whole numbers, which stand in the
/// middle of their bars. NaN otherwise.
double lower_limit(const std::vector<Named<results::Histogram>>& histograms) {
  double least = std::numeric_limits<double>::infinity(), edge = least;
  for (const auto& [name, histogram] : histograms) {
    if (histogram.middle.size() < 2 || histogram.middle.front() >= least) continue;
    least = histogram.middle.front();
    edge = least - 0.5 * (histogram.middle[1] - least);
  }
  return least >= 0 && edge < 0 ? edge : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

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
  chart.note = "Mean over " + over + "; band: ± one standard deviation over " + over;
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
  chart.x.lower = lower_limit(histograms);
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

Chart fill_level_chart(const std::vector<Named<results::Profile>>& levels, const std::vector<double>& depths,
                       const std::string& subtitle) {
  Chart chart = profile_chart(levels, "Fill level", subtitle);
  if (levels.empty() || levels.front().data.x.empty()) return chart;
  const auto& places = levels.front().data.x;
  const std::vector<double> ends = std::isnan(chart.x.lower)
                                       ? std::vector<double>{places.front(), places.back()}
                                       : std::vector<double>{chart.x.lower, chart.x.upper};
  const auto same = [&](double depth) { return std::abs(depth - depths.front()) < 1e-6 * depths.front(); };
  const bool one = std::ranges::all_of(depths, same);
  for (std::size_t k = 0; k < (one ? 1 : levels.size()); ++k)
    chart.curves.push_back({one ? "fill plane" : "fill plane of " + levels[k].name,
                            ends,
                            {depths[k], depths[k]},
                            CurveStyle::kReference,
                            {}});
  return chart;
}

}  // namespace diefill::render
