// Correlation of paired values.
#pragma once

#include <vector>

namespace diefill::results {

/// Pearson's correlation coefficient of `a` and `b`, of one length and finite: the sum of products of the
/// deviations from the two means over the root of the product of the sums of their squares. NaN for fewer
/// than three pairs, and where one of the two is constant within rounding: a standard deviation of at most
/// 1e-12 times its mean.
double pearson_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace diefill::results
