// Stars and lines of one level on a field, with light edges that set them off from its colours; their legend.
#pragma once

#include <QPainter>

#include "process/results/fill_result.h"
#include "render/fields/field_style.h"
#include "render/style/axes.h"

namespace diefill::render {

/// Draws the style's level lines and stars on the data rectangle.
void draw_field_marks(QPainter& painter, const PlotArea& plot, const results::Field2D& field,
                      const FieldStyle& style);

/// Pixels that their legend takes above the field; 0: there are none.
double marks_legend_height(const FieldStyle& style);

/// Draws a sample of each with its meaning, from `corner` to the right.
void draw_marks_legend(QPainter& painter, const QPointF& corner, const FieldStyle& style);

}  // namespace diefill::render
