// Damping of Hertz' spring that gives one coefficient of restitution at every impact speed (Hu 2024,
// Eqs. 2.24, 2.27; Tsuji et al. 1992).
#pragma once

#include <cmath>

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"
#include "engine/laws/restitution.h"

namespace diefill::engine::laws {

/// f = -2 sqrt(5/3) (-beta) sqrt(m* E*) (R* h)^(1/4) v. The total normal force may attract shortly before the
/// spheres separate; clipping it there would change the restitution.
struct RestitutionDamping {
  struct Parameters {
    double restitution = 0.5;  ///< e, 0 to 1
    double modulus = 1e7;      ///< Pa, E* of the spring it damps
    void check() const {
      require_range("coefficient of restitution", restitution, 0, 1);
      require_positive("modulus E*", modulus);
    }
    Parameters similar(double) const { return *this; }
    bool dissipates() const { return restitution < 1; }
  };
  double coefficient;  ///< kg/(s m^(1/4))

  RestitutionDamping(const Parameters& given, const PairProperties& pair)
      : coefficient(2 * std::sqrt(5.0 / 3.0) * restitution_damping_ratio(given.restitution) *
                    std::sqrt(pair.effective_mass() * given.modulus * std::sqrt(pair.effective_radius()))) {}
  double force(double, double root_overlap, double separation_speed) const {
    return -coefficient * std::sqrt(root_overlap) * separation_speed;
  }
  double damping(double, double root_overlap) const { return coefficient * std::sqrt(root_overlap); }
};

static_assert(DampingPart<RestitutionDamping>);

}  // namespace diefill::engine::laws
