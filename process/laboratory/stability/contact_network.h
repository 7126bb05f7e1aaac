// Touching grains as a network of linear springs: its fastest oscillation is what a time step must resolve.
#pragma once

#include "engine/simulation/simulation.h"

namespace diefill::process::laboratory {

/// Stiffness of the springs between spheres and of those with a floor at z = 0.
struct NetworkSprings {
  double normal_modulus = 0;  ///< Pa, E~: k_n = E~ sqrt(R_eff h), the slope of Hertz' force
  double tangential = 0;      ///< N/m, kappa_t: k_t = kappa_t sqrt(h / R_eff); 0: free sliding
};

/// rad/s, largest eigenfrequency of the network of contacts as they are now, linearised, without damping and
/// sliding: the root of the largest eigenvalue of M^-1/2 K M^-1/2, by power iteration. Contacts are found
/// from the grains' positions; `period` of the simulation is respected. 0 where nothing touches.
double largest_eigenfrequency(const engine::Simulation& simulation, const NetworkSprings& springs);

}  // namespace diefill::process::laboratory
