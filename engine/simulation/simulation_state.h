// All that a simulation holds, in the open: the phases of a step are functions on it, and so are the figures
// that are read from it (../observe).
#pragma once

#include <functional>
#include <memory>

#include "engine/contact/pair_loop.h"
#include "engine/integrate/grain_integrator.h"
#include "engine/numerics/per_worker.h"
#include "engine/numerics/phase_timers.h"
#include "engine/powder/particle_types.h"
#include "engine/search/adaptive_skin.h"
#include "engine/search/neighbour_list.h"
#include "engine/simulation/block_workspace.h"
#include "engine/simulation/energy_ledger.h"
#include "engine/simulation/settings.h"
#include "engine/simulation/sleeping.h"
#include "engine/walls/wall_load.h"

namespace diefill::engine {

/// Powder, tools, near pairs and accounts. Arrays of grains have the order of `grains`, arrays of bodies that
/// of `bodies`, arrays of blocks that of `list.blocks()`.
struct SimulationState {
  /// Without grains, at time 0. Throws std::invalid_argument for settings and walls that cannot work.
  SimulationState(const SimulationSettings& settings, std::vector<WallBodySpec> walls);

  // Worked out from the settings.
  ParticleTypes types;
  SimulationSettings settings;
  PeriodicBox box;
  std::unique_ptr<PairLoop> grain_loop, wall_loop;
  AdaptiveSkin skin;
  GrainIntegrator integrator;

  // Tools.
  std::vector<WallBody> bodies;
  std::vector<BodyMotion> body_motion;  ///< at the present time
  std::vector<WallLoad> wall_loads;     ///< in the last step

  // Powder.
  Grains grains;
  SphereField spheres;  ///< as the last contact computation saw them, grain after grain, images last
  SleepState sleep;     ///< empty where no grains are put to sleep

  // Near pairs, with the history of those that touch.
  NeighbourList list;
  ListReference reference;
  /// m a block, how much farther its spheres may surely move before the list is too old; 0: not known.
  std::vector<double> remaining_skin;
  std::vector<std::uint8_t> mixed_block;  ///< of a block, whether it has grains of both groups of `reference`
  std::vector<double> clearance;  ///< m a body, how far it stood from the powder when contacts were searched
  std::vector<BlockTally> tallies;  ///< what each block did in the last step

  /// Told of every grain that is put back into the periodic box: its place in `grains`, and where it was and
  /// is now (m). Empty: nobody asks.
  std::function<void(std::size_t, const Eigen::Vector3d&, const Eigen::Vector3d&)> border_watch;

  // Time and accounts.
  std::uint64_t step = 0;
  double time = 0;  ///< s
  std::uint64_t next_id = 0, searches = 0;
  std::uint64_t touching = 0;              ///< pairs in the last step
  DeepestOverlap overlap, overlap_of_run;  ///< m, of the last step and of all
  Ledger ledger;
  PhaseTimers timers;

  // Threads and their memory.
  ThreadPool pool;
  PerWorker<BlockWorkspace> workspaces;

  /// Of grain k.
  const GrainShape& shape_of(std::size_t k) const { return types.shape(grains.type_of(k)); }
  /// kg, of grains [begin, end), added in their order.
  double mass_of(std::size_t begin, std::size_t end) const;
};

/// What contacts of the spheres in `local` are computed from.
ContactScene contact_scene(const SimulationState& state, const LocalSpheres& local);

}  // namespace diefill::engine
