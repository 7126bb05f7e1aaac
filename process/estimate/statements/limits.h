// The range in which the formulas of an estimate were compared with runs.
#pragma once

#include <string>
#include <vector>

#include "process/estimate/estimate.h"

namespace diefill::process::estimate {

/// Grain size over the width of an opening, beyond which estimates fail (README.md, Error).
inline constexpr double kCoarsestGrain = 0.43;
/// m of powder in the shoe; less runs in where it is shallower (Bierwisch 2009, section 4.1.6).
inline constexpr double kShallowestPowder = 0.012;
/// Froude number beyond which powder has no time to fall (Eq. 5.17).
inline constexpr double kLargestFroude = 1 / continuum::kBurst;

/// Why nothing runs into a cavity, or not to its floor, because the grains are too coarse; empty: they are
/// not.
std::string too_coarse(const Estimate& estimate, const OpeningEstimate& opening);

/// That grains stick together more than those that the discharge law was compared with; empty: they do not.
std::string too_cohesive(const Estimate& estimate);

/// Why the discharge law may be none of this powder, as its fit says; empty: it has no such remark.
std::string doubts_of_law(const Estimate& estimate);

/// The limits of the range that a scene exceeds, a clause each.
std::vector<std::string> limits_passed(const Estimate& estimate);

}  // namespace diefill::process::estimate
