// Framing of a snapshot: where the scene is cut open, and which part fills the picture. Plain geometry.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "process/results/fill_result.h"

namespace diefill::render {

/// A parallel view from the front (against +y) and slightly above, in m and the laboratory frame.
struct ViewChoice {
  double cut_y = 0;                                  ///< m: everything at smaller y is taken away
  Eigen::Vector3d target = Eigen::Vector3d::Zero();  ///< m: centre of the picture, in the cutting plane
  double width = 0, height = 0;                      ///< m: what the picture spans
  double elevation = 0;                              ///< rad: how far the eye is above the horizon
  double azimuth = 0;  ///< rad: how far the eye has gone round z, counter-clockwise, from the front (-y)
  bool empty = false;  ///< neither powder nor tools: nothing to show
};

/// To the right and upwards in the picture, and from the scene to the eye.
struct ViewAxes {
  Eigen::Vector3d right, up, to_eye;
};
ViewAxes view_axes(const ViewChoice& view);

/// Where the eye is.
struct Camera {
  double azimuth = 0;       ///< rad, as in ViewChoice
  double elevation = 0.35;  ///< rad, some 20 degrees: the powder's surface shows, depths stay readable
  bool operator==(const Camera&) const = default;
};

/// Cuts through the cavity's axis (or the middle of its box, or of the powder), and frames all cavities, the
/// powder over them and a shoe that stands near; `aspect` is the picture's width over its height.
ViewChoice choose_view(const results::FillResult& result, double aspect, const Camera& camera = {});

/// One view for all instants of a run in which a shoe crosses the cavities: these fill it, with room beside
/// and above them in which the shoe comes and goes, partly out of the picture. None where no shoe crosses.
std::optional<ViewChoice> view_of_passage(const results::FillResult& result, double aspect,
                                          const Camera& camera = {});

/// Shows what both show, as `one` looks at it.
ViewChoice united(const ViewChoice& one, const ViewChoice& other);

}  // namespace diefill::render
