// Density maps of several runs against each other.
#pragma once

#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process {

/// What compares best as a picture: the map of a ring, or the first section. Null where the result has
/// neither.
const results::Field2D* compared_field(const results::FillResult& result);

/// Mean of fields at the nodes of the first one, bilinear between the nodes of the others. A node has a value
/// where all of them have one. Empty without fields.
results::Field2D mean_field(const std::vector<results::Field2D>& fields);

/// Pearson's correlation of two fields over the nodes of the first where both have a value, bilinear between
/// the nodes of the second. NaN for fewer than three such nodes, or where one of the two is the same
/// everywhere.
double correlation(const results::Field2D& first, const results::Field2D& second);

}  // namespace diefill::process
