// Hertz with 2/3 E~ and the JKR term on the Hertzian contact radius (Bierwisch 2009, Eqs. 2.3, 2.4).
#pragma once

#include "engine/laws/cohesion.h"
#include "engine/laws/hertz.h"
#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"

namespace diefill::engine::laws {

/// The limit of friction and rolling is Hertz' force alone, without cohesion (Bierwisch 2009,
/// Eqs. 2.7, 2.11).
struct BierwischNormal {
  struct Parameters {
    double reduced_modulus = 1e7;  ///< Pa, E~ = E / (1 - nu^2)
    double work_of_adhesion = 0;   ///< J/m^2, w; 0: no cohesion
    void check() const {
      require_positive("reduced modulus", reduced_modulus);
      require_range("work of adhesion", work_of_adhesion, 0);
    }
    Parameters similar(double l) const { return {reduced_modulus, l * work_of_adhesion}; }
    bool attracts() const { return work_of_adhesion > 0; }
    bool includes_surface_forces() const { return work_of_adhesion > 0; }
    bool damping_in_load() const { return true; }
    double hertzian_modulus() const { return 0.5 * reduced_modulus; }
    double linear_stiffness() const { return 0; }
    bool set_work_of_adhesion(double w) {
      work_of_adhesion = w;
      return true;
    }
  };
  static constexpr int kHistory = 0;
  static constexpr HistorySigns<0> kHistorySigns = {};
  static constexpr bool hysteretic() { return false; }
  Hertz elastic;
  HertzianCohesion cohesion;

  BierwischNormal(const Parameters& given, const PairProperties& pair)
      : elastic(given.reduced_modulus, pair.effective_radius()),
        cohesion(given.work_of_adhesion, given.reduced_modulus, pair.effective_radius()) {}

  StaticForce force(double overlap, double root_overlap, double*) const {
    const double hertz = elastic.force(overlap, root_overlap);
    return {hertz + cohesion.force(overlap, root_overlap), hertz};
  }
  double energy(double overlap, const double*) const {
    return elastic.energy(overlap) + cohesion.energy(overlap);
  }
  /// Slope of Hertz' force alone, as cohesion only softens the spring.
  double stiffness(double overlap, const double*) const { return elastic.stiffness(std::sqrt(overlap)); }
};

static_assert(NormalPart<BierwischNormal>);

}  // namespace diefill::engine::laws
