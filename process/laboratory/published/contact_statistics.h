// Contacts of a bed as its results have them: overlaps and contact numbers from positions alone.
#pragma once

#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process::laboratory {

struct ContactStatistics {
  double peak_overlap = 0;             ///< h / d of the fullest bin of the histogram
  double mean_overlap = 0;             ///< h / d
  double contacts_a_grain = 0;         ///< distinct grains that touch a grain, over all grains
  std::vector<double> overlap, share;  ///< h / d in the middle of a bin, share of contacts in it
};

/// Overlaps h of spheres of different grains over d, in bins of `bin` (h / d).
ContactStatistics contact_statistics(const results::PowderState& powder, double bin = 5e-5);

/// Share of the horizontal plane at height z / d that lies in the grains' spheres, every d / 20 from z = 0 to
/// 2 d below the highest sphere. Exact for spheres that do not overlap.
struct LayerProfile {
  std::vector<double> height, share;
};
LayerProfile layer_profile(const results::PowderState& powder);

/// Near the ground: the smallest share above the final drop and up to 2 d, and the height (over d) from which
/// on shares up to 2 d stay within 10 % of `bulk`.
struct NearGround {
  double lowest_share = 0, bulk_reached_at = 0;
};
NearGround near_ground(const LayerProfile& profile, double bulk);

}  // namespace diefill::process::laboratory
