// Arrows on a field's picture, with one of known length in the corner.
#pragma once

#include <QPainter>

#include "render/fields/field_style.h"
#include "render/style/axes.h"

namespace diefill::render {

/// Value of the arrow in the legend: `style.arrow_length`, or a round one near the longest of the arrows.
double legend_arrow(const FieldStyle& style);

/// Draws the style's arrows with their feet at their places, all to one scale and in true directions, and the
/// legend arrow in the upper right corner. Those shorter than a dot are dots. Nothing without arrows.
void draw_arrows(QPainter& painter, const PlotArea& area, const FieldStyle& style);

}  // namespace diefill::render
