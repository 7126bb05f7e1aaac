// For how long powder stands over each place of an opening, crossing by crossing.
#pragma once

#include <vector>

#include "process/estimate/openings.h"

namespace diefill::process::estimate {

/// Powder over one place without a break.
struct Exposure {
  double began = 0;    ///< s
  double seconds = 0;  ///< s
  double travel = 0;   ///< m that the shoe goes on meanwhile, along its path
};

/// What the shoe does over the openings.
struct ShoePath {
  std::string tool;                                      ///< empty: no shoe
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< unit vector of its path over the openings
  double speed = 0;                                      ///< m/s over the openings, mean; 0: it stands
  double length = 0;                                     ///< m of powder along that path, mean
  std::size_t crossings = 0;                             ///< the most that any place sees
  std::vector<std::vector<Exposure>> exposures;          ///< by patch of the layout
};

/// Follows the shoe over the openings, and sets their chords along its path. Powder fills the shoe's opening
/// at its lower edge; where that is open on a side, the box that it is poured in. `scene` has prepared steps.
ShoePath shoe_path(const Scene& scene, const Tooling& tooling, OpeningLayout& layout);

}  // namespace diefill::process::estimate
