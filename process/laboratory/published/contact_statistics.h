// Contacts of a bed as its results have them: overlaps and contact numbers from positions alone.
#pragma once

#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process::laboratory {

struct ContactStatistics {
  double peak_overlap = 0;             ///< h / d of the fullest bin of the histogram
  double mean_overlap = 0;             ///< h / d
  double contacts_a_grain = 0;         ///< distinct grains that touch a grain, mean over the grains
  std::vector<double> overlap, share;  ///< h / d in the middle of a bin, share of contacts in it
};

/// Whether each grain's centre lies more than `margin` d above z = 0 and below the highest centre; for a
/// margin of 0 all do.
std::vector<bool> away_from_ends(const results::PowderState& powder, double margin);

/// Overlaps h of spheres of different grains over d, in bins of `bin` (h / d). Of grains so far away from
/// ground and top (`margin`, d), with whatever they touch.
ContactStatistics contact_statistics(const results::PowderState& powder, double bin = 5e-5,
                                     double margin = 0);

}  // namespace diefill::process::laboratory
