// Rolling resistance by a constant directional torque: opposes the relative spin with a strength that does
// not depend on speed (Hu 2024, Eq. 2.51; Kottlan 2018, Eq. 23).
//
// As printed the torque does not vanish with the spin: in a grain at rest it reverses every step, and the
// energy that it seems to remove stays in the grain. Here it reverses gradually: every step it changes,
// against the relative spin, by a sixteenth of what would stop the spin of the pair within that step, up to
// the printed size. It equals the printed torque except in the few steps after a start or a reversal, in
// which the pair rolls by 16 |torque| dt^2 / I; at rest it is static and stores no more than an elastic
// spring does. Springs of a grain's contacts add up: the step is too long when the shares of its contacts
// reach 2, which takes 32 contacts (STABILITY.md, rolling resistance).
#pragma once

#include <cmath>

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"
#include "engine/laws/spring_history.h"

namespace diefill::engine::laws {

/// Of the torque that stops the relative spin of a pair within one step.
inline constexpr double kShareOfStopping = 1.0 / 16;

/// N m s, torque gained in a step over the relative spin; nothing where no time passes.
inline double torque_gained(double inertia, double time_step) {
  return time_step > 0 ? kShareOfStopping * inertia / time_step : 0.0;
}

/// mu_r R* load against the relative spin in the contact plane (Hu 2024, Eq. 2.51).
struct LoadRolling {
  struct Parameters {
    double rolling_friction = 0;  ///< mu_r
    void check() const { require_range("rolling friction coefficient", rolling_friction, 0); }
    Parameters similar(double) const { return *this; }
    double own_spin_arm() const { return 0; }
    void set_time_step(double) {}
  };
  static constexpr int kHistory = 3;  ///< torque on i, N m
  static constexpr HistorySigns<3> kHistorySigns = kVectorSigns;
  static constexpr bool follows_time_step() { return true; }
  double arm;      ///< m, mu_r R*
  double inertia;  ///< kg m^2, reduced

  LoadRolling(const Parameters& given, const PairProperties& pair)
      : arm(given.rolling_friction * pair.effective_radius()), inertia(pair.effective_inertia()) {}

  Vector3 torque(double* history, Vector3 normal, Vector3 relative_spin, double, StaticForce, double load,
                 double time_step) const {
    const Vector3 trial =
        in_plane(load_vector(history) - torque_gained(inertia, time_step) * relative_spin, normal);
    const Vector3 torque = shortening(length(trial), arm * load) * trial;
    store_vector(history, torque);
    return torque;
  }
};

/// mu_r k_1 h R against the whole relative spin, its part along the normal then left out (Kottlan 2018,
/// Eq. 23): the elastic product, not the force, so that a contact held by cohesion alone still resists.
struct ElasticRolling {
  struct Parameters {
    double rolling_friction = 0;  ///< mu_roll
    double stiffness = 100;       ///< N/m, k_1 of the normal spring
    bool harmonic_mean = false;   ///< length 2 R_ij as printed instead of R_ij
    void check() const {
      require_range("rolling friction coefficient", rolling_friction, 0);
      require_positive("stiffness", stiffness);
    }
    Parameters similar(double l) const { return {rolling_friction, l * stiffness, harmonic_mean}; }
    double own_spin_arm() const { return 0; }
    void set_time_step(double) {}
  };
  static constexpr int kHistory = 3;  ///< torque on i before its part along the normal is left out, N m
  static constexpr HistorySigns<3> kHistorySigns = kVectorSigns;
  static constexpr bool follows_time_step() { return true; }
  double coefficient;  ///< N, mu_roll k_1 R
  double inertia;      ///< kg m^2, reduced

  ElasticRolling(const Parameters& given, const PairProperties& pair)
      : coefficient(given.rolling_friction * given.stiffness * pair.effective_radius() *
                    (given.harmonic_mean ? 2 : 1)),
        inertia(pair.effective_inertia()) {}

  Vector3 torque(double* history, Vector3 normal, Vector3 relative_spin, double root_overlap, StaticForce,
                 double, double time_step) const {
    const Vector3 trial = load_vector(history) - torque_gained(inertia, time_step) * relative_spin;
    const Vector3 whole = shortening(length(trial), coefficient * root_overlap * root_overlap) * trial;
    store_vector(history, whole);
    return in_plane(whole, normal);
  }
};

static_assert(RollingPart<LoadRolling> && RollingPart<ElasticRolling>);

}  // namespace diefill::engine::laws
