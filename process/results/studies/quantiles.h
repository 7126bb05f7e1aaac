// Quantiles of distributions, for intervals and tests. Boost.Math computes them; its headers take longer to
// compile than all else that uses them, so they are seen by one file.
#pragma once

namespace diefill::results {

/// Half width of the two-sided 95 % interval of a mean in its standard errors: Student's t with `freedom` > 0
/// degrees of freedom at 0.975. Throws std::domain_error otherwise.
double student_95(double freedom);

/// The value below which a normal number of mean 0 and deviation 1 lies with `probability` (above 0, below
/// 1).
double normal_quantile(double probability);

/// The chi^2 with `freedom` degrees of freedom that chance exceeds with `probability` (above 0, below 1).
double chi_squared_exceeded(double freedom, double probability);

/// The ratio of two variances, estimated with `above` and `below` degrees of freedom, that chance exceeds
/// with `probability` (above 0, below 1) where the variances are equal (Fisher's F).
double variance_ratio_exceeded(double above, double below, double probability);

}  // namespace diefill::results
