#include "process/setup/pour.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry/solid/solid_query.h"
#include "process/powder/material.h"
#include "process/powder/pour_sizes.h"
#include "process/powder/powder_mixture.h"
#include "process/powder/random.h"
#include "process/setup/near_half.h"
#include "process/setup/placed_grains.h"
#include "process/setup/pour_fit.h"
#include "process/setup/restored_grains.h"

namespace diefill::process {

namespace {

/// Lattice that the box can carry: sites along x and y, distance, first site.
struct Lattice {
  std::size_t across[2];
  double constant;
  Eigen::Vector3d first;

  Eigen::Vector3d site(std::size_t number) const {
    const std::size_t x = number % across[0], y = number / across[0] % across[1],
                      z = number / (across[0] * across[1]);
    return first +
           constant * Eigen::Vector3d(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
  }
};

/// Lattice constant over d of powder that falls: beds of spheres that start denser than a tenth solid settle
/// looser than published ones (model A: 0.56 from a lattice of 1.2 d, 0.60 from this one; Bierwisch 2009,
/// Table 4.4: 0.59).
double loose_lattice(const engine::GrainShape& shape) {
  constexpr double kLoosest = 0.1, kClosest = 1.2;
  return std::max(kClosest, std::cbrt(shape.solid_volume / kLoosest) / (2 * shape.bounding_radius()));
}

/// `d`: m, size of the largest grains; `constant`: m.
Lattice lattice_of(const Scene& scene, double d, double constant) {
  const PourSpec& pour = scene.pour;
  Lattice lattice;
  lattice.constant = constant;
  const double clear = (0.5 + pour.random_offset) * d;
  lattice.first[2] = pour.lower[2] + clear;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const double length = pour.upper[axis] - pour.lower[axis];
    // A periodic box is filled to its borders, any other only as far as a grain stays inside.
    const bool open = scene.numerics.period[static_cast<std::size_t>(axis)].has_value();
    const double free_space = open ? length - lattice.constant : length - 2 * clear;
    if (free_space < 0)
      throw SceneError(
          scene.file.string() + ":" + std::to_string(pour.line) +
          ": pour: the box is narrower than a grain with its random offset; widen it or use smaller grains");
    const double sites = std::floor(free_space / lattice.constant + 1e-9) + 1;
    lattice.across[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(sites);
    lattice.first[axis] = 0.5 * (pour.lower[axis] + pour.upper[axis]) - 0.5 * (sites - 1) * lattice.constant;
  }
  return lattice;
}

Lattice lattice_of(const Scene& scene, const engine::GrainShape& shape) {
  const double d = 2 * shape.bounding_radius();
  const double given = scene.pour.lattice_constant;
  return lattice_of(scene, d, d * (given > 0 ? given : loose_lattice(shape)));
}

const engine::GrainShape& largest_shape(const engine::SimulationSettings& settings) {
  return std::ranges::max_element(
             settings.types, {},
             [](const engine::ParticleType& type) { return type.shape.bounding_radius(); })
      ->shape;
}

/// As wide as the largest grain needs, or so that grains of mean mass in cubes are a tenth solid.
PourColumns columns_of(const Scene& scene, const engine::SimulationSettings& settings) {
  constexpr double kClosest = 1.2;
  const double largest = 2 * largest_shape(settings).bounding_radius();
  const engine::GrainShape mean_shape = mean_grain(scene);
  const double mean = 2 * mean_shape.bounding_radius(), given = scene.pour.lattice_constant;
  const double constant =
      given > 0 ? given * largest : std::max(kClosest * largest, mean * loose_lattice(mean_shape));
  const Lattice lattice = lattice_of(scene, largest, constant);
  PourColumns columns;
  for (std::size_t axis = 0; axis < 2; ++axis) columns.across[axis] = lattice.across[axis];
  columns.distance = constant;
  columns.first = lattice.first;
  columns.first[2] = scene.pour.lower[2];
  return columns;
}

/// Space that no tool takes up.
class FreeSpace {
 public:
  explicit FreeSpace(const Tooling& tooling) {
    for (const Tool& tool : tooling.tools) solids_.push_back(tool.solid());
  }
  /// Whether a grain of `radius` (m) can stand at `place` (m) without touching a tool: fine powder on stiff
  /// walls is thrown off by the least overlap.
  bool at(const Eigen::Vector3d& place, double radius) const {
    return std::ranges::all_of(
        solids_, [&](const geometry::SolidQuery& solid) { return solid.signed_distance(place) > radius; });
  }

