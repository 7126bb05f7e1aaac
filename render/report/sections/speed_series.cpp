#include "render/report/sections/speed_series.h"

#include <algorithm>
#include <cmath>

#include "process/results/figure_table.h"
#include "render/report/figure_text.h"
#include "render/report/pictures_of.h"
#include "render/report/sections/critical_speed.h"

namespace diefill::render::report {
namespace {

Chart speed_chart(const std::vector<Strategy>& strategies, const CriticalSpeed& critical) {
  Chart chart;
  chart.title = short_title("fill_ratio") + " over " + results::figure_called("shoe_speed_m_s").label;
  chart.x.label = axis_title("shoe_speed_m_s");
  chart.y.label = axis_title("fill_ratio");
  Curve found{"runs", {}, {}, CurveStyle::kMarkers, {}};
  double fastest = 0;
  for (const auto& strategy : strategies) {
    const Scatter ratio = strategy.of("fill_ratio");
    found.x.push_back(strategy.of("shoe_speed_m_s").mean);
    found.y.push_back(ratio.mean);
    found.y_error.push_back(ratio.deviation);  // NaN, no bar, of a single run
    fastest = std::max(fastest, found.x.back());
  }
  chart.curves.push_back(found);
  chart.x.lower = 0;
  chart.y.lower = 0;
  if (!std::isfinite(critical.speed) || critical.speed >= fastest) return chart;
  Curve fit{"(v_c / v)^n", {}, {}, CurveStyle::kLine, {}};
  constexpr int kNodes = 60;
  for (int n = 0; n <= kNodes; ++n) {
    fit.x.push_back(critical.speed + (fastest - critical.speed) * n / kNodes);
    fit.y.push_back(std::pow(critical.speed / fit.x.back(), critical.exponent));
  }
  chart.curves.push_back(fit);
  return chart;
}

}  // namespace

Section speed_section(const std::vector<Strategy>& strategies) {
  Section section{"Critical shoe speed", 1, {}};
  std::vector<double> speed, ratio, error;
  for (const auto& strategy : strategies) {
    speed.push_back(strategy.of("shoe_speed_m_s").mean);
    const Scatter found = strategy.of("fill_ratio");
    ratio.push_back(found.mean);
    error.push_back(found.deviation / std::sqrt(static_cast<double>(std::max(1, found.count))));
  }
  const CriticalSpeed critical = critical_speed(speed, ratio, error);
  section.blocks.emplace_back(Paragraph{description(critical)});
  section.blocks.emplace_back(Figures{
      {chart_picture(speed_chart(strategies, critical),
                     short_title("fill_ratio") + " of every speed; bars: standard deviation over seeds.")}});
  return section;
}

}  // namespace diefill::render::report
