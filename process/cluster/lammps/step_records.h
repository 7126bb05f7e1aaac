// What a run of steps did on one rank, step after step: numbers that ranks add up, and those of which the
// largest counts.
#pragma once

#include <vector>

#include "process/cluster/lammps/rank_grains.h"

namespace diefill::process::cluster {

struct StepRecords {
  std::vector<double> sums, largest;

  static std::size_t sums_of(std::size_t bodies) { return 5 + 6 * bodies; }
  static constexpr std::size_t kLargest = 4;

  void clear() {
    sums.clear();
    largest.clear();
  }
  /// Appends a step of `time_step` (s); `drag` and `rolling` in J.
  void add(const ContactFigures& figures, double drag, double rolling, double time_step) {
    sums.insert(sums.end(), {time_step * figures.viscous_power, time_step * figures.friction_power, drag,
                             time_step * figures.rolling_power + rolling, figures.touching});
    for (const auto& load : figures.loads)
      for (const Eigen::Vector3d& vector : {load.force, load.torque})
        sums.insert(sums.end(), vector.data(), vector.data() + 3);
    const engine::DeepestOverlap& deepest = figures.overlap;
    largest.insert(largest.end(),
                   {deepest.grains, deepest.walls, deepest.grains_over_radius, deepest.walls_over_radius});
  }
  /// Step k of all ranks together.
  engine::ComputedStep step(std::size_t k, std::size_t bodies) const {
    const double* sum = sums.data() + k * sums_of(bodies);
    const double* most = largest.data() + k * kLargest;
    engine::ComputedStep computed;
    computed.work.viscous_work = sum[0];
    computed.work.tangential_work = sum[1];
    computed.work.drag_work = sum[2];
    computed.work.rolling_work = sum[3];
    computed.touching = static_cast<std::uint64_t>(sum[4] + 0.5);
    for (std::size_t b = 0; b < bodies; ++b) {
      const double* load = sum + 5 + 6 * b;
      computed.loads.push_back(
          {Eigen::Vector3d(load[0], load[1], load[2]), Eigen::Vector3d(load[3], load[4], load[5])});
    }
    computed.overlap = {most[0], most[1], most[2], most[3]};
    return computed;
  }
};

}  // namespace diefill::process::cluster
