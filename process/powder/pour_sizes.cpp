#include "process/powder/pour_sizes.h"

#include <algorithm>
#include <cmath>

namespace diefill::process {

namespace {

constexpr double kLoosest = 0.1, kClosest = 1.2;

/// Heights of all columns as they fill.
class Columns {
 public:
  explicit Columns(const PourColumns& columns)
      : columns_(columns), height_(columns.across[0] * columns.across[1], 0.0) {}

  /// The middle of the next cell, `height` (m) high, which is taken.
  Eigen::Vector3d take(double height) {
    const std::size_t column = next_++ % height_.size();
    const auto x = static_cast<double>(column % columns_.across[0]),
               y = static_cast<double>(column / columns_.across[0]);
    const Eigen::Vector3d middle =
        columns_.first +
        Eigen::Vector3d(x * columns_.distance, y * columns_.distance, height_[column] + 0.5 * height);
    height_[column] += height;
    return middle;
  }
  double highest() const { return *std::max_element(height_.begin(), height_.end()); }

 private:
  PourColumns columns_;
  std::vector<double> height_;
  std::size_t next_ = 0;
};

std::vector<std::uint16_t> kinds_of_grains(const Scene& scene, std::size_t count) {
  // Any other seed than that of the grains' offsets.
  return engine::drawn_classes(scene.powder.sizes, count, scene.seed ^ 0x9e3779b97f4a7c15ULL);
}

}  // namespace

double column_height(const Scene& scene, const PourColumns& columns, double diameter, double solid_volume) {
  if (scene.pour.lattice_constant > 0) return scene.pour.lattice_constant * diameter;
  return std::max(kClosest * diameter, solid_volume / (kLoosest * columns.distance * columns.distance));
}

std::vector<engine::NewGrain> pour_sizes(
    const Scene& scene, const std::vector<engine::ParticleType>& kinds, const PourColumns& columns,
    std::size_t count,
    const std::function<engine::NewGrain(const Eigen::Vector3d&, const engine::GrainShape&, Random&)>& place,
    const std::function<bool(const engine::NewGrain&, const engine::GrainShape&)>& has_room) {
  Random random(scene.seed);
  Columns filling(columns);
  std::vector<engine::NewGrain> grains;
  for (const std::uint16_t kind : kinds_of_grains(scene, count)) {
    const engine::GrainShape& shape = kinds[kind].shape;
    const double height = column_height(scene, columns, 2 * shape.bounding_radius(), shape.solid_volume);
    for (;;) {
      engine::NewGrain grain = place(filling.take(height), shape, random);
      if (!has_room(grain, shape)) continue;
      grain.kind = kind;
      grains.push_back(grain);
      break;
    }
  }
  return grains;
}

double height_of_columns(const Scene& scene, const std::vector<engine::ParticleType>& kinds,
                         const PourColumns& columns, std::size_t count) {
  Columns filling(columns);
  for (const std::uint16_t kind : kinds_of_grains(scene, count)) {
    const engine::GrainShape& shape = kinds[kind].shape;
    filling.take(column_height(scene, columns, 2 * shape.bounding_radius(), shape.solid_volume));
  }
  return filling.highest();
}

}  // namespace diefill::process
