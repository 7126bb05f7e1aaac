// Kottlan's particle scaling: an exact similarity map, not coarse graining, as every scaled grain stands for
// one real grain and all forces and masses stay (Kottlan 2018, Eqs. 24 to 30).
#pragma once

#include <cmath>

namespace diefill::engine::coarse_graining {

/// Scaled over real quantities for lengths times SF under unchanged gravity: masses and forces stay, times go
/// with sqrt(SF). Friction, restitution, plasticity depth, stiffness ratios and strains are unchanged.
struct KottlanSimilarity {
  double scale = 1;  ///< SF = r / r_real

  double length() const { return scale; }
  double mass() const { return 1; }
  double force() const { return 1; }
  double density() const { return 1 / (scale * scale * scale); }
  double modulus() const { return 1 / (scale * scale); }  ///< and stress
  double time() const { return std::sqrt(scale); }
  double velocity() const { return std::sqrt(scale); }
  double angular_velocity() const { return 1 / std::sqrt(scale); }
  double acceleration() const { return 1; }
  double stiffness() const { return 1 / scale; }           ///< N/m
  double damping() const { return 1 / std::sqrt(scale); }  ///< kg/s
  double torque() const { return scale; }
  double energy() const { return scale; }  ///< and the Hamaker constant
};

}  // namespace diefill::engine::coarse_graining
