// Openings that powder can fall into, seen from above: the mouths of the cavities, or holes through a plate.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/estimate/outline.h"
#include "process/tooling/tooling.h"

namespace diefill::process::estimate {

/// A small piece of an opening at the fill plane. m, in the frame of the die at the scene's start.
struct MouthPlace {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double area = 0;              ///< m^2
  double width = 0;             ///< m, diameter of the largest circle in the opening that holds the place
  double chord = 0;             ///< m, of the opening along the shoe's way, set by shoe_way()
  std::size_t opening = 0;      ///< which of Mouth::openings
  std::optional<double> opens;  ///< s, when a punch below it begins to fall; nothing: open from the start
};

/// An opening as a whole.
struct MouthOpening {
  bool is_cavity = false;  ///< else a hole right through the tools
  double area = 0;         ///< m^2
  double width = 0;        ///< m, the mean over the area
  double volume = 0;       ///< m^3 of the cavity below it, as the scene's steps leave it
};

/// A punch that goes down in the die while the scene runs.
struct FallingPunch {
  std::string tool;
  double began = 0, ended = 0;                               ///< s
  double stroke = 0;                                         ///< m, downwards
  double area = 0;                                           ///< m^2 of the mouth above it
  std::size_t opening = 0;                                   ///< that it opens
  double speed() const { return stroke / (ended - began); }  ///< m/s
};

struct Mouth {
  Outline outline;  ///< of the tools but the shoe, just below the fill plane
  std::vector<MouthPlace> places;
  std::vector<MouthOpening> openings;  ///< cavities first, as in the tooling
  std::vector<FallingPunch> punches;
};

/// m, narrowest of the holes right through the tools, whose powder is not that of a cavity; 0: there is none.
double narrowest_hole(const Scene& scene, const Tooling& tooling);

/// Finds the openings. `scene` has prepared steps. In a scene that is periodic along y, those of one period.
Mouth mouth_of(const Scene& scene, const Tooling& tooling);

}  // namespace diefill::process::estimate
