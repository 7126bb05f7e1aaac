// A rectangle of data: where a value lies on the picture, and the frame, ticks and labels around it.
#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>
#include <vector>

#include "render/style/text.h"
#include "render/style/ticks.h"

namespace diefill::render {

/// One axis: what it is called, which values it spans, where its ticks stand.
struct Axis {
  QString label;
  Interval range;
  Ticks ticks;
  bool logarithmic = false;

  /// Place of `value` along the axis, 0 at the lower end and 1 at the upper; NaN for values a logarithm has
  /// no place for.
  double fraction(double value) const;
};

/// The data rectangle of a picture, in pixels, with its two axes.
struct PlotArea {
  QRectF rect;
  Axis x, y;

  /// Pixel of the data point (x_value, y_value).
  QPointF pixel(double x_value, double y_value) const;
  /// Data value at a pixel; linear axes only.
  QPointF value(const QPointF& pixel) const;
};

/// Pixels left of the data rectangle that the y axis' ticks and label take.
double left_margin(const Axis& y);

/// Pixels below the data rectangle that the x axis' ticks and label take.
double bottom_margin();

/// Labels of the x axis' ticks as they are drawn, and the height of their type in pixels.
struct TickTexts {
  std::vector<QString> labels;
  int pixels = kTickPixels;
};

/// Labels so small, and where that is not enough so short, that neighbours do not touch.
TickTexts x_tick_texts(const PlotArea& area);

/// Draws pale lines at the labelled ticks, to be drawn before the data.
void draw_grid(QPainter& painter, const PlotArea& area);

/// Draws frame, ticks, tick labels and axis labels. Axis labels longer than the rectangle stay on the canvas.
void draw_axes(QPainter& painter, const PlotArea& area, const QSizeF& canvas);

/// A remark pinned to an x value, drawn in the band of kMarkerBand pixels above the rectangle.
struct AxisMarker {
  double x = 0;
  QString text;
};
inline constexpr double kMarkerBand = 52;

/// Draws remarks with a small arrow pointing at the upper edge; those at the ends stay inside the rectangle's
/// width.
void draw_markers(QPainter& painter, const PlotArea& area, const std::vector<AxisMarker>& markers);

/// Where the shoe first meets the cavity (0 and 360 degrees) and leaves it (180 degrees), for azimuth axes.
std::vector<AxisMarker> shoe_markers();

}  // namespace diefill::render
