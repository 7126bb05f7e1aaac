// Input and output of a contact law: relative motion of a pair; force, torque and powers.
#pragma once

#include "engine/numerics/vector3.h"

namespace diefill::engine::laws {

/// Relative motion of a pair, laboratory frame.
struct ContactState {
  double overlap = 0;               ///< m, positive in contact, minus the gap otherwise
  Vector3 normal = {};              ///< unit vector from j to i
  Vector3 velocity = {};            ///< m/s, of i against j where they touch
  Vector3 spin = {};                ///< rad/s, omega_i - omega_j
  double time_step = 0;             ///< s, springs of friction advance by it
  double rolling_step = time_step;  ///< s, springs of rolling advance by it; differs where forces are scaled
};

/// A contact between the stages of a law (ContactLaw).
struct StretchedContact {
  double overlap;           ///< m
  double root_overlap;      ///< m^(1/2)
  double separation_speed;  ///< m/s, along the normal
  Vector3 sliding;          ///< m/s, across it
};

/// What the law does to the pair, and the power of each kind of force for the energy balance. A negative
/// power removes energy from the motion.
struct Reaction {
  Vector3 force = {};           ///< N, on i; the opposite on j
  Vector3 torque = {};          ///< N m, on i besides force times lever arm; the opposite on j
  double load = 0;              ///< N, what Coulomb's limit was taken of
  double viscous = 0;           ///< N, damping's part of the normal force
  double attraction = 0;        ///< N, the distant part of the normal force, negative
  double normal_power = 0;      ///< W, of the static normal force; what it gives back is contact_energy
  double viscous_power = 0;     ///< W
  double friction_power = 0;    ///< W, spring and slip together
  double rolling_power = 0;     ///< W
  double attraction_power = 0;  ///< W
};

}  // namespace diefill::engine::laws
