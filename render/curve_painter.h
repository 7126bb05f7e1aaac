// Draws the curves of a chart and their legend entries.
#pragma once

#include <QPainter>

#include "render/axes.h"
#include "render/chart.h"

namespace diefill::render {

/// Colour of the k-th curve: Okabe and Ito's eight, which the colour-blind tell apart too.
QColor curve_colour(std::size_t index);

/// Draws the k-th curve inside the data rectangle.
void draw_curve(QPainter& painter, const PlotArea& area, const Curve& curve, std::size_t index);

/// Draws curve names in rows that wrap at `width`, from `top` down; without a painter only measures.
/// Returns the height taken, 0 when no curve has a name.
double draw_legend(QPainter* painter, const std::vector<Curve>& curves, double left, double top,
                   double width);

}  // namespace diefill::render
