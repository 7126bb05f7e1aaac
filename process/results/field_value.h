// Values of profiles and fields at any place, linear between their nodes.
#pragma once

#include "process/results/fill_result.h"

namespace diefill::results {

/// `profile` at `x` in its x_unit. NaN beyond the nodes and beside a node without a value. Azimuths in
/// degrees continue round the circle: -90 is 270, and between the last node and the first the profile is
/// linear too.
double value_at(const Profile& profile, double x);

/// The same of a field, bilinear; unvalued_powder() beside a node of it where the others are no holes.
double value_at(const Field2D& field, double first, double second);

}  // namespace diefill::results
