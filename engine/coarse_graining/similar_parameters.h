// Coarse graining by parameters: after Bierwisch for Hertz' spring, after Thakur et al. for linear ones. Each
// law's part states how its parameters scale (`similar` in laws/parts.h), so that both rules are one
// function.
#pragma once

#include "engine/laws/law_parameters.h"

namespace diefill::engine::coarse_graining {

/// Parameters of the ordinary law for grains `scale` l times as large: linear stiffnesses grow with l and
/// pull-off forces with l^2 (Thakur et al.); for Hertz' spring modulus, restitution and friction stay and the
/// energy of adhesion grows with l (Bierwisch 2009, Eq. 3.7). Torques stay force times radius: no torque
/// factor.
inline laws::LawParameters similar_parameters(const laws::LawParameters& fine, double scale) {
  return fine.similar(scale);
}

}  // namespace diefill::engine::coarse_graining
