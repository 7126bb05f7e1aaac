#include "engine/fluid/fluid_blocks.h"

#include <cmath>

namespace diefill::engine {

namespace {

constexpr std::uint32_t kFluid = RigidSets::kFluid;

/// Takes in the block's own particles and their partners, images where they are seen. `pushes`: none before
/// densities are known.
void take_in(const Block& block, const FluidScene& scene, const std::vector<double>* pushes,
             std::vector<FluidParticle>& particles) {
  const std::size_t own = block.own_spheres();
  if (particles.size() < own + block.partners.size()) particles.resize(own + block.partners.size());
  const auto take = [&](std::size_t grain) {
    const std::uint64_t id = scene.grains.id[grain];
    const std::uint32_t set = scene.sets.set_of(id);
    return FluidParticle{plain(scene.grains.position[grain]),
                         plain(scene.grains.velocity[grain]),
                         pushes && set != kFluid ? plain(scene.sets.arm(id)) : Vector3{},
                         pushes ? (*pushes)[grain] : 0,
                         id,
                         set};
  };
  for (std::size_t k = 0; k < own; ++k) particles[k] = take(block.begin + k);
  for (std::size_t k = 0; k < block.partners.size(); ++k) {
    const std::uint32_t partner = block.partners[k];
    FluidParticle& seen = particles[own + k] = take(scene.spheres.owner(partner));
    if (partner < scene.spheres.grains) continue;
    const std::size_t image = partner - scene.spheres.grains;
    if (!scene.period.shears()) {
      seen.position += scene.spheres.shift(partner);
      continue;
    }
    const auto shift = scene.period.shift(image, scene.spheres.images[image], scene.time);
    seen.position += shift.place;
    seen.velocity += shift.velocity;
  }
}

/// Solids are rigid, and tools do not act on each other.
bool act_on_each_other(const RigidSets& sets, std::uint32_t own, std::uint32_t other) {
  if (own == kFluid || other == kFluid) return true;
  return own != other && !(sets.is_tool(own) && sets.is_tool(other));
}

/// N, on a particle away from its partner.
struct FluidForce {
  double steady, random;
};

FluidForce force_between(const FluidScene& scene, const FluidParticle& own, const FluidParticle& other,
                         double weight, double separation_speed) {
  const auto& law = scene.law;
  const bool fluid = own.set == kFluid, other_fluid = other.set == kFluid;
  if (fluid || other_fluid) {
    const double zeta = scene.random.gaussian(own.id, other.id), pushes = own.push + other.push;
    if (fluid && other_fluid)
      return {law.between_fluid(weight, pushes, separation_speed), law.kick_in_fluid(weight, zeta)};
    return {law.at_solid(weight, pushes, separation_speed), law.kick_at_solid(weight, zeta)};
  }
  if (scene.sets.is_tool(own.set) || scene.sets.is_tool(other.set))
    return {law.at_tool(weight, separation_speed), 0};
  return {law.between_grains(weight), 0};
}

}  // namespace

void add_densities(const Block& block, const FluidScene& scene, FluidWorkspace& workspace, FluidBlock& own) {
  take_in(block, scene, nullptr, workspace.particles);
  const FluidParticle* particles = workspace.particles.data();
  const double reach = scene.law.reach(), reach_squared = reach * reach;
  own.density.assign(block.sums.size(), 0);
  own.touching.clear();
  for (const GrainPair pair : block.grain_pairs.pair) {
    const FluidParticle &i = particles[pair.own], &j = particles[pair.other];
    const Vector3 separation = i.position - j.position;
    const double squared = dot(separation, separation);
    if (squared >= reach_squared || !act_on_each_other(scene.sets, i.set, j.set)) continue;
    own.touching.push_back(pair);
    const double weight = scene.law.weight(std::sqrt(squared));
    const auto density_by = [&](std::uint32_t set) {
      return set == kFluid ? scene.law.density_of(weight) : scene.law.density_of_solid(weight);
    };
    own.density[pair.own] += density_by(j.set);
    own.density[pair.other] += density_by(i.set);
  }
}

void add_fluid_forces(Block& block, const FluidScene& scene, const std::vector<double>& pushes,
                      FluidWorkspace& workspace, FluidBlock& own) {
  take_in(block, scene, &pushes, workspace.particles);
  const FluidParticle* particles = workspace.particles.data();
  std::vector<ContactSum>& sums = workspace.sums;
  if (sums.size() < block.sums.size()) sums.resize(block.sums.size());
  Vector3 row_x, row_y, row_z;  // of the virial
  for (const GrainPair pair : own.touching) {
    const FluidParticle &i = particles[pair.own], &j = particles[pair.other];
    const Vector3 separation = i.position - j.position;
    const double distance = length(separation);
    const Vector3 normal = (1 / distance) * separation;
    const FluidForce force =
        force_between(scene, i, j, scene.law.weight(distance), dot(i.velocity - j.velocity, normal));
    const Vector3 push = (force.steady + force.random) * normal, steady = force.steady * normal;
    sums[pair.own].add_force(push);
    sums[pair.other].add_force(-push);
    const Vector3 between = separation - i.arm + j.arm;
    row_x += steady.x * between;
    row_y += steady.y * between;
    row_z += steady.z * between;
  }
  own.virial.row(0) = eigen(row_x);
  own.virial.row(1) = eigen(row_y);
  own.virial.row(2) = eigen(row_z);
  block.sums.keep(sums);
}

}  // namespace diefill::engine
