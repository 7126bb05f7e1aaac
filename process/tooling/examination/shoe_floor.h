// Whether the shoe's own bottom keeps the powder in it, as in a box.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/tooling/tooling.h"

namespace diefill::process {

/// A bottom that closes a shoe.
struct ShoeFloor {
  double height = 0;                    ///< m, z of its lowest place at the scene's start
  std::vector<Eigen::Vector3d> places;  ///< m, on it
};

/// The bottom of a shoe where it lies below all powder in it, so that nothing can leave downwards; nothing
/// where it has an opening, and for a shoe that a step tips. `scene` has prepared steps.
std::optional<ShoeFloor> closed_floor(const Scene& scene, const Tool& shoe);

/// "shoe "shoe" is closed at its bottom, z = 1 mm: ...", with what to do.
std::string closed_floor_text(const Tool& shoe, const ShoeFloor& floor);

}  // namespace diefill::process
