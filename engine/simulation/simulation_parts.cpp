#include "engine/simulation/simulation_parts.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "engine/contact/pair_laws.h"

namespace diefill::engine {

namespace {

LeverArm arm_for(const ParticleTypes& types, LeverArm wanted) {
  if (!types.rotates()) return LeverArm::none;
  return types.clumps() ? wanted : LeverArm::surface;
}

/// The surfaces of walls, as the laws of their contacts need them.
std::vector<WallSurface> surfaces_of(const std::vector<WallBodySpec>& walls) {
  constexpr double kFlat = std::numeric_limits<double>::infinity();
  std::vector<WallSurface> surfaces;
  for (const auto& wall : walls) {
    if (wall.mirror && wall.planes.empty())
      throw std::invalid_argument("wall '" + wall.name +
                                  "' is set to mirror grains, but does not consist of planes");
    const double radius = !wall.triangles.empty() ? wall.contact_radius
                          : wall.planes.empty()   ? wall.sphere_radius
                                                  : kFlat;
    surfaces.push_back({wall.material, radius, wall.mirror});
  }
  return surfaces;
}

}  // namespace

SimulationSettings checked(SimulationSettings settings, const ParticleTypes& types) {
  if (!(settings.time_step > 0)) throw std::invalid_argument("the time step must be positive");
  if (settings.threads < 1) throw std::invalid_argument("at least one thread is needed");
  if (settings.air_flow && settings.sleep)
    throw std::invalid_argument("sleeping grains cannot be combined with air flow through the powder");
  if (settings.air_flow && settings.air_flow->resistance.size() != types.size())
    throw std::invalid_argument("air flow needs a resistance for each particle type");
  if (settings.sleep) check(*settings.sleep);
  settings.lever_arm = arm_for(types, settings.lever_arm);
  for (TypeNumber type = 0; type < types.size(); ++type) settings.types[type].shape = types.shape(type);
  return settings;
}

std::unique_ptr<PairLoop> grain_loop_for(const SimulationSettings& settings, const ParticleTypes& types) {
  return make_grain_loop(types, settings.contact, settings.lever_arm);
}

std::unique_ptr<PairLoop> wall_loop_for(const SimulationSettings& settings, const ParticleTypes& types,
                                        const std::vector<WallBodySpec>& walls) {
  return make_wall_loop(types, settings.contact, settings.lever_arm, surfaces_of(walls));
}

GrainIntegrator integrator_for(const SimulationSettings& settings, const ParticleTypes& types,
                               const PairLoop& grain_loop, const PairLoop& wall_loop) {
  return {types,
          settings.gravity,
          settings.air_viscosity,
          grain_loop.rolls() || wall_loop.rolls(),
          settings.time_step,
          settings.instructions};
}

std::vector<WallSurface> surfaces_of(const std::vector<WallBody>& bodies) {
  std::vector<WallSurface> surfaces;
  for (const WallBody& body : bodies)
    surfaces.push_back({body.material(), body.contact_radius(), body.mirror()});
  return surfaces;
}

std::vector<std::uint32_t> first_sphere_of_bodies(const std::vector<WallBodySpec>& walls) {
  std::vector<std::uint32_t> first(1, 0);
  for (const auto& wall : walls)
    first.push_back(first.back() + static_cast<std::uint32_t>(wall.centres.size() + wall.planes.size() +
                                                              wall.triangles.size()));
  return first;
}

void number_spheres_of_types(const ParticleTypes& types, SphereField& spheres) {
  spheres.equal_counts = types.equal_counts();
  for (std::size_t k = 0; k < types.size(); ++k) {
    const auto type = static_cast<TypeNumber>(k);
    const GrainShape& shape = types.shape(type);
    spheres.counts.push_back(shape.spheres());
    std::vector<Vector3>& offsets = spheres.offsets.emplace_back();
    for (const auto& offset : shape.sphere_offsets) offsets.push_back(plain(offset));
    offsets.resize(types.spheres());
    for (std::size_t number = 0; number < types.spheres(); ++number)
      spheres.sphere_class.push_back(types.class_of(type, number));
  }
}

NeighbourSettings neighbour_settings(const ParticleTypes& types, const PairLoop& grain_loop,
                                     const PairLoop& wall_loop) {
  return {.sphere_radii = types.sphere_radii(),
          .farthest_sphere = types.farthest_sphere(),
          .law_range = grain_loop.range(),
          .grain_history_sign = grain_loop.history_signs(),
          .wall_history = wall_loop.history_signs().size(),
          .sum_numbers = !types.rotates()                          ? ContactSum::kForce
                         : grain_loop.rolls() || wall_loop.rolls() ? ContactSum::kRolling
                                                                   : ContactSum::kMoment};
}

AdaptiveSkin skin_for(const SimulationSettings& settings, const ParticleTypes& types, double range) {
  double room = 1e300;  // m, for two grains that approach, on both sides of each
  for (const auto& period : settings.period)
    if (period) room = std::min(room, *period - 4 * types.largest_grain() - 2 * range);
  const AdaptiveSkin skin(settings.skin, types.smallest_sphere(), 0.25 * room);
  if (room < 2 * skin.largest())
    throw std::invalid_argument(
        "a periodic length is below two grain sizes, the reach of the law and the skin");
  return skin;
}

}  // namespace diefill::engine
