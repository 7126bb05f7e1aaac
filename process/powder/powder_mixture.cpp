#include "process/powder/powder_mixture.h"

#include <algorithm>
#include <cmath>

#include "process/powder/material.h"
#include "process/powder/mixed_powder.h"

namespace diefill::process {

namespace {

std::size_t count_types(const PowderSpec& powder) {
  return std::max<std::size_t>(1, powder.sizes.size());
}

std::vector<engine::CutClass> own_sizes(const PowderSpec& powder) {
  if (powder.sizes.empty()) return {{powder.grain_diameter, 1}};
  return powder.sizes;
}

/// Shares of the mass: what the other powders leave is [powder]'s.
double mass_share(const Scene& scene, std::size_t number) {
  if (number > 0) return scene.other_powders[number - 1].share;
  double left = 1;
  for (const auto& other : scene.other_powders) left -= other.share;
  return left;
}

double poured_volume(const Scene& scene) {
  const Eigen::Vector3d size = scene.pour.upper - scene.pour.lower;
  return size[0] * size[1] * scene.pour.fill_height;
}

std::size_t grains_of(const Scene& scene, const PourLayer& layer) {
  const Scene alone = scene_of_powder(scene, layer.powder);
  return static_cast<std::size_t>(
      std::llround(poured_volume(scene) * layer.share * expected_solid_fraction(alone) /
                   mean_of_powder(scene, layer.powder).solid_volume));
}

/// m^3 per m^3 of the mixture: each powder packs as it would alone.
double fraction_of_mixture(const Scene& scene) {
  double solid = 0, bulk = 0;
  for (std::size_t k = 0; k <= scene.other_powders.size(); ++k) {
    const MeanGrain grain = mean_of_powder(scene, k);
    const double volume = mass_share(scene, k) * grain.solid_volume / grain.mass;
    solid += volume;
    bulk += volume / expected_solid_fraction(scene_of_powder(scene, k));
  }
  return solid / bulk;
}

/// Any other seed than that of the grains' offsets.
std::uint64_t seed_of_order(const Scene& scene, std::size_t layer) {
  return (scene.seed ^ 0x9e3779b97f4a7c15ULL) + layer;
}

}  // namespace

Scene scene_of_powder(const Scene& scene, std::size_t number) {
  Scene alone = scene;
  alone.other_powders.clear();
  alone.powder_pairs.clear();
  alone.pour.layers.clear();
  if (number == 0) return alone;
  const OtherPowder& other = scene.other_powders.at(number - 1);
  alone.powder = other.powder;
  alone.contact = other.contact;
  alone.walls.friction = other.wall_friction.value_or(scene.walls.friction);
  alone.walls.work_of_adhesion = other.wall_work_of_adhesion.value_or(scene.walls.work_of_adhesion);
  return alone;
}

TypeRange types_of_powder(const Scene& scene, std::size_t number) {
  TypeRange range;
  for (std::size_t k = 0; k <= number; ++k) {
    range.first = range.last;
    range.last += count_types(powder_of(scene, k));
  }
  return range;
}

std::vector<engine::CutClass> number_shares(const Scene& scene, std::size_t number) {
  std::vector<engine::CutClass> shares;
  for (std::size_t k = 0; k <= scene.other_powders.size(); ++k)
    for (engine::CutClass size : own_sizes(powder_of(scene, k))) {
      if (k != number) size.number_share = 0;
      shares.push_back(size);
    }
  return shares;
}

std::vector<engine::CutClass> number_shares(const Scene& scene) {
  if (scene.other_powders.empty()) return own_sizes(scene.powder);
  std::vector<engine::CutClass> shares;
  double sum = 0;
  for (std::size_t k = 0; k <= scene.other_powders.size(); ++k) {
    const double grains = mass_share(scene, k) / mean_of_powder(scene, k).mass;
    sum += grains;
    for (engine::CutClass size : own_sizes(powder_of(scene, k))) {
      size.number_share *= grains;
      shares.push_back(size);
    }
  }
  for (auto& share : shares) share.number_share /= sum;
  return shares;
}

MeanGrain mean_of_powder(const Scene& scene, std::size_t number) {
  const engine::GrainShape shape = mean_grain(powder_of(scene, number), scene.coarse_graining);
  return {shape.mass, shape.solid_volume, static_cast<double>(shape.spheres())};
}

MeanGrain mean_of_inflow(const Scene& scene, const PowderInflow& inflow) {
  return inflow.powder.empty() ? mean_of_mixture(scene)
                               : mean_of_powder(scene, *powder_named(scene, inflow.powder));
}

std::vector<engine::CutClass> number_shares(const Scene& scene, const PowderInflow& inflow) {
  return inflow.powder.empty() ? number_shares(scene)
                               : number_shares(scene, *powder_named(scene, inflow.powder));
}

MeanGrain mean_of_mixture(const Scene& scene) {
  if (scene.other_powders.empty()) return mean_of_powder(scene, 0);
  MeanGrain mean;
  double sum = 0;
  for (std::size_t k = 0; k <= scene.other_powders.size(); ++k) {
    const MeanGrain grain = mean_of_powder(scene, k);
    const double grains = mass_share(scene, k) / grain.mass;
    mean.mass += grains * grain.mass;
    mean.solid_volume += grains * grain.solid_volume;
    mean.spheres += grains * grain.spheres;
    sum += grains;
  }
  return {mean.mass / sum, mean.solid_volume / sum, mean.spheres / sum};
}

MeanGrain mean_of_poured(const Scene& scene) {
  if (scene.pour.layers.empty()) return mean_of_mixture(scene);
  MeanGrain mean;
  double sum = 0;
  for (const PourLayer& layer : scene.pour.layers) {
    const MeanGrain grain = mean_of_powder(scene, layer.powder);
    const auto grains = static_cast<double>(grains_of(scene, layer));
    mean.mass += grains * grain.mass;
    mean.solid_volume += grains * grain.solid_volume;
    mean.spheres += grains * grain.spheres;
    sum += grains;
  }
  if (!(sum > 0)) return mean_of_powder(scene, scene.pour.layers.front().powder);
  return {mean.mass / sum, mean.solid_volume / sum, mean.spheres / sum};
}

std::size_t grains_to_pour(const Scene& scene) {
  if (!scene.pour.layers.empty()) {
    std::size_t grains = 0;
    for (const PourLayer& layer : scene.pour.layers) grains += grains_of(scene, layer);
    return grains;
  }
  const double fraction = scene.other_powders.empty() || scene.pour.solid_fraction > 0
                              ? expected_solid_fraction(scene)
                              : fraction_of_mixture(scene);
  return static_cast<std::size_t>(
      std::llround(poured_volume(scene) * fraction / mean_of_mixture(scene).solid_volume));
}

std::vector<std::uint16_t> types_to_pour(const Scene& scene, std::size_t count) {
  if (scene.pour.layers.empty())
    return engine::drawn_classes(number_shares(scene), count, seed_of_order(scene, 0));
  std::vector<std::uint16_t> types;
  for (std::size_t n = 0; n < scene.pour.layers.size(); ++n) {
    const PourLayer& layer = scene.pour.layers[n];
    const auto of_layer = engine::drawn_classes(number_shares(scene, layer.powder), grains_of(scene, layer),
                                                seed_of_order(scene, n));
    types.insert(types.end(), of_layer.begin(), of_layer.end());
  }
  types.resize(count, types.empty() ? std::uint16_t{0} : types.back());
  return types;
}

}  // namespace diefill::process
