// Coarse graining by parameters: after Thakur et al. for linear springs, after Bierwisch for Hertz.
#pragma once

#include "engine/laws/law_parameters.h"

namespace diefill::engine::coarse_graining {

/// Parameters of the ordinary law for grains l times as large: linear stiffnesses grow with l and pull-off
/// forces with l^2 (Thakur et al.); for Hertz' spring modulus, restitution and friction stay and the energy
/// of adhesion grows with l (Bierwisch 2009, Eq. 3.7). Torques stay force times radius: no torque factor.
inline laws::LawParameters thakur(const laws::LawParameters& fine, double scale) {
  return fine.similar(scale);
}

}  // namespace diefill::engine::coarse_graining
