#include "engine/simulation/simulation_parts.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace diefill::engine {

namespace {

LeverArm arm_for(const KindTable& kinds, LeverArm wanted) {
  if (!kinds.rotates()) return LeverArm::none;
  return kinds.clumps() ? wanted : LeverArm::surface;
}

std::vector<double> radii_of(const std::vector<WallBodySpec>& walls) {
  std::vector<double> radii;
  for (const auto& wall : walls)
    radii.push_back(!wall.triangles.empty() ? wall.contact_radius
                    : wall.planes.empty()   ? wall.sphere_radius
                                            : std::numeric_limits<double>::infinity());
  return radii;
}

std::unique_ptr<PairLoop> mixed_wall_loop_for(const SimulationSettings& settings, const KindTable& kinds,
                                              const std::vector<WallBodySpec>& walls) {
  std::vector<std::string> materials;
  for (const auto& wall : walls) {
    if (wall.contact)
      throw std::invalid_argument("wall '" + wall.name +
                                  "' has a contact of its own, and the powder is of several kinds: give the "
                                  "wall a material; planes of symmetry need a powder of one kind");
    if (!wall.triangles.empty())
      throw std::invalid_argument("wall '" + wall.name +
                                  "' is of triangles, and the powder is of several kinds: give it spheres");
    materials.push_back(wall.material);
  }
  return make_mixed_wall_loop(kinds, *settings.mix, settings.lever_arm, radii_of(walls), materials);
}

}  // namespace

KindTable kinds_of(const SimulationSettings& settings) {
  if (settings.mix && settings.general_contact)
    throw std::invalid_argument("a powder of several kinds has laws of its own: give no general contact law");
  if (!settings.mix) {
    if (settings.shape.sphere_offsets.empty()) throw std::invalid_argument("the grain shape has no spheres");
    GrainShape shape = settings.shape;
    if (settings.general_contact) shape.inertia /= settings.general_contact->scaling.torque_factor();
    return KindTable({{std::move(shape), {}}});
  }
  auto kinds = settings.mix->kinds;
  for (auto& kind : kinds) kind.shape.inertia /= settings.mix->scaling.torque_factor();
  return KindTable(std::move(kinds));
}

SimulationSettings checked(SimulationSettings settings, const KindTable& kinds) {
  if (!(settings.time_step > 0)) throw std::invalid_argument("the time step must be positive");
  if (settings.threads < 1) throw std::invalid_argument("at least one thread is needed");
  if (settings.air_flow && settings.sleep)
    throw std::invalid_argument("grains cannot sleep where air is drawn through the powder");
  if (settings.air_flow && settings.mix)
    throw std::invalid_argument("air is drawn through powders of one kind only");
  settings.lever_arm = arm_for(kinds, settings.lever_arm);
  settings.shape = kinds.shape(0);
  return settings;
}

std::unique_ptr<PairLoop> grain_loop_for(const SimulationSettings& settings, const KindTable& kinds) {
  if (settings.mix) return make_mixed_grain_loop(kinds, *settings.mix, settings.lever_arm);
  if (settings.general_contact)
    return make_general_grain_loop(*settings.general_contact, settings.lever_arm, settings.shape);
  return make_grain_loop(settings.grain_contact, settings.lever_arm, settings.spring_limit,
                         settings.shape.sphere_radius, settings.shape.spheres() > 1);
}

std::unique_ptr<PairLoop> wall_loop_for(const SimulationSettings& settings, const KindTable& kinds,
                                        const std::vector<WallBodySpec>& walls) {
  if (settings.mix) return mixed_wall_loop_for(settings, kinds, walls);
  const auto radii = radii_of(walls);
  std::vector<ContactParameters> contacts;
  for (const auto& wall : walls) {
    if (wall.contact && settings.general_contact)
      throw std::invalid_argument("a wall has a contact of its own beside a general contact law");
    contacts.push_back(wall.contact.value_or(settings.wall_contact));
  }
  if (settings.general_contact)
    return make_general_wall_loop(*settings.general_contact, settings.lever_arm, settings.shape, radii);
  return make_wall_loop(contacts, settings.lever_arm, settings.spring_limit, settings.shape.sphere_radius,
                        settings.shape.spheres() > 1, radii);
}

std::vector<std::uint32_t> first_sphere_of_bodies(const std::vector<WallBodySpec>& walls) {
  std::vector<std::uint32_t> first(1, 0);
  for (const auto& wall : walls)
    first.push_back(first.back() + static_cast<std::uint32_t>(wall.centres.size() + wall.planes.size() +
                                                              wall.triangles.size()));
  return first;
}

NeighbourSettings neighbour_settings(const KindTable& kinds, const PairLoop& grain_loop,
                                     const PairLoop& wall_loop) {
  return {.sphere_radii = kinds.sphere_radii(),
          .farthest_sphere = kinds.farthest_sphere(),
          .law_range = grain_loop.range(),
          .grain_history_sign = grain_loop.history_signs(),
          .wall_history = wall_loop.history_signs().size(),
          .sum_numbers = !kinds.rotates()                          ? ContactSum::kForce
                         : grain_loop.rolls() || wall_loop.rolls() ? ContactSum::kRolling
                                                                   : ContactSum::kMoment};
}

AdaptiveSkin skin_for(const SimulationSettings& settings, const KindTable& kinds, double range) {
  double room = 1e300;  // m, for two grains that approach, on both sides of each
  for (const auto& period : settings.period)
    if (period) room = std::min(room, *period - 4 * kinds.largest_grain() - 2 * range);
  const AdaptiveSkin skin(settings.skin, kinds.smallest_sphere(), 0.25 * room);
  if (room < 2 * skin.largest())
    throw std::invalid_argument(
        "a periodic length is below two grain sizes, the reach of the law and the skin");
  return skin;
}

}  // namespace diefill::engine
