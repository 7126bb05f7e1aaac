// How a map varies over height and azimuth, how it differs from another, and how grains' values are
// distributed.
#pragma once

#include <optional>

#include "process/results/spread_profile.h"

namespace diefill::process {

/// Mean over azimuth (scatter: standard deviation over azimuth) at each height of a map; nodes without powder
/// stay out. Nodes at 0 and 360 degrees count once.
results::SpreadProfile profile_over_height(const results::Field2D& map);

/// The same over height, at each azimuth.
results::SpreadProfile profile_over_azimuth(const results::Field2D& map);

/// `after` minus `before` on the nodes of `before` that both have; NaN where either has no powder. Throws
/// std::invalid_argument where coordinates have other names or no node is common: maps of other cavities, or
/// made with another averaging width.
results::Field2D difference(const results::Field2D& before, const results::Field2D& after);

/// Shares of values in bins of `width` that begin at multiples of it; values without number stay out.
results::Histogram histogram(const std::string& quantity, const std::string& unit,
                             const std::vector<double>& values, double width);

/// Solid fractions of the grains with closed cells in the cavity, of all closed grains where none lies in a
/// cavity.
std::vector<double> counted_fractions(const results::GrainSolidFraction& fraction);

}  // namespace diefill::process
