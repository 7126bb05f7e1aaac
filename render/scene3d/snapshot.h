// The shaded view of one instant as a whole picture: grains and cut tools with title, scale bar, axes and
// colour bar.
#pragma once

#include <QImage>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "process/results/fill_result.h"
#include "render/scene3d/grain_view.h"
#include "render/scene3d/view_choice.h"
#include "render/style/colour_bar.h"

namespace diefill::render {

/// A finished snapshot, with what is needed to read it.
struct SnapshotPicture {
  QImage image;
  QRectF scene;     ///< pixels of the three-dimensional view
  ViewChoice view;  ///< what it shows
  QRectF bar_rect;  ///< pixels of the colour bar; empty where no grain has a closed cell
  ColourBar bar;
  std::vector<QRectF> swatches;  ///< of ViewOptions::kinds, pixels
  double scale_bar = 0;          ///< mm, length that the scale bar stands for
  double scale_pixels = 0;       ///< pixels, its length
};

/// What a shaded view is of.
struct ViewOptions {
  std::vector<double> values;  ///< one per grain, NaN: grey; empty: solid fraction of closed cells
  /// What the values 1, 2, ... mean, such as powders: a legend in place of the colour scale; empty: values
  /// are numbers.
  std::vector<std::string> kinds;
  std::string quantity = "solid fraction", unit;
  std::string grey_means = "grain without closed cell (free surface)";
  double lower = std::numeric_limits<double>::quiet_NaN();  ///< of the colour scale; NaN: from the values
  double upper = std::numeric_limits<double>::quiet_NaN();
  Camera camera;
  std::optional<ViewChoice> view;  ///< instead of one chosen for `camera`: films keep theirs
  SceneLook look;
  double pixels = 1;  ///< picture points a layout point
};

/// Solid fraction of every grain, NaN where its cell is open or was not measured.
std::vector<double> fractions_of_closed_cells(const results::FillResult& result);

/// Draws the snapshot on a canvas of 1600 x 1200 layout points; throws std::runtime_error where there is no
/// renderer.
SnapshotPicture compose_snapshot(const results::FillResult& result, const ViewOptions& options = {});

/// Width over height of the scene in a snapshot of this result, for choose_view.
double scene_aspect(const results::FillResult& result);

}  // namespace diefill::render
