#include "process/powder/mixed_powder.h"

#include <algorithm>
#include <cmath>

#include "process/powder/powder_mixture.h"
#include "process/scene/powder/grain_models.h"

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

/// Of the grains of size `k` of a powder: kPowderMaterial where there is one powder of one size.
std::string material_of_size(const Scene& scene, std::size_t powder, std::size_t k) {
  const PowderSpec& spec = powder_of(scene, powder);
  std::string name = spec.sizes.empty() ? "" : "grains of size " + std::to_string(k + 1);
  if (!scene.other_powders.empty()) name = spec.label + (name.empty() ? "" : ", " + name);
  return name.empty() ? engine::kPowderMaterial : name;
}

/// Sizes of the types over that of the grain of mean mass.
std::vector<double> size_factors(const PowderSpec& powder) {
  if (powder.sizes.empty()) return {1.0};
  std::vector<double> factors;
  for (const auto& size : powder.sizes) factors.push_back(size.diameter / powder.grain_diameter);
  return factors;
}

/// m, of the spheres of each size at the wanted size.
std::vector<double> sphere_radii(const PowderSpec& powder) {
  std::vector<double> radii;
  for (const double factor : size_factors(powder))
    radii.push_back(factor * coarse_graining_factor(powder) * powder.sphere_radius);
  return radii;
}

/// Laws of powder `number` with itself and the tools.
void add_laws_of_powder(const Scene& scene, std::size_t number, double time_step,
                        engine::ContactLaws& contact) {
  const SceneLaws of_mean_grain = scene_laws(scene_of_powder(scene, number), time_step);
  const auto factors = size_factors(powder_of(scene, number));
  contact.scaling = of_mean_grain.scaling;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const std::string material = material_of_size(scene, number, i);
    for (std::size_t j = i; j < factors.size(); ++j)
      contact.pairs.push_back({material, material_of_size(scene, number, j),
                               at_radius(of_mean_grain.grains, std::min(factors[i], factors[j]))});
    for (const auto& [surface, law] : of_mean_grain.surfaces)
      contact.pairs.push_back({material, surface, at_radius(law, factors[i])});
  }
}

/// Laws between grains of two powders. What grows with the radius is that of the smaller sphere, as between
/// sizes of one powder.
void add_laws_of_pair(const Scene& scene, const PowderPair& pair, double time_step,
                      engine::ContactLaws& contact) {
  const laws::LawParameters law = pair_law(scene, pair, time_step);
  const double radius = coarse_graining_factor(pair.powder) * pair.powder.sphere_radius;
  const auto first = sphere_radii(powder_of(scene, pair.first)),
             second = sphere_radii(powder_of(scene, pair.second));
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t j = 0; j < second.size(); ++j)
      contact.pairs.push_back({material_of_size(scene, pair.first, i),
                               material_of_size(scene, pair.second, j),
                               at_radius(law, std::min(first[i], second[j]) / radius)});
}

}  // namespace

engine::GrainShape mean_grain(const PowderSpec& powder, CoarseGraining rule) {
  if (powder.clump) return enlarged(*powder.clump, coarse_graining_factor(powder));
  const auto material = coarse_material(powder, rule);
  return facts_of(powder.model).shape(material.sphere_radius, material.grain_mass);
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
  std::vector<engine::ParticleType> types;
  for (std::size_t powder = 0; powder <= scene.other_powders.size(); ++powder) {
    const engine::GrainShape mean = mean_grain(powder_of(scene, powder), scene.coarse_graining);
    const auto factors = size_factors(powder_of(scene, powder));
    for (std::size_t k = 0; k < factors.size(); ++k)
      types.push_back({enlarged(mean, factors[k]), material_of_size(scene, powder, k)});
  }
  return types;
}

engine::ContactLaws contact_laws(const Scene& scene, double time_step) {
  engine::ContactLaws contact;
  for (std::size_t powder = 0; powder <= scene.other_powders.size(); ++powder)
    add_laws_of_powder(scene, powder, time_step, contact);
  for (const PowderPair& pair : scene.powder_pairs) add_laws_of_pair(scene, pair, time_step, contact);
  return contact;
}

}  // namespace diefill::process
