// Normal damping of touching spheres (Bierwisch 2009, Eq. 2.6).
#pragma once

#include <cmath>

namespace diefill::engine::laws {

/// f = -gamma_n sqrt(R_eff h) v_n, with v_n the speed of separation; not clipped on separation (Eq. 2.6).
struct HertzianDamping {
  double coefficient = 0;  ///< kg/(s m^(1/2)), gamma_n sqrt(R_eff)

  HertzianDamping() = default;
  /// `damping` gamma_n in Pa s, `effective_radius` in m.
  HertzianDamping(double damping, double effective_radius)
      : coefficient(damping * std::sqrt(effective_radius)) {}

  /// Force in N at speed of separation (v_i - v_j) . n in m/s, given sqrt(h).
  double force(double root_overlap, double separation_speed) const {
    return -coefficient * root_overlap * separation_speed;
  }
  /// kg/s, what the speed is multiplied by, given sqrt(h).
  double at(double root_overlap) const { return coefficient * root_overlap; }
};

}  // namespace diefill::engine::laws
