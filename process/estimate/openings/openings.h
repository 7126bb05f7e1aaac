// Openings that powder can fall into, seen from above: those of the cavities, or holes through a plate.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "process/estimate/openings/outline.h"
#include "process/tooling/tooling.h"

namespace diefill::process::estimate {

/// A small piece of an opening at the fill plane. m, in the frame of the die at the scene's start.
struct OpeningPatch {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double area = 0;          ///< m^2
  double width = 0;         ///< m, diameter of the largest circle in the opening that holds the place
  double chord = 0;         ///< m, of the opening along the shoe's path, set by shoe_path()
  std::size_t opening = 0;  ///< which of OpeningLayout::openings
  std::optional<double>
      opens;  ///< s, when a punch that fills it begins to fall; nothing: open from the start
  std::optional<std::size_t> punch;  ///< that falls below it, which of OpeningLayout::punches
};

/// An opening as a whole.
struct FillOpening {
  bool is_cavity = false;  ///< else a hole right through the tools
  double area = 0;         ///< m^2; 0: a cavity that is not seen from above
  double width = 0;        ///< m, the mean over the area
  double volume = 0;       ///< m^3 of the cavity below it, as the scene's steps leave it
  double narrowest = 0;    ///< m, width of that cavity over its height
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< m, of that cavity
};

/// A punch that goes down in the die while the scene runs, or over which the die is lifted.
struct FallingPunch {
  std::string tool;
  double began = 0, ended = 0;                               ///< s
  double stroke = 0;                                         ///< m, downwards in the die
  double area = 0;                                           ///< m^2 of the opening above it
  std::size_t opening = 0;                                   ///< that it opens
  double speed() const { return stroke / (ended - began); }  ///< m/s
  /// Share of the stroke that is done at `time` (s), taken as steady.
  double progress(double time) const { return std::clamp((time - began) / (ended - began), 0.0, 1.0); }
};

/// All openings of a scene.
struct OpeningLayout {
  Outline outline;  ///< of the tools but the shoe, just below the fill plane
  std::vector<OpeningPatch> places;
  std::vector<FillOpening> openings;  ///< cavities first, as in the tooling
  std::vector<FallingPunch> punches;
};

/// m, narrowest of the holes right through the tools, whose powder is not that of a cavity; 0: there is none.
double narrowest_hole(const Scene& scene, const Tooling& tooling);

/// Finds the openings. `scene` has prepared steps. In a scene that is periodic along y, those of one period.
OpeningLayout find_openings(const Scene& scene, const Tooling& tooling);

}  // namespace diefill::process::estimate
