// How readily powder flows sideways, as the kinematic model has it: the length B that takes the place of a
// diffusivity, constant or growing towards the solid fraction of powder at rest.
#pragma once

#include <functional>
#include <vector>

namespace diefill::process::continuum {

/// m, of the solid fraction. Throws std::domain_error where it has no meaning.
using DiffusionLength = std::function<double(double)>;

/// The same everywhere (Bierwisch 2009, Eq. 5.2).
DiffusionLength constant_length(double length);

/// B(n) of a powder whose solid fraction changes as it flows (Bierwisch 2009, Eqs. 5.5, 5.6).
struct LengthOfFraction {
  double smallest = 0.116e-3;  ///< m, B_0; nu D with nu = 0.0077 for other openings (Eq. 5.10)
  double diverging = 0.353;    ///< n_div
  double peak = 0.347;         ///< n_peak, below n_div: beyond it B falls again

  /// m. Throws std::domain_error for fractions at which the formula would not be positive.
  double operator()(double fraction) const;
};

/// B found at a solid fraction.
struct LengthPoint {
  double fraction = 0;
  double length = 0;  ///< m
  double weight = 1;
};

/// The rising branch of Eq. 5.5 (Bierwisch 2009), B_0 / (1 - n / n_div), with the least weighted squares of
/// log B; `peak` is the densest of the points, up to which the branch is known. Throws std::invalid_argument
/// where fewer than three points have a positive length.
LengthOfFraction fit_length(const std::vector<LengthPoint>& points);

}  // namespace diefill::process::continuum
