// What a contact law is told about a contact and what it answers.
#pragma once

#include "engine/vector3.h"

namespace diefill::engine::laws {

/// A pair of spheres at one instant, laboratory frame.
struct ContactState {
  double overlap = 0;     ///< m, positive in contact
  Vector3 normal;         ///< from j to i
  Vector3 velocity;       ///< m/s, of i against j where they touch
  Vector3 relative_spin;  ///< rad/s, angular velocity of i less that of j; only for laws that roll
  double time_step = 0;   ///< s
};

/// What the pair does to each other. Powers are those of forces on the powder: negative when taken out.
struct Reaction {
  Vector3 force;                ///< N on i; j receives the opposite
  Vector3 couple;               ///< N m on i besides the force's moment; j receives the opposite
  double load = 0;              ///< N, what Coulomb's limit was taken of
  double viscous_power = 0;     ///< W, of normal damping (and of normal forces that hold no energy)
  double tangential_power = 0;  ///< W, of friction
  double rolling_power = 0;     ///< W, of the couple
};

}  // namespace diefill::engine::laws
