// Design of a wedge hopper for mass flow from a shear test (Jenike's procedure; Kottlan 2018, section 3.4):
// half angle and slot width at which powder does not arch.
#pragma once

#include "engine/simulation/standard_gravity.h"

namespace diefill::process::continuum {

/// What a shear tester says about a powder at one consolidation.
struct ShearTest {
  double preshear_normal = 3e3;  ///< Pa, sigma_p
  double preshear = 0;           ///< Pa, tau_p, steady shear stress at sigma_p
  double slope = 0;              ///< k of the yield locus tau = k sigma + tau_0
  double cohesion = 0;           ///< Pa, tau_0
  double wall_angle = 0;         ///< deg, phi_x, of wall friction
  double bulk_density = 0;       ///< kg/m^3
};

/// The hopper for that powder.
struct WedgeHopper {
  double effective_angle = 0;  ///< deg, phi_e, effective angle of internal friction
  double half_angle = 0;       ///< deg, alpha, the largest from the vertical with mass flow
  double flow_factor = 0;      ///< ff
  double strength = 0;         ///< Pa, f_c, unconfined
  double slot_width = 0;       ///< m, the smallest without an arch
};

/// One consolidation level, so that the strength is taken as constant, which gives an upper bound of the slot
/// width. Where the pre-shear point lies above the locus, the Mohr circle touches the locus at sigma_p.
/// Throws std::invalid_argument, in one line, for values that are not positive, for a wall angle of phi_e or
/// more, and where no half angle above 0 has mass flow.
WedgeHopper wedge_hopper(const ShearTest& test, double gravity = engine::kStandardGravity);

}  // namespace diefill::process::continuum
