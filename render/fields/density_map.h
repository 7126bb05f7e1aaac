// A field over two coordinates as a coloured picture: the solid-fraction map of a ring, or a plane section.
#pragma once

#include <QImage>
#include <string>

#include "process/results/fill_result.h"
#include "render/fields/field_style.h"
#include "render/fields/pictures.h"
#include "render/fields/place_style.h"
#include "render/style/axes.h"
#include "render/style/colour_bar.h"

namespace diefill::render {

/// A finished picture, with the geometry needed to read values from it.
struct FieldPicture {
  QImage image;
  PlotArea plot;
  ColourBar bar;
  QRectF bar_rect;  ///< pixels of the colour bar without its pointed ends; empty where the field has no value
  bool has_holes = false;  ///< some nodes are NaN and a legend says so
};

/// Lays out and draws `field`. Azimuth in degrees is drawn from 0 to 360 and wraps round; two coordinates of
/// the same unit keep equal scales. Values between nodes are bilinear; holes keep the nodes' edges. Throws
/// std::runtime_error for a field whose coordinates do not rise, or do not match its values.
FieldPicture compose_field(const results::Field2D& field, const std::string& title,
                           const std::string& subtitle, const ColourRange& range,
                           const FieldStyle& style = {});

/// Axes of a field for a data rectangle of `size` pixels with its corner at (0, 0).
PlotArea field_axes(const results::Field2D& field, const QSizeF& size);

/// Colours the pixels of the data rectangle with the bar's scale, bilinear between nodes, and what has no
/// value as place_style.h says; returns what that was.
PlacesShown paint_field(QImage& canvas, const PlotArea& plot, const results::Field2D& field,
                        const ColourBar& bar, const FieldStyle& style = {});

}  // namespace diefill::render
