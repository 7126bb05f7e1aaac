// What a run of the groove samples: speed in the gap, stress on the ingot and in the grains.
#pragma once

#include "process/laboratory/published/sawing/groove_tools.h"

namespace diefill::process::laboratory::sawing {

/// Solids of the run, and what is known of them.
struct GrooveParts {
  std::size_t wire = 0, ingot = 0, lid = 0;  ///< numbers of the solids
  std::uint64_t first_of_ingot = 0;          ///< number of its first particle
  std::vector<SurfacePlace> surface;
  FilledSlurry slurry;
};

/// Sums over the samples of a run under way; a plain value, all that a checkpoint needs beside the particles.
struct GrooveSums {
  GrooveFigures figures;
  double samples = 0, lid_force = 0;
  std::vector<double> speed, count;    ///< of the fluid, layer by layer of the gap
  std::vector<double> grain_pressure;  ///< of each grain since its stress was last counted
};

/// Adds samples of a run to its sums.
class GrooveMeasures {
 public:
  GrooveMeasures(const GrooveCase& one, const GrooveParts& parts, GrooveSums& sums);

  /// After each step.
  void note_distance(const engine::FluidSimulation& simulation);
  /// After step k, from 1 on, of those that are sampled.
  void sample(const engine::FluidSimulation& simulation, int k);
  /// Divides sums by what they are means over.
  void conclude(const engine::FluidSimulation& simulation);

 private:
  std::size_t stretch_of(const SurfacePlace& at) const;
  void conclude_stress();
  void sample_particles(const engine::FluidSimulation& simulation);
  void add_speed(const Eigen::Vector3d& place, double speed);
  void add_grain_stress(const engine::FluidSimulation& simulation);
  void count_grain_stress();
  void take_section(const engine::FluidSimulation& simulation);

  const GrooveCase& case_;
  const GrooveParts& parts_;
  GrooveSums& sums_;
};

}  // namespace diefill::process::laboratory::sawing
