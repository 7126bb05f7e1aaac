// The scale beside a coloured picture: bar, ticks, label, and pointed ends where values lie beyond it.
#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>
#include <limits>
#include <span>

#include "render/style/colour_map.h"
#include "render/style/ticks.h"

namespace diefill::render {

/// A vertical colour scale.
struct ColourBar {
  QString label;
  Interval range;
  bool open_below = false;  ///< some values lie below the scale: pointed lower end
  bool open_above = false;  ///< some values lie above the scale: pointed upper end
  ColourScale colours = ColourScale::kSequential;
  double mark = std::numeric_limits<double>::quiet_NaN();  ///< value that an arrow at the left points at
};

/// The scale for `values`; limits that are NaN come from robust_range, the others are kept. Throws
/// std::runtime_error where the lower limit is not below the upper one.
ColourBar make_colour_bar(const QString& label, std::span<const double> values, const Interval& wanted);

/// A diverging scale with 0 in the middle: as far to both sides as nine in ten of `values` reach, rounded up,
/// or `wanted` where that is a number. Throws as above for a limit that is not positive.
ColourBar make_diverging_bar(const QString& label, std::span<const double> values, double wanted);

/// Colour of `value` on the bar's scale; NaN gives kNoValueColour.
Rgb bar_colour(const ColourBar& bar, double value);

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
