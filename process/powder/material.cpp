#include "process/powder/material.h"

#include <algorithm>
#include <limits>

#include "engine/coarse_graining/bierwisch.h"
#include "engine/coarse_graining/methods.h"
#include "engine/limits/general_time_step.h"
#include "engine/limits/mix_time_step.h"
#include "engine/limits/time_step.h"
#include "process/input/numbers_apart.h"
#include "process/powder/mixed_powder.h"
#include "process/powder/tool_surface.h"
#include "process/scene/contact_spec.h"

namespace diefill::process {

namespace {

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

engine::coarse_graining::Material coarse_material(const Scene& scene) {
  const auto fine = reference_material(scene.powder);
  const double scale = coarse_graining_factor(scene.powder);
  switch (scene.coarse_graining) {
    case CoarseGraining::bierwisch:
      return engine::coarse_graining::bierwisch(fine, scale);
  }
  return fine;
}

/// The laws of [contact] at the wanted grain size, for steps of `time_step` (s).
engine::GeneralContact general_contact(const ContactSpec& spec, double scale, double time_step) {
  engine::GeneralContact contact{spec.grains.law, spec.walls.law, {}};
  const bool unscaled = spec.coarse_graining == kUnscaled;
  // Parameters are those of the original grains, whose collisions are shorter.
  for (auto* law : {&contact.grains, &contact.walls})
    law->rolling.run_in_steps_of(unscaled ? time_step : time_step / scale);
  if (const auto* rule = engine::coarse_graining::parameter_rule(spec.coarse_graining))
    return {rule->scaled(contact.grains, scale), rule->scaled(contact.walls, scale), {}};
  contact.scaling = engine::coarse_graining::force_scaling(spec.coarse_graining, scale);
  return contact;
}

/// The shape with moments of inertia as the simulation takes them, where forces are scaled.
engine::GrainShape as_simulated(const engine::SimulationSettings& settings) {
  engine::GrainShape shape = settings.shape;
  shape.inertia /= settings.general_contact->scaling.torque_factor();
  return shape;
}

engine::GrainShape shape_of(GrainModel model, double radius, double mass) {
  switch (model) {
    case GrainModel::A:
      return engine::model_a(radius, mass);
    case GrainModel::B:
      return engine::model_b(radius, mass);
    case GrainModel::C:
      return engine::model_c(radius, mass);
    case GrainModel::D:
      break;
  }
  return engine::model_d(radius, mass);
}

/// Of the time step at which a pinched sphere becomes unstable.
constexpr double kPinchFraction = 0.8;

/// Over the sphere radius: how deep a grain is wedged before it is taken out, with what it is pressed further
/// until that is seen, or before the run stops (engine::HealthLimits).
double deepest_wedging(const Scene& scene) {
  constexpr double kUntilSeen = 0.05;
  return scene.numerics.pinched_grains == PinchedGrains::shear_off ? kShearingOverlap + kUntilSeen : 1.0;
}

/// s: of a grain of these settings, wedged by `depth` over the sphere radius.
double pinch_step(const engine::SimulationSettings& settings, double depth, double wall_radius,
                  double wall_spacing) {
  const double overlap = depth * settings.shape.sphere_radius;
  if (settings.general_contact)
    return engine::pinch_time_step(as_simulated(settings), *settings.general_contact, wall_radius,
                                   wall_spacing, overlap);
  return engine::pinch_time_step(settings.shape, settings.wall_contact, wall_radius, wall_spacing, overlap);
}

/// s: the same between walls such as the tool's.
double pinch_step_at(const Scene& scene, const ToolSpec& tool, const engine::SimulationSettings& settings,
                     double depth) {
  if (tool.walls.value_or(scene.walls.kind) == WallKind::mesh) {
    // In a corner a grain meets three faces: three times the stiffness and the damping ask for no less than a
    // third of the step.
    constexpr double kFaces = 3, kFlat = std::numeric_limits<double>::infinity();
    return pinch_step(settings, depth, kFlat, kFlat) / kFaces;
  }
  const double radius = tool.sphere_radius.value_or(scene.walls.sphere_radius);
  return pinch_step(settings, depth, radius, tool.spacing.value_or(scene.walls.spacing) * radius);
}

/// Settings of a powder of one kind for each kind of `settings`.
std::vector<engine::SimulationSettings> kinds_alone(const engine::SimulationSettings& settings) {
  if (!settings.mix) return {settings};
  std::vector<engine::SimulationSettings> alone;
  for (const engine::ParticleType& kind : settings.mix->kinds) {
    const auto& laws = settings.mix->laws;
    engine::SimulationSettings one = settings;
    one.mix.reset();
    one.shape = kind.shape;
    one.general_contact = engine::GeneralContact{
        engine::laws::law_between(laws, kind.material, kind.material),
        engine::laws::law_between(laws, kind.material, kWallMaterial), settings.mix->scaling};
    alone.push_back(std::move(one));
  }
  return alone;
}

/// s: for the finest wall spheres that the scene's tools have, at the deepest overlap of grains wedged at an
/// edge. No limit where no tool moves.
double shortest_pinch_step(const Scene& scene, const engine::SimulationSettings& settings) {
  double shortest = std::numeric_limits<double>::infinity();
  const auto moves = [](const auto& step) { return !step->tools().empty(); };
  if (std::none_of(scene.steps.begin(), scene.steps.end(), moves)) return shortest;
  const auto kinds = kinds_alone(settings);
  const double depth = deepest_wedging(scene);
  for (const ToolSpec& tool : scene.tools)
    for (const auto& kind : kinds) shortest = std::min(shortest, pinch_step_at(scene, tool, kind, depth));
  return shortest;
}

double chosen_time_step(const Scene& scene, const engine::SimulationSettings& settings, double critical) {
  const NumericsSpec& numerics = scene.numerics;
  if (!numerics.time_step) {
    const double fraction =
        numerics.time_step_fraction > 0 ? numerics.time_step_fraction : engine::kDefaultTimeStepFraction;
    if (numerics.time_step_fraction > 0) return fraction * critical;
    return std::min(fraction * critical, wedged_time_step(scene, settings));
  }
  if (*numerics.time_step < critical) return *numerics.time_step;
  const auto [found, longest] = numbers_apart(*numerics.time_step, critical);
  throw SceneError(scene.file.string() + ": numerics.time_step: found " + found +
                   " s, which is above the critical step of " + longest +
                   " s for this powder; reduce it or remove the key");
}

/// Puts the laws for steps of `time_step` (s) into the settings, where they are not those of a powder of one
/// size without [contact].
void set_laws(const Scene& scene, double time_step, engine::SimulationSettings& settings) {
  const bool several = !scene.powder.sizes.empty();
  if (!scene.contact && !several) return;
  engine::GeneralContact contact =
      scene.contact ? general_contact(*scene.contact, coarse_graining_factor(scene.powder), time_step)
                    : own_law(settings);
  if (several)
    settings.mix = grain_mix(scene, settings.shape, contact);
  else
    settings.general_contact = std::move(contact);
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
  const auto material = coarse_material(scene);
  engine::SimulationSettings settings;
  settings.shape = shape_of(scene.powder.model, material.sphere_radius, material.grain_mass);
  settings.grain_contact = {material.reduced_modulus, material.damping,          material.tangential,
                            material.friction,        material.work_of_adhesion, material.rolling_friction};
  settings.wall_contact = settings.grain_contact;
  settings.wall_contact.friction = scene.walls.friction;
  settings.wall_contact.work_of_adhesion = scene.walls.work_of_adhesion;
  settings.lever_arm =
      scene.numerics.lever_arm == LeverArm::center ? engine::LeverArm::center : engine::LeverArm::contact;
  settings.spring_limit = scene.numerics.tangential_spring == TangentialSpring::cut_back
                              ? engine::SpringLimit::cut_back
                              : engine::SpringLimit::free;
  settings.gravity = scene.gravity;
  settings.air_viscosity = material.air_viscosity;
  settings.period = scene.numerics.period;
  settings.skip_far_walls = scene.economy.skip_far_walls;
  if (scene.economy.sleep) {
    settings.sleep = engine::SleepSettings{};
    settings.sleep->time = scene.economy.sleep_after;
    settings.sleep->energy = scene.economy.sleep_energy;
    settings.sleep->force = scene.economy.wake_force;
  }
  settings.skin = scene.numerics.skin;
  const auto& contact = scene.contact;
  constexpr double kAnyStep = 1e-30;  // s: laws that refuse steps too long are asked for their limit first
  set_laws(scene, kAnyStep, settings);
  settings.time_step = chosen_time_step(scene, settings, critical_time_step(settings, impact_speed));
  set_laws(scene, settings.time_step, settings);
  // Grains under the law of small ones as it stands fall through air as they stand, too.
  if (contact && contact->coarse_graining == kUnscaled) settings.air_viscosity = scene.powder.air_viscosity;
  return settings;
}

double critical_time_step(const engine::SimulationSettings& settings, double impact_speed) {
  if (settings.mix)
    return engine::critical_time_step(
        *settings.mix, {{kWallMaterial, std::numeric_limits<double>::infinity()}}, impact_speed);
  if (settings.general_contact)
    return engine::critical_time_step(as_simulated(settings), *settings.general_contact, impact_speed);
  return engine::critical_time_step(settings.shape, settings.grain_contact, impact_speed);
}

double wedged_time_step(const Scene& scene, const engine::SimulationSettings& settings) {
  return kPinchFraction * shortest_pinch_step(scene, settings);
}

double mean_grain_mass(const Scene& scene, const engine::Simulation& simulation) {
  return simulation.kinds().monodisperse() ? simulation.settings().shape.mass
                                           : coarse_material(scene).grain_mass;
}

double smallest_sphere(const engine::SimulationSettings& settings) {
  double smallest = settings.shape.sphere_radius;
  if (settings.mix)
    for (const auto& kind : settings.mix->kinds) smallest = std::min(smallest, kind.shape.sphere_radius);
  return smallest;
}

double expected_solid_fraction(const Scene& scene) {
  if (scene.pour.solid_fraction > 0) return scene.pour.solid_fraction;
  const bool sticky = grains_stick(scene);
  const bool rough = friction_among_grains(scene) >= 0.5;
  switch (scene.powder.model) {
    case GrainModel::A:
      return sticky ? 0.48 : rough ? 0.55 : 0.58;
    case GrainModel::B:
      return rough ? 0.52 : 0.57;
    case GrainModel::C:
      return sticky ? 0.40 : rough ? 0.45 : 0.50;
    case GrainModel::D:
      break;
  }
  return sticky || rough ? 0.32 : 0.38;
}

}  // namespace diefill::process
