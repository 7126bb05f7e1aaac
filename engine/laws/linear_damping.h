// Dashpots of constant coefficient: given outright, or from a coefficient of restitution.
#pragma once

#include <cmath>

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"
#include "engine/laws/restitution.h"

namespace diefill::engine::laws {

/// f = -gamma v.
struct ConstantDamping {
  struct Parameters {
    double coefficient = 0;  ///< kg/s, gamma
    void check() const { require_range("damping coefficient", coefficient, 0); }
    Parameters similar(double l) const { return {l * l * coefficient}; }
    bool dissipates() const { return coefficient > 0; }
  };
  double coefficient;  ///< kg/s

  ConstantDamping(const Parameters& given, const PairProperties&) : coefficient(given.coefficient) {}
  double force(double, double, double separation_speed) const { return -coefficient * separation_speed; }
  double damping(double, double) const { return coefficient; }
};

/// gamma = sqrt(4 M k_1 / (1 + (pi / ln e)^2)) with the reduced mass M (Kottlan 2018, Eq. 7; the printed
/// mass, Eq. 8, is twice that and returns too little).
struct LinearRestitutionDamping {
  struct Parameters {
    double restitution = 0.5;  ///< e of the undeformed linear spring, 0 to 1
    double stiffness = 100;    ///< N/m, k_1 of the spring it damps
    void check() const {
      require_range("coefficient of restitution", restitution, 0, 1);
      require_positive("stiffness", stiffness);
    }
    Parameters similar(double l) const { return {restitution, l * stiffness}; }
    bool dissipates() const { return restitution < 1; }
  };
  double coefficient;  ///< kg/s

  LinearRestitutionDamping(const Parameters& given, const PairProperties& pair)
      : coefficient(2 * restitution_damping_ratio(given.restitution) *
                    std::sqrt(pair.effective_mass() * given.stiffness)) {}
  double force(double, double, double separation_speed) const { return -coefficient * separation_speed; }
  double damping(double, double) const { return coefficient; }
};

static_assert(DampingPart<ConstantDamping> && DampingPart<LinearRestitutionDamping>);

}  // namespace diefill::engine::laws
