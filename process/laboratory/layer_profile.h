// Solid fraction of a settled bed over its height, from the cross-sections of its spheres with horizontal
// planes.
#pragma once

#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process::laboratory {

struct LayerProfile {
  std::vector<double> height;  ///< z over d, every d / 20 from z = 0 to 2 d below the highest sphere
  std::vector<double> share;   ///< of the horizontal plane at that height that lies in the grains' spheres
};

/// Of a bed over `area` (m^2). Exact for spheres that do not overlap (model D).
LayerProfile layer_profile(const results::PowderState& powder, double area);

/// Near the ground: the smallest share above the final drop and up to 2 d, and the height (over d) above
/// which shares up to 2 d stay within 10 % of `bulk`.
struct NearGround {
  double lowest_share = 0, bulk_reached_at = 0;
};
NearGround near_ground(const LayerProfile& profile, double bulk);

}  // namespace diefill::process::laboratory
