#include "process/powder/mixed_powder.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "process/powder/tool_surface.h"

namespace diefill::process {

namespace {

namespace laws = engine::laws;

/// `law` with what grows with the radius of spheres at `factor` times that radius.
laws::LawParameters at_radius(laws::LawParameters law, double factor) {
  if (auto* damping = std::get_if<laws::BierwischDamping::Parameters>(&law.damping.choice))
    damping->damping *= factor;
  if (auto* friction = std::get_if<laws::CundallFriction::Parameters>(&law.friction.choice))
    friction->tangential *= factor;
  return law;
}

laws::LawParameters own_law(const engine::ContactParameters& contact, engine::SpringLimit limit) {
  laws::LawParameters law;
  law.normal = laws::BierwischNormal::Parameters{contact.reduced_modulus, contact.work_of_adhesion};
  law.damping = laws::BierwischDamping::Parameters{contact.damping};
  law.friction = laws::CundallFriction::Parameters{contact.tangential, contact.friction,
                                                   limit == engine::SpringLimit::cut_back};
  return law;
}

std::string grain_material(std::size_t kind) {
  return "grains of kind " + std::to_string(kind);
}

/// The law of grains of mean size with each material that tools have.
std::map<std::string, laws::LawParameters> laws_with_tools(const Scene& scene,
                                                           const laws::LawParameters& walls) {
  std::map<std::string, laws::LawParameters> laws = {{kWallMaterial, walls}};
  for (const ToolSpec& tool : scene.tools)
    if (has_own_surface(tool)) laws.emplace(material_of(tool), contact_with(scene, tool, walls));
  return laws;
}

}  // namespace

engine::GeneralContact own_law(const engine::SimulationSettings& settings) {
  return {own_law(settings.grain_contact, settings.spring_limit),
          own_law(settings.wall_contact, settings.spring_limit),
          {}};
}

engine::GrainShape enlarged(const engine::GrainShape& shape, double factor) {
  engine::GrainShape large = shape;
  const double volume = factor * factor * factor;
  large.sphere_radius *= factor;
  for (auto& offset : large.sphere_offsets) offset *= factor;
  large.mass *= volume;
  large.inertia *= volume * factor * factor;
  large.solid_volume *= volume;
  return large;
}

engine::GrainMix grain_mix(const Scene& scene, const engine::GrainShape& mean,
                           const engine::GeneralContact& contact) {
  engine::GrainMix mix;
  mix.scaling = contact.scaling;
  std::vector<double> factors;
  for (const auto& size : scene.powder.sizes) {
    factors.push_back(size.diameter / scene.powder.grain_diameter);
    mix.kinds.push_back({enlarged(mean, factors.back()), grain_material(mix.kinds.size())});
  }
  for (std::size_t i = 0; i < factors.size(); ++i) {
    for (std::size_t j = i; j < factors.size(); ++j)
      mix.laws.push_back({grain_material(i), grain_material(j),
                          at_radius(contact.grains, std::min(factors[i], factors[j]))});
    for (const auto& [material, law] : laws_with_tools(scene, contact.walls))
      mix.laws.push_back({grain_material(i), material, at_radius(law, factors[i])});
  }
  return mix;
}

}  // namespace diefill::process
