// How a picture shows places where the field has no value: tools, air, empty cavity, powder without value.
#pragma once

#include <QPainter>
#include <array>

#include "render/fields/field_style.h"
#include "render/style/colour_bar.h"

namespace diefill::render {

/// What is at a place of a picture.
enum class Place { kValue, kUnvalued, kTool, kEmptyCavity, kAir, kNoPowder };

/// What is at a place without value; with no `style.in_cavity` only tools and powder without value are known,
/// and the rest is kNoPowder.
Place place_of(double value, double first, double second, const FieldStyle& style);

/// Colour of a pixel (column, row) at a place without value: tools hatched, powder without value dotted, air
/// white. Where white means "no change", places without powder have lines across.
QRgb place_colour(Place place, const ColourBar& bar, int column, int row);

/// Which places a picture shows.
class PlacesShown {
 public:
  void add(Place place) { shown_[static_cast<std::size_t>(place)] = true; }
  void add(const PlacesShown& other);
  bool any() const;
  /// Whether anything but kNoPowder needs an entry: the legend then takes a line of its own.
  bool several() const;
  /// Draws a swatch with its meaning for each, from the left; returns the width in pixels.
  double draw_legend(QPainter& painter, const QPointF& corner, const ColourBar& bar) const;
  double legend_width() const;

 private:
  std::array<bool, 6> shown_{};
};

/// Pixels that a legend in a line of its own takes.
inline constexpr double kLegendLine = 42;

}  // namespace diefill::render
