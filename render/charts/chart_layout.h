// Layout of a chart and its finished picture; draw_chart() in chart.h is the entry point.
#pragma once

#include <QImage>

#include "render/charts/chart.h"
#include "render/style/axes.h"

namespace diefill::render {

/// A finished chart, with the geometry needed to find data points on it.
struct ChartPicture {
  QImage image;
  PlotArea plot;
};

/// Limits of an axis over `values` (all curves' coordinates, error bars included): as given, or from the
/// data. With `from_zero` a linear axis includes zero.
Interval axis_range(const ChartAxis& axis, const std::vector<double>& values, bool from_zero);

/// Throws std::runtime_error for arrays of different lengths, naming the curve.
void check_chart(const Chart& chart);

/// Draws the chart on a canvas; throws as draw_chart() does, files apart.
ChartPicture compose_chart(const Chart& chart);

}  // namespace diefill::render
