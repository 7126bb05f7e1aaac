// Coulomb friction with a tangential spring (Bierwisch 2009, Eq. 2.7).
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace diefill::engine::laws {

/// No friction: no tangential force and no history.
struct NoFriction {
  static constexpr bool kHasSpring = false;
  NoFriction() = default;
  NoFriction(double, double, double) {}
  Eigen::Vector3d force(Eigen::Vector3d&, const Eigen::Vector3d&, const Eigen::Vector3d&, double, double,
                        double) const {
    return Eigen::Vector3d::Zero();
  }
};

/// f_t = -min[kappa_t sqrt(h / R_eff) |xi|, mu |f_e + f_v|] xi / |xi| (Bierwisch 2009, Eq. 2.7). The Coulomb
/// limit is taken without cohesion. The spring xi is turned into the tangent plane keeping its length (OP-4),
/// then stretched by the tangential velocity. `kCutBack`: while sliding, the spring is shortened so that it
/// never holds more than the Coulomb limit (OP-1, Cundall); without, it goes on stretching, which the thesis'
/// wording also allows.
template <bool kCutBack>
struct TangentialSpring {
  static constexpr bool kHasSpring = true;
  double coefficient = 0;  ///< N/m^(3/2), kappa_t / sqrt(R_eff)
  double friction = 0;     ///< mu

  TangentialSpring() = default;
  /// `tangential` kappa_t in N/m, `friction_coefficient` mu, `effective_radius` in m.
  TangentialSpring(double tangential, double friction_coefficient, double effective_radius)
      : coefficient(tangential / std::sqrt(effective_radius)), friction(friction_coefficient) {}

  /// Advances `spring` (m) over `time_step` (s) and returns the force on i in N. `normal` points from j to i,
  /// `tangential_velocity` is that of i's surface against j's (m/s), `normal_load` is |f_e + f_v| in N.
  [[gnu::always_inline]] Eigen::Vector3d force(Eigen::Vector3d& spring, const Eigen::Vector3d& normal,
                                               const Eigen::Vector3d& tangential_velocity, double root_overlap,
                                               double normal_load, double time_step) const {
    const double length_before = spring.squaredNorm();
    spring -= spring.dot(normal) * normal;
    const double length_projected = spring.squaredNorm();
    if (length_projected > 0) spring *= std::sqrt(length_before / length_projected);
    spring += tangential_velocity * time_step;

    const double stiffness = coefficient * root_overlap;
    const double length = spring.norm();
    const double limit = friction * normal_load;
    if (stiffness * length <= limit) return -stiffness * spring;
    const Eigen::Vector3d force = spring * (-limit / length);
    if constexpr (kCutBack) spring *= limit / (stiffness * length);
    return force;
  }
};

}  // namespace diefill::engine::laws
