#include "process/powder/scene_laws.h"

#include "engine/coarse_graining/methods.h"
#include "engine/laws/bierwisch_law.h"
#include "engine/powder/materials.h"
#include "process/powder/tool_surface.h"
#include "process/scene/contact/contact_spec.h"
#include "process/scene/powder/grain_models.h"

namespace diefill::process {

namespace {

namespace laws = engine::laws;

/// The rule under which large grains have the forces that the law gives at their size.
constexpr const char* kUnscaled = "none";

engine::coarse_graining::Material reference_material(const PowderSpec& powder) {
  engine::coarse_graining::Material material;
  material.sphere_radius = powder.sphere_radius;
  material.grain_mass = powder.grain_mass;
  material.reduced_modulus = powder.reduced_modulus;
  material.damping = powder.damping_over_radius * powder.sphere_radius;
  material.tangential = powder.tangential_over_radius * powder.sphere_radius;
  material.work_of_adhesion = powder.work_of_adhesion;
  material.rolling_friction = powder.rolling_friction;
  material.air_viscosity = powder.air_viscosity;
  material.friction = powder.friction;
  return material;
}

/// The law that the powder's own parameters make (Bierwisch 2009, section 2.2).
laws::LawParameters own_law(const Scene& scene, double friction, double work_of_adhesion) {
  const auto material = coarse_material(scene);
  return laws::bierwisch_law(
      {.reduced_modulus = material.reduced_modulus,
       .damping = material.damping,
       .tangential = material.tangential,
       .friction = friction,
       .work_of_adhesion = work_of_adhesion,
       .rolling_friction = has_rolling_friction(scene.powder) ? material.rolling_friction : 0},
      scene.numerics.tangential_spring == TangentialSpring::cut_back ? engine::SpringLimit::cut_back
                                                                     : engine::SpringLimit::free);
}

SceneLaws own_laws(const Scene& scene) {
  const auto material = coarse_material(scene);
  SceneLaws found;
  found.grains = own_law(scene, material.friction, material.work_of_adhesion);
  found.surfaces[engine::kWallMaterial] = own_law(scene, scene.walls.friction, scene.walls.work_of_adhesion);
  for (const ToolSpec& tool : scene.tools)
    found.surfaces[material_of(tool)] = own_law(scene, friction_of(scene, tool), adhesion_of(scene, tool));
  return found;
}

/// The laws of [contact] at the powder's own size.
SceneLaws named_laws(const Scene& scene) {
  const ContactSpec& contact = *scene.contact;
  SceneLaws found;
  found.grains = contact.grains.law;
  found.surfaces[engine::kWallMaterial] = contact.walls.law;
  for (const ToolSpec& tool : scene.tools)
    if (tool.contact) found.surfaces[material_of(tool)] = tool.contact->law;
  return found;
}

}  // namespace

engine::coarse_graining::Material coarse_material(const PowderSpec& powder, CoarseGraining rule) {
  const auto fine = reference_material(powder);
  const double scale = coarse_graining_factor(powder);
  switch (rule) {
    case CoarseGraining::bierwisch:
      return engine::coarse_graining::bierwisch(fine, scale);
  }
  return fine;
}

SceneLaws scene_laws(const Scene& scene, double time_step) {
  if (!scene.contact) return own_laws(scene);
  const std::string& rule_name = scene.contact->coarse_graining;
  const double scale = coarse_graining_factor(scene.powder);
  const auto* rule = engine::coarse_graining::parameter_rule(rule_name);
  SceneLaws found = named_laws(scene);
  const auto scaled = [&](laws::LawParameters& law) {
    // Parameters are those of the original grains, whose collisions are shorter.
    law.rolling.set_time_step(rule_name == kUnscaled ? time_step : time_step / scale);
    if (rule) law = rule->scaled(law, scale);
  };
  scaled(found.grains);
  for (auto& [material, law] : found.surfaces) scaled(law);
  if (!rule) found.scaling = engine::coarse_graining::force_scaling(rule_name, scale);
  return found;
}

engine::laws::LawParameters pair_law(const Scene& scene, const PowderPair& pair, double time_step) {
  Scene alone = scene;
  alone.powder = pair.powder;
  if (pair.contact)
    alone.contact = std::make_shared<const ContactSpec>(
        ContactSpec{*pair.contact, *pair.contact, scene.contact->coarse_graining});
  return scene_laws(alone, time_step).grains;
}

}  // namespace diefill::process
