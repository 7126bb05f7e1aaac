// For how long powder stands over each place of an opening, crossing by crossing.
#pragma once

#include <vector>

#include "process/estimate/openings/openings.h"

namespace diefill::process::estimate {

/// Powder over one place without a break.
struct Exposure {
  double began = 0;    ///< s
  double seconds = 0;  ///< s
  double moving = 0;   ///< s of them in which the shoe goes on
  double travel = 0;   ///< m that it goes on meanwhile, there and back added up
  double reach = 0;    ///< m, farthest from where it came over the place
  double ended() const { return began + seconds; }
  double standing() const { return seconds > moving ? seconds - moving : 0; }
};

/// What the shoe does over the openings.
struct ShoePath {
  std::string tool;                                      ///< empty: no shoe
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< unit vector of its path over the openings
  double speed = 0;           ///< m/s while it moves over the openings, mean; 0: it stands
  double standing = 0;        ///< s that it stands over a place in the first crossing that moves, mean
  double length = 0;          ///< m of powder along that path, mean
  double extent = 0;          ///< m, of the place for powder in the shoe along that path
  bool pours = false;         ///< powder falls from the start until at rest, into what is open below the shoe
  std::size_t crossings = 0;  ///< the most that any place sees
  std::vector<std::vector<Exposure>> exposures;  ///< by patch of the layout
  /// Whether patch `place` is open below the powder that is poured.
  bool open_during_pour(std::size_t place) const {
    return pours && !exposures[place].empty() && exposures[place].front().began <= 0;
  }
};

/// Follows the shoe over the openings, and sets their chords along its path. Powder fills the shoe's opening
/// at its lower edge; where that is open on a side, the box that it is poured in. `scene` has prepared steps.
ShoePath shoe_path(const Scene& scene, const Tooling& tooling, OpeningLayout& layout);

}  // namespace diefill::process::estimate
