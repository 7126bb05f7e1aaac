// Coulomb friction with a tangential spring (Bierwisch 2009, Eq. 2.7).
#pragma once

#include <cmath>

#include "engine/numerics/reciprocal_root.h"
#include "engine/numerics/vector3.h"

namespace diefill::engine::laws {

/// No friction: no tangential force and no history.
struct NoFriction {
  static constexpr int kHistory = 0;
  NoFriction() = default;
  NoFriction(double, double, double) {}
  void turn(double*, Vector3) const {}
  void stretch(double*, Vector3, double) const {}
  Vector3 limited(double*, double, double) const { return {}; }
};

/// f_t = -min[kappa_t sqrt(h / R_eff) |xi|, mu |f_e + f_v|] xi / |xi| (Bierwisch 2009, Eq. 2.7). The Coulomb
/// limit is taken without cohesion. The spring xi is turned into the tangent plane keeping its length (OP-4),
/// then stretched by the tangential velocity. `kCutBack`: while sliding, the spring is shortened so that it
/// never exceeds the Coulomb limit (OP-1, Cundall); without, it continues to stretch, which the wording of
/// the dissertation also allows.
template <bool kCutBack>
struct TangentialSpring {
  static constexpr int kHistory = 3;
  double coefficient = 0;  ///< N/m^(3/2), kappa_t / sqrt(R_eff)
  double friction = 0;     ///< mu

  TangentialSpring() = default;
  /// `tangential` kappa_t in N/m, `friction_coefficient` mu, `effective_radius` in m.
  TangentialSpring(double tangential, double friction_coefficient, double effective_radius)
      : coefficient(tangential / std::sqrt(effective_radius)), friction(friction_coefficient) {}

  /// Advances the spring (`history`, 3 numbers, m) over `time_step` (s) and returns the force on i in N.
  /// `normal` points from j to i, `sliding` is the tangential velocity of i's surface against j's (m/s),
  /// `normal_load` is |f_e + f_v| in N.
  Vector3 force(double* history, Vector3 normal, Vector3 sliding, double root_overlap, double normal_load,
                double time_step) const {
    turn(history, normal);
    stretch(history, sliding, time_step);
    return limited(history, root_overlap, normal_load);
  }

  /// Turns the spring into the plane across `normal`, keeping its length.
  void turn(double* history, Vector3 normal) const {
    Vector3 spring{history[0], history[1], history[2]};
    const double squared = dot(spring, spring);
    spring -= dot(spring, normal) * normal;
    // The length before over that after; where the spring is 0, it stays so.
    spring = squared * reciprocal_root(squared * dot(spring, spring)) * spring;
    put(spring, history);
  }

  /// Stretches the spring by what surfaces slide on each other in `time_step` (s).
  void stretch(double* history, Vector3 sliding, double time_step) const {
    put(Vector3{history[0], history[1], history[2]} + time_step * sliding, history);
  }

  /// The force in N of the spring as it is now, up to the Coulomb limit.
  Vector3 limited(double* history, double root_overlap, double normal_load) const {
    Vector3 spring{history[0], history[1], history[2]};
    const double stiffness = coefficient * root_overlap;
    // Infinite for a spring of length 0, NaN without load: neither limits.
    const double limit_over_elastic = friction * normal_load / (stiffness * std::sqrt(dot(spring, spring)));
    const double share = limit_over_elastic < 1 ? limit_over_elastic : 1.0;
    const Vector3 force = (-stiffness * share) * spring;
    if constexpr (kCutBack) spring = share * spring;
    put(spring, history);
    return force;
  }

 private:
  static void put(Vector3 spring, double* history) {
    history[0] = spring.x;
    history[1] = spring.y;
    history[2] = spring.z;
  }
};

}  // namespace diefill::engine::laws
