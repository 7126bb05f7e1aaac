#include "process/powder/mixed_powder.h"

#include <algorithm>
#include <cmath>

namespace diefill::process {

namespace {

namespace laws = engine::laws;

/// `law` with what grows with the radius of spheres at `factor` times that radius.
laws::LawParameters at_radius(laws::LawParameters law, double factor) {
  if (auto* damping = std::get_if<laws::BierwischDamping::Parameters>(&law.damping.choice))
    damping->damping *= factor;
  if (auto* friction = std::get_if<laws::CundallFriction::Parameters>(&law.friction.choice))
    friction->tangential *= factor;
  if (auto* rolling = std::get_if<laws::OwnSpinRolling::Parameters>(&law.rolling.choice))
    rolling->arm *= factor;
  return law;
}

std::string material_of_size(const Scene& scene, std::size_t k) {
  return scene.powder.sizes.empty() ? engine::kPowderMaterial : "grains of size " + std::to_string(k + 1);
}

/// Sizes of the types over that of the grain of mean mass.
std::vector<double> size_factors(const Scene& scene) {
  if (scene.powder.sizes.empty()) return {1.0};
  std::vector<double> factors;
  for (const auto& size : scene.powder.sizes) factors.push_back(size.diameter / scene.powder.grain_diameter);
  return factors;
}

}  // namespace

engine::GrainShape mean_grain(const Scene& scene) {
  const auto material = coarse_material(scene);
  switch (scene.powder.model) {
    case GrainModel::clump:
      return enlarged(*scene.powder.clump, coarse_graining_factor(scene.powder));
    case GrainModel::A:
      return engine::model_a(material.sphere_radius, material.grain_mass);
    case GrainModel::B:
      return engine::model_b(material.sphere_radius, material.grain_mass);
    case GrainModel::C:
      return engine::model_c(material.sphere_radius, material.grain_mass);
    case GrainModel::D:
      break;
  }
  return engine::model_d(material.sphere_radius, material.grain_mass);
}

engine::GrainShape enlarged(const engine::GrainShape& shape, double factor) {
  if (factor == 1) return shape;
  engine::GrainShape large = shape;
  const double volume = factor * factor * factor;
  large.sphere_radius *= factor;
  for (auto& offset : large.sphere_offsets) offset *= factor;
  for (double& radius : large.sphere_radii) radius *= factor;
  large.mass *= volume;
  large.inertia *= volume * factor * factor;
  large.solid_volume *= volume;
  return large;
}

std::vector<engine::ParticleType> particle_types(const Scene& scene) {
  const engine::GrainShape mean = mean_grain(scene);
  std::vector<engine::ParticleType> types;
  for (const double factor : size_factors(scene))
    types.push_back({enlarged(mean, factor), material_of_size(scene, types.size())});
  return types;
}

engine::ContactLaws contact_laws(const Scene& scene, const SceneLaws& of_mean_grain) {
  const auto factors = size_factors(scene);
  engine::ContactLaws contact{{}, of_mean_grain.scaling};
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const std::string material = material_of_size(scene, i);
    for (std::size_t j = i; j < factors.size(); ++j)
      contact.pairs.push_back({material, material_of_size(scene, j),
                               at_radius(of_mean_grain.grains, std::min(factors[i], factors[j]))});
    for (const auto& [surface, law] : of_mean_grain.surfaces)
      contact.pairs.push_back({material, surface, at_radius(law, factors[i])});
  }
  return contact;
}

}  // namespace diefill::process
