#include "process/continuum/diffusion_length.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace diefill::process::continuum {

DiffusionLength constant_length(double length) {
  return [length](double) { return length; };
}

double LengthOfFraction::operator()(double fraction) const {
  const double divisor = fraction <= peak ? 1 - fraction / diverging : 1 + (fraction - 2 * peak) / diverging;
  if (!(divisor > 0) || !(fraction >= 0)) {
    char text[120];
    std::snprintf(text, sizeof text, "the diffusion length has no value at a solid fraction of %.4g",
                  fraction);
    throw std::domain_error(text);
  }
  return smallest / divisor;
}

namespace {

/// The best log B_0 for this n_div, and the weighted sum of squares that is left.
struct Branch {
  double log_smallest = 0, left = 0;
};

Branch branch_at(const std::vector<LengthPoint>& points, double diverging) {
  double weight = 0, sum = 0, squares = 0;
  for (const LengthPoint& point : points) {
    if (!(point.length > 0)) continue;
    const double value = std::log(point.length) + std::log1p(-point.fraction / diverging);
    weight += point.weight;
    sum += point.weight * value;
    squares += point.weight * value * value;
  }
  return {sum / weight, squares - sum * sum / weight};
}

}  // namespace

LengthOfFraction fit_length(const std::vector<LengthPoint>& points) {
  double densest = 0;
  int usable = 0;
  for (const LengthPoint& point : points)
    if (point.length > 0) {
      densest = std::max(densest, point.fraction);
      ++usable;
    }
  if (usable < 3)
    throw std::invalid_argument(
        "fitting a diffusion length needs at least three points with a positive length");
  // The excess of n_div over the densest point, from one that matters to none up to one without curvature.
  LengthOfFraction best;
  double least = std::numeric_limits<double>::infinity();
  constexpr int kTrials = 400;
  for (int k = 0; k <= kTrials; ++k) {
    const double diverging = densest * (1 + std::pow(10, -5 + 6.0 * k / kTrials));
    const Branch branch = branch_at(points, diverging);
    if (branch.left >= least) continue;
    least = branch.left;
    best.diverging = diverging;
    best.smallest = std::exp(branch.log_smallest);
  }
  best.peak = densest;
  return best;
}

}  // namespace diefill::process::continuum
