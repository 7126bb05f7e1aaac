#include "process/powder/material.h"

#include <algorithm>

#include "engine/simulation/simulation.h"
#include "process/powder/changed_scene.h"
#include "process/powder/powder_mixture.h"
#include "process/scene/contact/contact_spec.h"
#include "process/scene/powder/grain_models.h"

namespace diefill::process {

namespace {

/// The rule under which large grains have the forces that the law gives at their size.
constexpr const char* kUnscaled = "none";

std::optional<engine::SleepSettings> sleep_settings(const EconomySpec& economy) {
  if (!economy.sleep) return std::nullopt;
  engine::SleepSettings sleep;
  sleep.time = economy.sleep_after;
  sleep.energy = economy.sleep_energy;
  sleep.force = economy.wake_force;
  return sleep;
}

/// Coulomb coefficient of the law in use.
double friction_among_grains(const Scene& scene) {
  return scene.contact ? scene.contact->grains.law.friction.largest_friction() : scene.powder.friction;
}

/// By the law in use.
bool grains_stick(const Scene& scene) {
  if (!scene.contact) return scene.powder.work_of_adhesion > 0;
  // Bierwisch's spheres lie as loosely as their own work of adhesion makes them.
  const auto& law = scene.contact->grains.law;
  const auto* own = law.normal.of<engine::laws::BierwischNormal>();
  return own != nullptr ? own->work_of_adhesion > 0 : law.attracts();
}

}  // namespace

engine::SimulationSettings engine_settings(const Scene& scene, double impact_speed) {
  engine::SimulationSettings settings;
  settings.types = particle_types(scene);
  settings.lever_arm =
      scene.numerics.lever_arm == LeverArm::center ? engine::LeverArm::center : engine::LeverArm::contact;
  settings.gravity = scene.gravity;
  // Grains under the law of small ones as it stands fall through air as they stand, too.
  settings.air_viscosity = scene.contact && scene.contact->coarse_graining == kUnscaled
                               ? scene.powder.air_viscosity
                               : coarse_material(scene).air_viscosity;
  for (std::size_t axis = 0; axis < 3; ++axis) settings.period[axis] = scene.numerics.period[axis];
  settings.skip_far_walls = scene.economy.skip_far_walls;
  settings.sleep = sleep_settings(scene.economy);
  settings.skin = scene.numerics.skin;
  constexpr double kAnyStep = 1e-30;  // s: laws that refuse steps too long are asked for their limit first
  settings.contact = contact_laws(scene, kAnyStep);
  settings.time_step = chosen_time_step(scene, settings, impact_speed);
  for (const Scene& later : changed_scenes(scene)) {
    engine::SimulationSettings changed = settings;
    changed.contact = contact_laws(later, kAnyStep);
    settings.time_step = std::min(settings.time_step, chosen_time_step(later, changed, impact_speed));
  }
  settings.contact = contact_laws(scene, settings.time_step);
  return settings;
}

double mean_grain_mass(const Scene& scene, const PowderInflow& inflow, const engine::Simulation& simulation) {
  return simulation.types().monodisperse() ? simulation.settings().shape().mass
                                           : mean_of_inflow(scene, inflow).mass;
}

double smallest_sphere(const engine::SimulationSettings& settings) {
  double smallest = settings.shape().sphere_radius;
  for (const auto& type : settings.types) smallest = std::min(smallest, type.shape.sphere_radius);
  return smallest;
}

double expected_solid_fraction(const Scene& scene) {
  if (scene.pour.solid_fraction > 0) return scene.pour.solid_fraction;
  const bool sticky = grains_stick(scene);
  const bool rough = friction_among_grains(scene) >= 0.5;
  // A clump of the scene's own packs like the clumps of model D.
  const GrainModel model = scene.powder.clump ? GrainModel::D : scene.powder.model;
  return facts_of(model).settled[sticky ? 1 : 0][rough ? 1 : 0];
}

}  // namespace diefill::process
