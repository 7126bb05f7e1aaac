// Nodes and weights of Gauss-Legendre quadrature on 0..1.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace diefill::process {

inline constexpr int kGaussPoints = 12;

/// Pairs of place and weight: exact for polynomials of degree 23 on 0..1.
inline const std::array<std::pair<double, double>, kGaussPoints>& gauss_legendre() {
  static const auto rule = [] {
    std::array<std::pair<double, double>, kGaussPoints> points;
    for (int k = 0; k < kGaussPoints; ++k) {
      double place = std::cos(std::numbers::pi * (k + 0.75) / (kGaussPoints + 0.5)), slope = 1;
      for (int iteration = 0; iteration < 20; ++iteration) {
        double polynomial = place, before = 1;
        for (int n = 2; n <= kGaussPoints; ++n) {
          const double next = ((2 * n - 1) * place * polynomial - (n - 1) * before) / n;
          before = std::exchange(polynomial, next);
        }
        slope = kGaussPoints * (place * polynomial - before) / (place * place - 1);
        place -= polynomial / slope;
      }
      points[static_cast<std::size_t>(k)] = {0.5 * (1 - place), 1 / ((1 - place * place) * slope * slope)};
    }
    return points;
  }();
  return rule;
}

}  // namespace diefill::process
