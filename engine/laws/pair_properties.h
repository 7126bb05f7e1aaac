// The two spheres a contact law acts between, as plain numbers: what every part of a law is built from
// besides its own parameters.
#pragma once

#include <cmath>

namespace diefill::engine::laws {

/// Sizes and masses of a pair in SI units. A flat wall has infinite radius and mass; a wall sphere a finite
/// radius and infinite mass.
struct PairProperties {
  double radius_i = 0, radius_j = 0;  ///< m
  double mass_i = 0, mass_j = 0;      ///< kg
  /// Factor of moments of inertia in a torque of the law: above 1 where a coarse-graining rule weakens
  /// torques (Hu 2024, section 3.4).
  double inertia_factor = 1;

  /// a b / (a + b), also where one or both are infinite.
  static double reduced(double a, double b) {
    return std::isinf(a) ? b : (std::isinf(b) ? a : a * b / (a + b));
  }
  /// m, R_i R_j / (R_i + R_j).
  double effective_radius() const { return reduced(radius_i, radius_j); }
  /// kg, m_i m_j / (m_i + m_j).
  double effective_mass() const { return reduced(mass_i, mass_j); }
  /// kg m^2, I_i I_j / (I_i + I_j) of solid spheres, times the inertia factor.
  double effective_inertia() const {
    return inertia_factor * reduced(0.4 * mass_i * radius_i * radius_i, 0.4 * mass_j * radius_j * radius_j);
  }
  /// Whether one of the two is a wall.
  bool with_wall() const { return std::isinf(mass_i) || std::isinf(mass_j); }
};

}  // namespace diefill::engine::laws
