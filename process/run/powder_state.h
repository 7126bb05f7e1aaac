// The powder of a running simulation as results describe it.
#pragma once

#include "process/results/fill_result.h"
#include "process/scene/scene.h"
#include "process/tooling/die_frame.h"

namespace diefill::engine {
class Simulation;
struct GrainShape;
}  // namespace diefill::engine

namespace diefill::process {

/// Grains as they are now, laboratory frame, all of `shape` and `grain_diameter` (m).
results::PowderState powder_state(const engine::Simulation& simulation, const engine::GrainShape& shape,
                                  double grain_diameter);
/// The same with the particle types of the scene.
results::PowderState powder_state(const Scene& scene, const engine::Simulation& simulation);

/// What contacts carry through every grain now, in the frame of `die`.
results::ContactStress contact_stress(const engine::Simulation& simulation, const DieFrame& die);

}  // namespace diefill::process
