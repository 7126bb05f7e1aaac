// The step of a fluid of particles and of the solids in it.
#pragma once

#include "engine/fluid/fluid_blocks.h"
#include "engine/simulation/step_policy.h"

namespace diefill::engine {

/// What a fluid is made of and how it is computed. In consistent units (DpdParameters).
struct FluidSettings {
  laws::DpdParameters law;
  double particle_mass = 1;  ///< kg
  double time_step = 0.01;   ///< s
  PeriodLengths period;      ///< m, box centred on the origin
  double shear_rate = 0;     ///< 1/s, of a sheared period: velocity along x over y
  std::uint64_t seed = 1;    ///< of the random forces
  double skin = 0;           ///< m; 0: 0.4 of the reach, at which steps cost least
  int threads = 1;
};

/// Densities before forces, and solids that carry their particles along.
class FluidPolicy final : public StepPolicy {
 public:
  /// Throws std::invalid_argument for settings that make no fluid.
  explicit FluidPolicy(const FluidSettings& settings);

  void move_tools(SimulationState& state) override;
  double advance_block(SimulationState& state, std::size_t b) override;
  void compute_forces(SimulationState& state) override;

  const laws::DissipativeParticles& law() const { return law_; }
  RigidSets& sets() { return sets_; }
  const RigidSets& sets() const { return sets_; }
  ShearedPeriod& period() { return period_; }
  const ShearedPeriod& period() const { return period_; }
  /// J, of all pairs in the last step (FluidBlock::virial).
  const Eigen::Matrix3d& virial() const { return virial_; }
  /// 1/m^3, about each particle in the last step, in the order of the grains.
  const std::vector<double>& densities() const { return density_; }

 private:
  void gather_densities(const SimulationState& state, std::size_t b);
  void finish_block(SimulationState& state, std::size_t b);

  laws::DissipativeParticles law_;
  std::uint64_t seed_;
  ShearedPeriod period_;
  RigidSets sets_;
  std::vector<FluidBlock> blocks_;
  PerWorker<FluidWorkspace> workspaces_;
  std::vector<double> density_, push_;  ///< 1/m^3 and N, of each particle
  Eigen::Matrix3d virial_ = Eigen::Matrix3d::Zero();
};

}  // namespace diefill::engine
