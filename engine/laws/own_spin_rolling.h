// Rolling friction against each grain's own spin (Bierwisch 2009, Eq. 2.11).
#pragma once

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"

namespace diefill::engine::laws {

/// Torque of mu_r times the sum of all loads on a grain, against the grain's own spin. The pair contributes
/// its load; the integrator of single spheres applies the torque once per grain and step, so that a grain at
/// rest stays at rest (sphere_integrator.h). Clumps interlock instead, and the loop refuses the part for
/// them.
struct OwnSpinRolling {
  struct Parameters {
    double arm = 0;  ///< m, mu_r
    void check() const { require_range("arm of rolling friction", arm, 0); }
    Parameters similar(double l) const { return {l * arm}; }
    double own_spin_arm() const { return arm; }
    void set_time_step(double) {}
  };
  static constexpr int kHistory = 0;
  static constexpr HistorySigns<0> kHistorySigns = {};
  static constexpr bool follows_time_step() { return false; }
  OwnSpinRolling(const Parameters&, const PairProperties&) {}
  Vector3 torque(double*, Vector3, Vector3, double, StaticForce, double, double) const { return {}; }
};

static_assert(RollingPart<OwnSpinRolling>);

}  // namespace diefill::engine::laws
