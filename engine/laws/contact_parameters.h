// The material of a contact in absolute numbers, and the sphere pair it acts between. SI units.
#pragma once

#include <cmath>

namespace diefill::engine {

/// Parameters of the contact laws (Bierwisch 2009, section 2.1). For grain-wall contacts damping and
/// tangential stiffness are the powder's absolute values and R_eff comes from both radii (OP-5).
struct ContactParameters {
  double reduced_modulus = 1e7;  ///< Pa, E~ = E / (1 - nu^2)
  double damping = 0;            ///< Pa s, gamma_n; 0: undamped
  double tangential = 0;         ///< N/m, kappa_t
  double friction = 0;           ///< mu; 0: no tangential force at all
  double work_of_adhesion = 0;   ///< J/m^2, w; 0: no cohesion
  double rolling_friction = 0;   ///< m, mu_r, model B only; 0: none
};

/// A plane of this material acts on spheres of `grain` as their mirror images behind the plane would: an
/// image overlaps twice as far as the plane, comes twice as fast, and slides along. No friction.
inline ContactParameters mirror_plane(const ContactParameters& grain) {
  ContactParameters plane = grain;
  plane.reduced_modulus *= 2;
  plane.damping *= 2;
  plane.work_of_adhesion /= 2;
  plane.tangential = plane.friction = 0;
  return plane;
}

/// Which point of a grain a contact force acts on, and whose velocity is compared there.
enum class LeverArm {
  none,     ///< grains do not rotate (model A)
  surface,  ///< the end of the sphere's radius along the normal (Bierwisch 2009, Eq. 2.10)
  center,   ///< the basic sphere's centre, as Eqs. 2.16 and 2.26 read literally (OP-2)
  contact   ///< the contact point; conserves angular momentum (OP-2)
};

/// Whether the tangential spring is cut back to the Coulomb limit while sliding (OP-1).
enum class SpringLimit { cut_back, free };

/// R_i R_j / (R_i + R_j) in m; R_i against a plane, whose radius is infinite.
inline double effective_radius(double radius_i, double radius_j) {
  return std::isinf(radius_j) ? radius_i : radius_i * radius_j / (radius_i + radius_j);
}

}  // namespace diefill::engine
