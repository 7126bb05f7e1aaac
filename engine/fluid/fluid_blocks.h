// Forces in a fluid of particles, block by block. A particle's force depends on the density about it and
// about its partners, so that densities of all blocks are known before any force is computed.
#pragma once

#include <vector>

#include "engine/fluid/rigid_sets.h"
#include "engine/fluid/sheared_period.h"
#include "engine/laws/dissipative_particles.h"
#include "engine/numerics/pair_random.h"
#include "engine/powder/sphere_field.h"
#include "engine/search/neighbour_list.h"

namespace diefill::engine {

/// What the forces of one step are computed from.
struct FluidScene {
  const laws::DissipativeParticles& law;
  const Grains& grains;
  const SphereField& spheres;
  const RigidSets& sets;
  const ShearedPeriod& period;
  double time;  ///< s
  PairRandom random;
};

/// A particle as the pairs of a block see it.
struct FluidParticle {
  Vector3 position, velocity;  ///< m, m/s
  Vector3 arm;                 ///< m, from the centre of its solid; 0 of the fluid's
  double push;                 ///< N, DissipativeParticles::push(); 0 of a solid's
  std::uint64_t id;
  std::uint32_t set;  ///< RigidSets::kFluid or its solid
};

/// What one worker needs while it computes a block.
struct FluidWorkspace {
  std::vector<FluidParticle> particles;
  std::vector<ContactSum> sums;  ///< all 0 between blocks
};

/// What belongs to one block during a step.
struct FluidBlock {
  std::vector<GrainPair> touching;  ///< pairs that act on each other
  std::vector<double> density;      ///< 1/m^3, of the block's own pairs, one for each of Block::sums
  /// J, sum over the block's pairs of force times separation, solids as wholes: the pressure tensor times the
  /// volume, but for the motion of particles. Random forces are not in it: they are independent of where
  /// particles are, so that their mean is 0.
  Eigen::Matrix3d virial = Eigen::Matrix3d::Zero();
};

/// Finds the block's touching pairs, and what they add to densities.
void add_densities(const Block& block, const FluidScene& scene, FluidWorkspace& workspace, FluidBlock& own);
/// Adds the forces of the block's touching pairs to its sums; `pushes` (N) of all particles.
void add_fluid_forces(Block& block, const FluidScene& scene, const std::vector<double>& pushes,
                      FluidWorkspace& workspace, FluidBlock& own);

}  // namespace diefill::engine