 private:
  std::vector<geometry::SolidQuery> solids_;
};

/// One grain at `site`, moved and turned by chance.
engine::NewGrain grain_at(const Eigen::Vector3d& site, const Scene& scene, const engine::GrainShape& shape,
                          Random& random) {
  const double radius = shape.bounding_radius();
  engine::NewGrain grain;
  const Eigen::Vector3d offset(random.symmetric(), random.symmetric(), random.symmetric());
  grain.position = site + scene.pour.random_offset * 2 * radius * offset;
  grain.orientation = random.direction<4>();
  if (shape.rotates) grain.angular_velocity = scene.pour.rim_speed / radius * random.direction<3>();
  return grain;
}

/// `count` grains from the lattice's floor upwards where there is room.
std::vector<engine::NewGrain> stack_around_tools(const Scene& scene, const engine::GrainShape& shape,
                                                 const Tooling& tooling, std::size_t count) {
  const Lattice lattice = lattice_of(scene, shape);
  const FreeSpace free_space(tooling);
  const double radius = shape.bounding_radius();
  // Above all tools every site is free, so that the stack ends.
  Random random(scene.seed);
  std::vector<engine::NewGrain> grains;
  for (std::size_t n = 0; grains.size() < count; ++n) {
    const auto grain = grain_at(lattice.site(n), scene, shape, random);
    if (free_space.at(grain.position, radius)) grains.push_back(grain);
  }
  refuse_lid(scene, tooling, grains, lattice.constant);
  return grains;
}

std::vector<engine::NewGrain> pour_kinds(const Scene& scene, const engine::SimulationSettings& settings,
                                         const Tooling& tooling, std::size_t count) {
  const auto& kinds = settings.types;
  const auto place = [&](const Eigen::Vector3d& site, const engine::GrainShape& shape, Random& random) {
    return grain_at(site, scene, shape, random);
  };
  const bool around = scene.pour.around_tools;
  const FreeSpace free_space(tooling);
  const auto has_room = [&](const engine::NewGrain& grain, const engine::GrainShape& shape) {
    return !around || free_space.at(grain.position, shape.bounding_radius());
  };
  const PourColumns columns = columns_of(scene, settings);
  auto grains = pour_sizes(scene, kinds, columns, types_to_pour(scene, count), place, has_room);
  std::vector<double> radii;
  for (const auto& kind : kinds) radii.push_back(kind.shape.bounding_radius());
  const engine::GrainShape& largest = largest_shape(settings);
  if (around)
    refuse_lid(scene, tooling, grains,
               column_height(scene, columns, 2 * largest.bounding_radius(), largest.solid_volume));
  else
    refuse_overlap(scene, tooling, grains, radii);
  return grains;
}

std::vector<engine::NewGrain> poured(const Scene& scene, const engine::SimulationSettings& settings,
                                     const Tooling& tooling, const engine::GrainShape& shape) {
  const std::size_t count = grains_to_pour(scene);
  if (count == 0)
    throw SceneError(scene.file.string() + ":" + std::to_string(scene.pour.line) +
                     ": pour.fill_height: the box does not hold a single grain at this height; raise it");
  if (settings.types.size() > 1) return pour_kinds(scene, settings, tooling, count);
  if (scene.pour.around_tools) return stack_around_tools(scene, shape, tooling, count);
  const Lattice lattice = lattice_of(scene, shape);
  Random random(scene.seed);
  std::vector<engine::NewGrain> grains;
  for (std::size_t n = 0; n < count; ++n) grains.push_back(grain_at(lattice.site(n), scene, shape, random));
  refuse_overlap(scene, tooling, grains, {shape.bounding_radius()});
  return grains;
}

}  // namespace

std::vector<engine::NewGrain> pour(const Scene& scene, const engine::SimulationSettings& settings,
                                   const Tooling& tooling) {
  const engine::GrainShape shape = mean_grain(scene);
  if (const auto& file = scene.pour.grains_file)
    return near_half(scene, settings, placed_grains(scene, settings, tooling, *file), "grains_file");
  if (const auto& state = scene.pour.state)
    return near_half(scene, settings, restored_grains(scene, settings, tooling, *state), "state");
  refuse_powder_over_nothing(scene, tooling.standing);
  auto grains = poured(scene, settings, tooling, shape);
  refuse_beyond_period(scene, grains, largest_shape(settings).bounding_radius());
  return grains;
}

double pour_height(const Scene& scene, const engine::SimulationSettings& settings) {
  if (scene.pour.grains_file || scene.pour.state) return scene.pour.upper[2] - scene.pour.lower[2];
  const engine::GrainShape shape = mean_grain(scene);
  if (settings.types.size() > 1)
    return height_of_columns(scene, settings.types, columns_of(scene, settings),
                             types_to_pour(scene, grains_to_pour(scene)));
  const Lattice lattice = lattice_of(scene, shape);
  const std::size_t layer = lattice.across[0] * lattice.across[1];
  const std::size_t layers = (grains_to_pour(scene) + layer - 1) / layer;
  return static_cast<double>(layers) * lattice.constant;
}

}  // namespace diefill::process
