#include "process/laboratory/published/bierwisch/ring_motion.h"

#include <cmath>
#include <map>
#include <numbers>

namespace diefill::process::laboratory {
namespace {

constexpr int kSectors = 12;
constexpr double kLoose = 0.35;  // solid fraction of powder in the ring
constexpr double kNear = 3;      // d below the level
constexpr double kMoved = 0.5;   // d
constexpr double kEnough = 0.1;  // share of a layer's grains

std::size_t layers_of(const results::PowderState& powder, const RingSpace& ring) {
  return static_cast<std::size_t>(std::ceil(ring.depth / powder.grain_diameter));
}

/// Layer from the upper edge down; the count of layers for what is not in the ring.
std::size_t layer_of(const results::PowderState& powder, const Eigen::Vector3d& place, std::size_t layers) {
  if (place.z() >= 0) return layers;
  return std::min(layers, static_cast<std::size_t>(-place.z() / powder.grain_diameter));
}

/// Grains over sectors and layers, row by row of a sector.
std::vector<double> counts_of(const results::PowderState& powder, std::size_t layers) {
  std::vector<double> counts(kSectors * layers, 0.0);
  for (const auto& place : powder.position) {
    const std::size_t layer = layer_of(powder, place, layers);
    if (layer == layers) continue;
    const double turn = std::atan2(place.y(), place.x()) / (2 * std::numbers::pi);
    const auto sector = static_cast<std::size_t>(kSectors * (turn < 0 ? turn + 1 : turn)) % kSectors;
    ++counts[sector * layers + layer];
  }
  return counts;
}

/// m below the upper edge, of the powder in one sector.
double level_of(const std::vector<double>& counts, std::size_t sector, std::size_t layers, double grain,
                const RingSpace& ring) {
  double grains = 0;
  for (std::size_t layer = 0; layer < layers; ++layer) grains += counts[sector * layers + layer];
  const double area =
      std::numbers::pi * (ring.outer * ring.outer - ring.inner * ring.inner) / double(kSectors);
  return std::max(0.0, ring.depth - grains * grain / (kLoose * area));
}

/// Calls `each` with the initial position and the displacement (m) of every grain that is in the ring at both
/// instants.
template <class Each>
void for_stayers(const results::PowderState& before, const results::PowderState& after, const Each& each) {
  std::map<std::uint64_t, Eigen::Vector3d> places;
  for (std::size_t k = 0; k < before.id.size(); ++k)
    if (before.position[k].z() < 0) places[before.id[k]] = before.position[k];
  for (std::size_t k = 0; k < after.id.size(); ++k) {
    const auto was = places.find(after.id[k]);
    if (was == places.end() || after.position[k].z() >= 0) continue;
    each(was->second, (after.position[k] - was->second).norm());
  }
}

}  // namespace

double filled_volume(const results::PowderState& powder, bool near_start) {
  double grains = 0;
  for (const auto& place : powder.position) grains += place.z() < 0 && (!near_start || place.x() > 0) ? 1 : 0;
  return grains * powder.grain_solid_volume;
}

double change_near_surface(const results::PowderState& before, const results::PowderState& after,
                           const RingSpace& ring) {
  const std::size_t layers = layers_of(before, ring);
  const auto first = counts_of(before, layers), last = counts_of(after, layers);
  const double grain = before.grain_solid_volume, d = before.grain_diameter;
  double near = 0, all = 0;
  for (std::size_t sector = 0; sector < kSectors; ++sector) {
    const double level =
        std::max(level_of(first, sector, layers, grain, ring), level_of(last, sector, layers, grain, ring));
    for (std::size_t layer = 0; layer < layers; ++layer) {
      const double change = std::abs(last[sector * layers + layer] - first[sector * layers + layer]);
      all += change;
      near += (static_cast<double>(layer) + 0.5) * d < level + kNear * d ? change : 0;
    }
  }
  return near / all;
}

std::vector<double> moved_shares(const results::PowderState& before, const results::PowderState& after,
                                 const RingSpace& ring) {
  const std::size_t layers = layers_of(before, ring);
  std::vector<double> all(layers + 1, 0.0), moved(layers + 1, 0.0);
  for_stayers(before, after, [&](const Eigen::Vector3d& place, double way) {
    const std::size_t layer = layer_of(before, place, layers);
    ++all[layer];
    moved[layer] += way > kMoved * before.grain_diameter ? 1 : 0;
  });
  moved.pop_back();
  for (std::size_t layer = 0; layer < layers; ++layer) moved[layer] /= all[layer];
  return moved;
}

double depth_of_motion(const results::PowderState& before, const results::PowderState& after,
                       const RingSpace& ring) {
  const std::vector<double> moved = moved_shares(before, after, ring);
  std::size_t deep = 0;
  while (deep < moved.size() && !(moved[deep] < kEnough)) ++deep;
  return std::min(ring.depth, static_cast<double>(deep) * before.grain_diameter);
}

double mean_motion(const results::PowderState& before, const results::PowderState& after) {
  double sum = 0, grains = 0;
  for_stayers(before, after, [&](const Eigen::Vector3d&, double way) { sum += way, ++grains; });
  return sum / grains / before.grain_diameter;
}

}  // namespace diefill::process::laboratory
