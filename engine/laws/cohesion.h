// Cohesion between touching spheres: none, or Bierwisch's JKR term with the Hertzian contact radius.
#pragma once

#include <cmath>
#include <numbers>

namespace diefill::engine::laws {

/// No cohesion; leaves no trace in the pair loop.
struct NoCohesion {
  NoCohesion() = default;
  NoCohesion(double, double, double) {}
  double force(double, double) const { return 0; }
  double energy(double) const { return 0; }
};

/// f = -sqrt(4 pi w E~) R_eff^(3/4) h^(3/4), attractive, opening at h = 0 (Bierwisch 2009, Eq. 2.4).
/// With Hertz' repulsion the net force has its minimum -3/2 pi w R_eff at h_min (Eq. 2.5).
struct HertzianCohesion {
  double coefficient = 0;  ///< N/m^(3/4), sqrt(4 pi w E~) R_eff^(3/4)

  HertzianCohesion() = default;
  /// `work_of_adhesion` w in J/m^2, `reduced_modulus` E~ in Pa, `effective_radius` in m.
  HertzianCohesion(double work_of_adhesion, double reduced_modulus, double effective_radius)
      : coefficient(std::sqrt(4 * std::numbers::pi * work_of_adhesion * reduced_modulus) *
                    std::pow(effective_radius, 0.75)) {}

  /// Force in N (negative) at overlap h in m, given sqrt(h): h^(3/4) = sqrt(h sqrt(h)).
  double force(double overlap, double root_overlap) const {
    return -coefficient * std::sqrt(overlap * root_overlap);
  }
  /// Energy in J (negative): -4/7 c h^(7/4).
  double energy(double overlap) const { return -4.0 / 7.0 * coefficient * std::pow(overlap, 1.75); }
};

}  // namespace diefill::engine::laws
