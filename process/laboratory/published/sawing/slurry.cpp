#include "process/laboratory/published/sawing/slurry.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "engine/powder/rigid_motion.h"
#include "engine/powder/sphere_volume.h"

namespace diefill::process::laboratory::sawing {
namespace {

using engine::FluidSimulation;
using engine::GrainShape;
using engine::RigidSetSpec;

constexpr double kCell = kSpacing * kSpacing * kSpacing;  // r_c^3, of a solid's particle
// r_c, how near to walls and to each other grains and fluid are put.
constexpr double kGrainToWall = 0.8, kGrainToGrain = 0.8, kFluidToWall = 0.3, kFluidToSolid = 0.5,
                 kFluidToFluid = 0.45;
constexpr int kTries = 20000;  // of a grain or particle to find room

/// Places of solids' particles, for the question whether one is near.
class OccupiedPlaces {
 public:
  explicit OccupiedPlaces(const engine::PeriodLengths& period) : box_(period), period_(period) {}

  void add(const Eigen::Vector3d& place) {
    const Eigen::Vector3d inside = box_.wrapped(place);
    cells_[key(cell(inside))].push_back(inside);
  }
  /// Whether one is nearer than `distance` (r_c, at most 1).
  bool any_near(const Eigen::Vector3d& place, double distance) const {
    const Eigen::Vector3d inside = box_.wrapped(place);
    const Eigen::Vector3i middle = cell(inside);
    // A period need not be whole cells: one more beyond its border is looked at.
    for (int x = -2; x <= 2; ++x)
      for (int y = -2; y <= 2; ++y)
        for (int z = -2; z <= 2; ++z) {
          const Eigen::Vector3d there = middle.cast<double>() + Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5);
          const auto found = cells_.find(key(cell(box_.wrapped(there))));
          if (found == cells_.end()) continue;
          for (const Eigen::Vector3d& other : found->second)
            if (between(inside, other).norm() < distance) return true;
        }
    return false;
  }

 private:
  static Eigen::Vector3i cell(const Eigen::Vector3d& place) { return place.array().floor().cast<int>(); }
  static std::int64_t key(const Eigen::Vector3i& cell) {
    constexpr std::int64_t kMax = 1 << 20;
    return (cell.x() * kMax + cell.y()) * kMax + cell.z();
  }
  Eigen::Vector3d between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    Eigen::Vector3d way = a - b;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      if (const auto& length = period_[static_cast<std::size_t>(axis)])
        way[axis] -= *length * std::round(way[axis] / *length);
    return way;
  }

  engine::PeriodicBox box_;
  engine::PeriodLengths period_;
  std::unordered_map<std::int64_t, std::vector<Eigen::Vector3d>> cells_;
};

Eigen::Vector3d random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> along;
  const double x = along(random), y = along(random), z = along(random);
  return Eigen::Vector3d(x, y, z).normalized();
}

Eigen::Vector3d random_place(const SlurrySpace& space, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share;
  const double x = share(random), y = share(random), z = share(random);
  return space.lower + (space.upper - space.lower).cwiseProduct(Eigen::Vector3d(x, y, z));
}

engine::Quaternion random_orientation(std::mt19937_64& random) {
  std::normal_distribution<double> part;
  const double w = part(random), x = part(random), y = part(random), z = part(random);
  return engine::Quaternion(w, x, y, z).normalized();
}

/// Whether the grain has room where it is; its particles are noted if so.
bool takes_room(const SlurrySpace& space, const RigidSetSpec& grain, OccupiedPlaces& occupied) {
  const Eigen::Matrix3d frame = engine::rotation_matrix(grain.orientation);
  std::vector<Eigen::Vector3d> places;
  for (const auto& offset : grain.shape.sphere_offsets) {
    places.push_back(grain.centre + frame * offset);
    if (space.clearance(places.back()) < kGrainToWall || occupied.any_near(places.back(), kGrainToGrain))
      return false;
  }
  for (const auto& place : places) occupied.add(place);
  return true;
}

/// Grains of one size until they have their share of the space's volume, or no room is found for one.
double add_grains(const SlurrySpace& space, double size, double share, std::mt19937_64& random,
                  OccupiedPlaces& occupied, std::vector<RigidSetSpec>& grains) {
  double volume = 0;
  while (volume < share * space.volume) {
    RigidSetSpec grain;
    grain.shape = irregular_grain(size, random);
    const double added = kCell * static_cast<double>(grain.shape.spheres());
    if (volume + 0.5 * added > share * space.volume) break;
    int tries = 0;
    do {
      grain.centre = random_place(space, random);
      grain.orientation = random_orientation(random);
    } while (!takes_room(space, grain, occupied) && ++tries < kTries);
    if (tries == kTries) break;
    grains.push_back(grain);
    volume += added;
  }
  return volume;
}

