// The scale beside a coloured picture: bar, ticks, label, and pointed ends where values lie beyond it.
#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>
#include <span>

#include "render/ticks.h"

namespace diefill::render {

/// A vertical colour scale.
struct ColourBar {
  QString label;
  Interval range;
  bool open_below = false;  ///< some values lie below the scale: pointed lower end
  bool open_above = false;  ///< some values lie above the scale: pointed upper end
};

/// The scale for `values`; limits that are NaN come from robust_range, the others are kept. Throws
/// std::runtime_error where the lower limit is not below the upper one.
ColourBar make_colour_bar(const QString& label, std::span<const double> values, const Interval& wanted);

/// Pixels to the right of the bar's left edge that bar, ticks and label take.
double colour_bar_width(const ColourBar& bar);

/// Draws the bar with colours filling `bar_rect` (pointed ends lie outside, above and below), label at its
/// right.
void draw_colour_bar(QPainter& painter, const ColourBar& bar, const QRectF& bar_rect);

/// Height in pixels of a pointed end.
inline constexpr double kBarPoint = 24;
/// Width in pixels of the bar.
inline constexpr double kBarWidth = 42;

/// Draws a small square of the colour with a text at its right, upper left corner at `corner`; returns its
/// width.
double draw_swatch(QPainter& painter, const QPointF& corner, const QColor& colour, const QString& text);

}  // namespace diefill::render
