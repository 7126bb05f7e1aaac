// The shaded view of one instant as a whole picture: grains and cut tools with title, scale bar, axes and
// colour bar.
#pragma once

#include <QImage>

#include "process/results/fill_result.h"
#include "render/colour_bar.h"
#include "render/view_choice.h"

namespace diefill::render {

/// A finished snapshot, with what is needed to read it.
struct SnapshotPicture {
  QImage image;
  QRectF scene;     ///< pixels of the three-dimensional view
  ViewChoice view;  ///< what it shows
  QRectF bar_rect;  ///< pixels of the colour bar; empty where no grain has a closed cell
  ColourBar bar;
  double scale_bar = 0;     ///< mm, length that the scale bar stands for
  double scale_pixels = 0;  ///< pixels, its length
};

/// Draws the snapshot on a canvas of 1600 x 1200 pixels; throws std::runtime_error where there is no
/// renderer.
SnapshotPicture compose_snapshot(const results::FillResult& result);

}  // namespace diefill::render
