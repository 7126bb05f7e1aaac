// Draws the curves of a chart and their legend entries.
#pragma once

#include <QPainter>

#include "render/charts/chart.h"
#include "render/style/axes.h"

namespace diefill::render {

/// Colour of the k-th curve of data: Okabe and Ito's eight, which the colour-blind tell apart too.
QColor curve_colour(std::size_t index);

/// Whether points are marked.
bool has_marks(CurveStyle style);

/// Draws the k-th of `curves` inside the data rectangle: lines, bands and bars end at the frame, marks beyond
/// it are left out.
void draw_curve(QPainter& painter, const PlotArea& area, const std::vector<Curve>& curves, std::size_t index);

/// Draws curve names in columns within `width`, from `top` down; without a painter only measures.
/// Returns the height taken, 0 when no curve has a name.
double draw_legend(QPainter* painter, const std::vector<Curve>& curves, double left, double top,
                   double width);

}  // namespace diefill::render
