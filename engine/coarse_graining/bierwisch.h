// Coarse graining after Bierwisch 2009, chapter 3: grains enlarged so that every form of energy keeps its
// density and its rate of loss. It changes the material before a run; the laws stay as they are.
#pragma once

namespace diefill::engine::coarse_graining {

/// A powder whose scaled quantities are absolute numbers at one grain size. SI units.
struct Material {
  double sphere_radius = 0;     ///< m, R
  double grain_mass = 0;        ///< kg
  double reduced_modulus = 0;   ///< Pa, unchanged
  double damping = 0;           ///< Pa s, gamma_n, scales with R
  double tangential = 0;        ///< N/m, kappa_t, scales with R
  double work_of_adhesion = 0;  ///< J/m^2, w, scales with R
  double rolling_friction = 0;  ///< m, mu_r, scales with R (a length, OP-29)
  double air_viscosity = 0;     ///< Pa s, mu_a, scales with R (OP-8)
  double friction = 0;          ///< mu, unchanged
};

/// The coarse material that represents `fine` when lengths of grains grow by `scale` (Bierwisch 2009, Eqs.
/// 3.1, 3.7; mu_r and mu_a as in OP-29, OP-8): w, gamma_n, kappa_t, mu_r, mu_a grow with `scale`, mass with
/// its cube. Collision time, overlap and the admissible time step then grow with `scale` too.
inline Material bierwisch(const Material& fine, double scale) {
  Material coarse = fine;
  coarse.sphere_radius *= scale;
  coarse.grain_mass *= scale * scale * scale;
  coarse.damping *= scale;
  coarse.tangential *= scale;
  coarse.work_of_adhesion *= scale;
  coarse.rolling_friction *= scale;
  coarse.air_viscosity *= scale;
  return coarse;
}

}  // namespace diefill::engine::coarse_graining
