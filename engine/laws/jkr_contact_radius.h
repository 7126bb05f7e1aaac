// Contact radius of two adhesive spheres after Johnson, Kendall and Roberts, in closed form.
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

}  // namespace diefill::engine::laws
