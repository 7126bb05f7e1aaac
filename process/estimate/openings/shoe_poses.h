// The shoe seen from the die, instant by instant.
#pragma once

#include <string>
#include <vector>

#include "process/tooling/tooling.h"

namespace diefill::process::estimate {

/// The shoe at one time.
struct ShoePose {
  double time = 0;                                     ///< s
  Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();  ///< takes places of the die to the shoe's frame
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();     ///< m
  Eigen::Vector2d place_in_shoe(const Eigen::Vector2d& at) const { return turn * (at - shift); }
};

/// Its poses from the scene's start on, in a run that goes as predicted. Shaking of shoe or die by up to
/// a centimetre is left out: it carries the shoe nowhere, and would cut what stands over a place at the
/// shoe's edge into many crossings. `scene` has prepared steps.
std::vector<ShoePose> shoe_poses(const Scene& scene, const Tooling& tooling, const std::string& shoe);

/// Whether the scene's powder falls from its start on until it is at rest, into what is open below the shoe.
bool pours_until_at_rest(const Scene& scene);

/// Whether a motion about one place shakes the shoe at any time from `from` to `to` (s).
bool is_shaken(const Scene& scene, const std::string& shoe, double from, double to);

}  // namespace diefill::process::estimate
