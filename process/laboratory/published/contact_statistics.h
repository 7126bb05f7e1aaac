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

}  // namespace diefill::process::laboratory
