// Rolling resistance by a constant directional torque: opposes the relative spin with a strength that does
// not depend on speed (Hu 2024, Eq. 2.51; Kottlan 2018, Eq. 23).
#pragma once

#include <cmath>
#include <limits>

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"
#include "engine/laws/spring_memory.h"

namespace diefill::engine::laws {

/// The torque does not fade with the spin, so a grain at rest chatters. The cap, torque < spin inertia / dt,
/// holds it below what would stop the relative spin of the pair within one time step, so that it never turns
/// it round. Uncapped: infinite inertia.
inline double capped_inertia(bool capped, const PairProperties& pair) {
  return capped ? pair.effective_inertia() : std::numeric_limits<double>::infinity();
}

/// Torque over relative spin in N m s, at most inertia / dt.
inline double torque_per_spin(double torque, double spin, double inertia, double time_step) {
  const double free = torque / (spin > 0 ? spin : 1.0);
  const double cap = inertia / time_step;
  return free < cap ? free : cap;
}

/// mu_r R* load against the relative spin in the contact plane (Hu 2024, Eq. 2.51).
struct LoadRolling {
  struct Parameters {
    double rolling_friction = 0;  ///< mu_r
    bool capped = false;
    void check() const { require_range("rolling friction coefficient", rolling_friction, 0); }
    Parameters similar(double) const { return *this; }
  };
  static constexpr int kMemory = 0;
  double arm;      ///< m, mu_r R*
  double inertia;  ///< kg m^2, reduced; infinite: no cap

  LoadRolling(const Parameters& given, const PairProperties& pair)
      : arm(given.rolling_friction * pair.effective_radius()), inertia(capped_inertia(given.capped, pair)) {}

  Vector3 torque(double*, Vector3 normal, Vector3 relative_spin, double, StaticForce, double load,
                 double time_step) const {
    const Vector3 rolling = in_plane(relative_spin, normal);
    return -torque_per_spin(arm * load, length(rolling), inertia, time_step) * rolling;
  }
};

/// mu_r k_1 h R against the whole relative spin, its part along the normal then left out (Kottlan 2018,
/// Eq. 23): the elastic product, not the force, so that a contact held by cohesion alone still resists.
struct ElasticRolling {
  struct Parameters {
    double rolling_friction = 0;  ///< mu_roll
    double stiffness = 100;       ///< N/m, k_1 of the normal spring
    bool harmonic_mean = false;   ///< length 2 R_ij as printed instead of R_ij
    bool capped = false;
    void check() const {
      require_range("rolling friction coefficient", rolling_friction, 0);
      require_positive("stiffness", stiffness);
    }
    Parameters similar(double l) const { return {rolling_friction, l * stiffness, harmonic_mean, capped}; }
  };
  static constexpr int kMemory = 0;
  double coefficient;  ///< N, mu_roll k_1 R
  double inertia;      ///< kg m^2, reduced; infinite: no cap

  ElasticRolling(const Parameters& given, const PairProperties& pair)
      : coefficient(given.rolling_friction * given.stiffness * pair.effective_radius() *
                    (given.harmonic_mean ? 2 : 1)),
        inertia(capped_inertia(given.capped, pair)) {}

  Vector3 torque(double*, Vector3 normal, Vector3 relative_spin, double root_overlap, StaticForce, double,
                 double time_step) const {
    const double torque = coefficient * root_overlap * root_overlap;
    return -torque_per_spin(torque, length(relative_spin), inertia, time_step) *
           in_plane(relative_spin, normal);
  }
};

static_assert(RollingPart<LoadRolling> && RollingPart<ElasticRolling>);

}  // namespace diefill::engine::laws
