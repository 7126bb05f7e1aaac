// Density maps of several runs against each other.
#pragma once

#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process {

/// What compares best as a picture: the map of a ring, or the first section. Null where the result has
/// neither.
const results::Field2D* compared_field(const results::FillResult& result);

/// Mean of fields at the nodes of the first one, bilinear between the nodes of the others. A node has a value
/// where at least half of them hold powder: the mean of those with a value, or unvalued_powder() without any.
/// Empty without fields.
results::Field2D mean_field(const std::vector<results::Field2D>& fields);

/// results::pearson_correlation() of two fields over the nodes of the first where both have a value, bilinear
/// between the nodes of the second.
double correlation(const results::Field2D& first, const results::Field2D& second);

}  // namespace diefill::process
