// What a simulation computes: powder, laws, numerics. Everything in it is worked out from this and
// from the walls (simulation_parts.h).
#pragma once

#include <optional>
#include <vector>

#include "engine/contact/air_flow.h"
#include "engine/laws/contact_parameters.h"
#include "engine/numerics/vector_instructions.h"
#include "engine/powder/particle_types.h"
#include "engine/powder/periodic_box.h"
#include "engine/simulation/sleeping.h"
#include "engine/simulation/standard_gravity.h"

namespace diefill::engine {

/// All that stays the same during a run, unless Simulation says otherwise. SI units.
struct SimulationSettings {
  std::vector<ParticleType> types = {{}};  ///< of the powder; grains refer to them by number
  /// Between all materials of grains, and of grains with walls.
  ContactLaws contact = one_powder({}, {});
  /// Of clumps; single spheres have none or their surface, after GrainShape::rotates.
  LeverArm lever_arm = LeverArm::contact;
  Eigen::Vector3d gravity = {0, 0, -kStandardGravity};  ///< m/s^2
  double air_viscosity = 0;         ///< Pa s, Stokes drag on every sphere (Bierwisch 2009, Eq. 2.9)
  std::optional<AirFlow> air_flow;  ///< air that a tool draws through the powder; not where grains sleep
  double time_step = 0;             ///< s
  PeriodLengths period;             ///< m, box centred on the origin
  double skin = 0;                  ///< m; 0: follows the motion of the powder
  /// Motion of tools far from all powder does not make the neighbour list too old.
  bool skip_far_walls = true;
  std::optional<SleepSettings> sleep;  ///< settled grains are put to sleep
  int threads = 1;
  InstructionSet instructions = best_instruction_set();  ///< all give the same bits

  /// Of the first type, which is the only one of most powders.
  GrainShape& shape() { return types.front().shape; }
  const GrainShape& shape() const { return types.front().shape; }
};

}  // namespace diefill::engine
