#include "process/powder/pour_sizes.h"

#include <algorithm>
#include <cmath>

namespace diefill::process {

namespace {

constexpr double kLoosest = 0.1, kClosest = 1.2;

/// Heights of all columns as they fill.
class FillingColumns {
 public:
  explicit FillingColumns(const PourColumns& columns)
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

}  // namespace

double column_height(const Scene& scene, const PourColumns& columns, double diameter, double solid_volume) {
  if (scene.pour.lattice_constant > 0) return scene.pour.lattice_constant * diameter;
  return std::max(kClosest * diameter, solid_volume / (kLoosest * columns.distance * columns.distance));
}

std::vector<engine::NewGrain> pour_sizes(
    const Scene& scene, const std::vector<engine::ParticleType>& kinds, const PourColumns& columns,
    const std::vector<std::uint16_t>& types,
    const std::function<engine::NewGrain(const Eigen::Vector3d&, const engine::GrainShape&, Random&)>& place,
    const std::function<bool(const engine::NewGrain&, const engine::GrainShape&)>& has_room) {
  Random random(scene.seed);
  FillingColumns filling(columns);
  std::vector<engine::NewGrain> grains;
  for (const std::uint16_t kind : types) {
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
                         const PourColumns& columns, const std::vector<std::uint16_t>& types) {
  FillingColumns filling(columns);
  for (const std::uint16_t kind : types) {
    const engine::GrainShape& shape = kinds[kind].shape;
    filling.take(column_height(scene, columns, 2 * shape.bounding_radius(), shape.solid_volume));
  }
  return filling.highest();
}

}  // namespace diefill::process
