// What a step moves through memory.
#include "engine/simulation/simulation.h"

namespace diefill::engine {

double Simulation::bytes_moved_per_step() const {
  const auto grains = static_cast<double>(grains_.size());
  const bool clumps = types_.clumps();
  constexpr double kVector = sizeof(Vector3), kMotion = sizeof(GrainMotion);
  const double turning = types_.rotates() ? 2 * kVector : 0;  // spin and torque
  const double orientation = clumps ? sizeof(Quaternion) : 0;
  // Reads position, velocity, force and the reference, writes positions and motion.
  const double advance = grains * (5 * kVector + turning + 3 * orientation + kMotion);
  // Reads and writes velocity and force; places of clumped grains, for moments about their centres.
  const double finish = grains * (4 * kVector + 2 * turning + orientation + (clumps ? kVector : 0));
  double contacts = grains * (kMotion + kVector + orientation);
  for (const auto& block : list_.blocks())
    contacts +=
        static_cast<double>(block.grain_pairs.size() * (sizeof(GrainPair) + 1) +
                            block.wall_pairs.size() * (sizeof(WallPair) + 1) + 2 * block.sums.bytes());
  contacts += static_cast<double>(touching_) * 2 *
              static_cast<double>(list_.settings().grain_history_sign.size()) * sizeof(double);
  return advance + finish + contacts;
}

std::size_t Simulation::sphere_count() const {
  if (types_.equal_counts()) return grains_.size() * types_.spheres();
  std::size_t count = 0;
  for (std::size_t k = 0; k < grains_.size(); ++k) count += shape_of(k).spheres();
  return count;
}

}  // namespace diefill::engine
