// Contact radius of two adhesive spheres after Johnson, Kendall and Roberts: in closed form, and by a fixed
// number of Newton's steps, which many contacts can take side by side.
#pragma once

#include <cmath>

namespace diefill::engine::laws {

/// Largest root a (m) of a^4 - 2 X a^2 - q a + X^2 = 0 (Hu 2024, Eq. 2.23) for X = R* h >= 0 (m^2) and
/// q = 4 pi gamma R*^2 / E* >= 0 (m^3). Ferrari's solution arranged so that nearly equal numbers are never
/// subtracted: the usual form loses the root altogether for weak adhesion. q = 0 gives Hertz' sqrt(X), X = 0
/// gives q^(1/3).
inline double jkr_contact_radius(double X, double q) {
  const double e = q * q / 16 + q * std::sqrt(X * X * X / 27 + q * q / 256);
  const double b = 2.0 / 3.0 * X;
  const double U = std::cbrt(b * b * b + e);
  const double safe = U > 0 ? U : 1;  // U = 0 only where X = q = 0, and then everything below is zero
  const double d = e / (safe * safe + safe * b + b * b);
  const double w = std::sqrt(2 * (U + b) * (U + b) / safe - 4.0 / 3.0 * X);
  const double rest = 2 * q / (w > 0 ? w : 1) - 2 * d * d / safe;
  return 0.5 * (w + std::sqrt(rest > 0 ? rest : 0));
}

/// The same root by Newton's method on y^4 - g y - X = 0, a = y^2, g = sqrt(q). `adhesive_start` is (2
/// g)^(1/3), the same for every overlap of a pair. The start lies above the root by a fourth at most and the
/// function is convex there, so that seven steps reach the last bits.
inline double jkr_contact_radius_newton(double X, double g, double adhesive_start) {
  const double elastic_start = std::sqrt(std::sqrt(2 * X));
  const double start = elastic_start > adhesive_start ? elastic_start : adhesive_start;
  double y = start > 0 ? start : 1;
  for (int step = 0; step < 7; ++step) {
    const double cube = y * y * y;
    y -= (y * (cube - g) - X) / (4 * cube - g);
  }
  return start > 0 ? y * y : 0;
}

}  // namespace diefill::engine::laws
