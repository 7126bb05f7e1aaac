// Coarse graining by force scaling: the contact of large grains is evaluated as that of the original small
// ones, and its forces are multiplied (Hu 2024, chapter 3). The published rules differ in one set of
// exponents.
#pragma once

#include <cmath>

#include "engine/laws/pair_properties.h"

namespace diefill::engine::coarse_graining {

/// Exponents of the scale l = d_S / d_O (S: scaled, O: original): F_S = l^force F_O and so on, overlap
/// h_O = h_S / l^overlap. Speeds are equal, spins omega_O = l omega_S (Hu 2024, Eqs. 3.32, 3.33).
struct ForceScaling {
  double scale = 1;                ///< l
  double force_exponent = 0;       ///< contact forces
  double attraction_exponent = 0;  ///< distant attraction
  double torque_exponent = 1;      ///< torques about a grain's centre
  double overlap_exponent = 1;     ///< 1: geometrically similar, 0: overlap taken as it is
  double gap_exponent = 1;         ///< the same for gaps
  double spring_exponent = 1;      ///< the same for the stretch of the tangential spring
  /// The spring stretches unscaled, xi_O = xi_S, however overlaps are scaled: the literal reading of Hu 2024,
  /// which makes the spring l times stiffer.
  bool literal_spring = false;
  /// Rolling springs turn by omega_O dt_S instead of the similar omega_S dt_S: literal, l times stiffer.
  bool literal_rolling = false;

  /// Factor of the sum of all torques on a grain, force times its lever arm plus the torques of ScaledLaw:
  /// l^(torque - force - 1). Its inverse is the factor of the moment of inertia with which energy and angular
  /// momentum balance.
  double torque_factor() const { return std::pow(scale, torque_exponent - force_exponent - 1); }

  /// The original pair that `scaled` represents: lengths over l, masses over l^3. The inertia factor makes
  /// caps and stability limits of rolling parts those of the scaled grains.
  laws::PairProperties original(const laws::PairProperties& scaled) const {
    const double volume = scale * scale * scale;
    return {scaled.radius_i / scale, scaled.radius_j / scale, scaled.mass_i / volume, scaled.mass_j / volume,
            scaled.inertia_factor * std::pow(scale, 3 - torque_exponent)};
  }

  /// Factor by which a Hertz or Mindlin spring is stiffer than the same law at the scaled size: l^(force -
  /// 1/2 - 3 overlap / 2). Time steps must shrink by its root (Hu 2024, section 4.3).
  double spring_factor() const { return std::pow(scale, force_exponent - 0.5 - 1.5 * overlap_exponent); }
  /// The same for damping that goes with sqrt(m) h^(1/4): l^(force - 7/4 - overlap / 4).
  double damping_factor() const { return std::pow(scale, force_exponent - 1.75 - 0.25 * overlap_exponent); }
};

}  // namespace diefill::engine::coarse_graining
