// Hertz repulsion between spheres, in the form of Bierwisch 2009, Eq. 2.3.
#pragma once

#include <cmath>

namespace diefill::engine::laws {

/// f = 2/3 E~ sqrt(R_eff) h^(3/2), repulsive (Bierwisch 2009, Eq. 2.3). E~ = E / (1 - nu^2).
struct Hertz {
  double coefficient = 0;  ///< N/m^(3/2), 2/3 E~ sqrt(R_eff)

  Hertz() = default;
  /// `reduced_modulus` E~ in Pa, `effective_radius` R_i R_j / (R_i + R_j) in m.
  Hertz(double reduced_modulus, double effective_radius)
      : coefficient(2.0 / 3.0 * reduced_modulus * std::sqrt(effective_radius)) {}

  /// Force in N at overlap h in m, given sqrt(h).
  double force(double overlap, double root_overlap) const { return coefficient * overlap * root_overlap; }
  /// Energy stored in J: the integral of the force, 2/5 k h^(5/2).
  double energy(double overlap) const { return 0.4 * coefficient * overlap * overlap * std::sqrt(overlap); }
  /// Stiffness df/dh in N/m: 3/2 k sqrt(h) = E~ sqrt(R_eff h).
  double stiffness(double root_overlap) const { return 1.5 * coefficient * root_overlap; }
};

}  // namespace diefill::engine::laws