/// Thermal velocities, at rest as a whole: across a sheared box a fluid that drifts leaves its profile
/// behind.
std::vector<Eigen::Vector3d> thermal_velocities(std::size_t count, std::mt19937_64& random) {
  std::normal_distribution<double> speed;
  std::vector<Eigen::Vector3d> velocities;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < count; ++k) {
    const double x = speed(random), y = speed(random), z = speed(random);
    velocities.emplace_back(x, y, z);
    mean += velocities.back() / static_cast<double>(count);
  }
  for (Eigen::Vector3d& velocity : velocities) velocity -= mean;
  return velocities;
}

/// `count` particles where no wall or solid is, and apart from each other: what overlaps by chance would fly
/// apart, and out through the walls.
void add_fluid(const SlurrySpace& space, std::size_t count, double density, const OccupiedPlaces& solids,
               std::mt19937_64& random, FluidSimulation& simulation) {
  const double apart = kFluidToFluid * std::cbrt(SlurryMixture().density / density);
  std::vector<Eigen::Vector3d> places, velocities = thermal_velocities(count, random);
  OccupiedPlaces fluid(space.period);
  int tries = 0;
  while (places.size() < count) {
    const Eigen::Vector3d place = random_place(space, random);
    if (space.clearance(place) < kFluidToWall || solids.any_near(place, kFluidToSolid)) continue;
    if (++tries < kTries && fluid.any_near(place, apart)) continue;
    tries = 0;
    fluid.add(place);
    Eigen::Vector3d& velocity = velocities[places.size()];
    velocity.x() += simulation.settings().shear_rate * place.y();
    if (space.flow) velocity += space.flow(place);
    places.push_back(place);
  }
  simulation.add_fluid(places, velocities);
}

}  // namespace

double particle_mass(double density_over_fluid) {
  return density_over_fluid * engine::laws::DpdParameters().density * kCell;
}

GrainShape irregular_grain(double size, std::mt19937_64& random) {
  constexpr int kPlanes = 8;
  const auto wanted =
      static_cast<std::size_t>(std::max(1L, std::lround(engine::sphere_volume_of_diameter(size) / kCell)));
  std::uniform_real_distribution<double> depth(0.55, 0.95), part(-0.5, 0.5);
  std::vector<std::pair<Eigen::Vector3d, double>> planes;
  for (int k = 0; k < kPlanes; ++k) planes.emplace_back(random_direction(random), depth(random));
  const double x = part(random), y = part(random), z = part(random);
  const Eigen::Vector3d origin(x, y, z);
  // The `wanted` lattice points that the smallest body of this shape holds.
  std::vector<std::pair<double, Eigen::Vector3d>> points;
  const int most = static_cast<int>(size / kSpacing) + 2;
  for (int i = -most; i <= most; ++i)
    for (int j = -most; j <= most; ++j)
      for (int k = -most; k <= most; ++k) {
        const Eigen::Vector3d point = kSpacing * (Eigen::Vector3d(i, j, k) + origin);
        double scale = point.norm();
        for (const auto& [normal, share] : planes) scale = std::max(scale, normal.dot(point) / share);
        points.emplace_back(scale, point);
      }
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Eigen::Vector3d> particles;
  for (std::size_t k = 0; k < wanted; ++k) particles.push_back(points[k].second);
  const auto count = static_cast<double>(wanted);
  return engine::rigid_grain(0.5 * kSpacing, particles, particle_mass(kGrainDensity) * count, kCell * count);
}

FilledSlurry fill(const SlurrySpace& space, const SlurryMixture& mixture, std::uint64_t seed,
                  FluidSimulation& simulation) {
  std::mt19937_64 random(seed);
  OccupiedPlaces occupied(space.period);
  std::vector<RigidSetSpec> grains;
  FilledSlurry filled;
  double solid_volume = 0;
  std::vector<double> sizes = mixture.sizes;
  std::sort(sizes.rbegin(), sizes.rend());
  for (const double size : sizes) {
    if (mixture.solids > 0)
      solid_volume += add_grains(space, size, mixture.solids / static_cast<double>(sizes.size()), random,
                                 occupied, grains);
    filled.grain_size.resize(grains.size(), size);
  }
  const double rate = simulation.settings().shear_rate;
  for (RigidSetSpec& grain : grains) {
    grain.velocity = {rate * grain.centre.y(), 0, 0};
    if (space.flow) grain.velocity += space.flow(grain.centre);
  }
  filled.first_grain = simulation.add_solids(grains);
  filled.solids = solid_volume / space.volume;
  const double fluid = mixture.density * (space.volume - solid_volume);
  add_fluid(space, static_cast<std::size_t>(std::lround(fluid)), mixture.density, occupied, random,
            simulation);
  return filled;
}

}  // namespace diefill::process::laboratory::sawing
