#include "engine/observe/memory_traffic.h"

#include "engine/simulation/simulation.h"

namespace diefill::engine {

double bytes_moved_per_step(const Simulation& simulation) {
  const NeighbourList& list = simulation.neighbours();
  const auto grains = static_cast<double>(simulation.grains().size());
  const bool clumps = simulation.types().clumps();
  constexpr double kVector = sizeof(Vector3), kMotion = sizeof(GrainMotion);
  const double turning = simulation.types().rotates() ? 2 * kVector : 0;  // spin and torque
  const double orientation = clumps ? sizeof(Quaternion) : 0;
  // Reads position, velocity, force and the reference, writes positions and motion.
  const double advance = grains * (5 * kVector + turning + 3 * orientation + kMotion);
  // Reads and writes velocity and force; places of clumped grains, for moments about their centres.
  const double finish = grains * (4 * kVector + 2 * turning + orientation + (clumps ? kVector : 0));
  double contacts = grains * (kMotion + kVector + orientation);
  for (const auto& block : list.blocks())
    contacts +=
        static_cast<double>(block.grain_pairs.size() * (sizeof(GrainPair) + 1) +
                            block.wall_pairs.size() * (sizeof(WallPair) + 1) + 2 * block.sums.bytes());
  contacts += static_cast<double>(simulation.touching_pairs()) * 2 *
              static_cast<double>(list.settings().grain_history_sign.size()) * sizeof(double);
  return advance + finish + contacts;
}

}  // namespace diefill::engine
