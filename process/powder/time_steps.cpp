#include "process/powder/time_steps.h"

#include <algorithm>
#include <limits>
#include <set>

#include "engine/limits/time_step.h"
#include "engine/simulation/settings.h"
#include "process/input/numbers_apart.h"
#include "process/input/units.h"
#include "process/powder/tool_surface.h"

namespace diefill::process {

namespace {

/// Of the time step at which a pinched sphere becomes unstable.
constexpr double kPinchFraction = 0.8;

constexpr double kFlat = std::numeric_limits<double>::infinity();

engine::ParticleTypes moving_types(const engine::SimulationSettings& settings) {
  return engine::moving_types(settings.types, settings.contact.scaling);
}

/// Planes of all materials that are not those of grains.
std::vector<engine::WallSurface> surfaces_of(const engine::SimulationSettings& settings) {
  std::set<std::string> of_grains, of_walls;
  for (const auto& type : settings.types) of_grains.insert(type.material);
  for (const auto& pair : settings.contact.pairs)
    for (const auto& material : {pair.first, pair.second})
      if (!of_grains.contains(material)) of_walls.insert(material);
  std::vector<engine::WallSurface> surfaces;
  for (const auto& material : of_walls) surfaces.push_back({.material = material});
  return surfaces;
}

/// Over the sphere radius: how deep a grain is wedged before it is taken out, with what it is pressed further
/// until that is seen, or before the run stops (engine::ValidityLimits).
double deepest_wedging(const Scene& scene) {
  constexpr double kUntilSeen = 0.05;
  return scene.numerics.pinched_grains == PinchedGrains::shear_off ? kShearingOverlap + kUntilSeen : 1.0;
}

/// s: of spheres of `own` class, wedged by `depth` over the sphere radius between walls such as the tool's.
double pinch_step(const Scene& scene, const ToolSpec& tool, const engine::ParticleTypes& types,
                  const engine::ContactLaws& contact, engine::ClassNumber own, double depth) {
  const double overlap = depth * types.classes()[own].radius;
  engine::WallSurface surface{.material = material_of(tool)};
  if (tool.walls.value_or(scene.walls.kind) == WallKind::mesh) {
    // In a corner a grain meets three faces: three times the stiffness and the damping ask for no less than a
    // third of the step.
    constexpr double kFaces = 3;
    return engine::pinch_time_step(types, contact, own, surface, kFlat, overlap) / kFaces;
  }
  surface.radius = tool.sphere_radius.value_or(scene.walls.sphere_radius);
  const double spacing = tool.spacing.value_or(scene.walls.spacing) * surface.radius;
  return engine::pinch_time_step(types, contact, own, surface, spacing, overlap);
}

[[noreturn]] void refuse(const Scene& scene, const std::string& key, const std::string& reason) {
  throw SceneError(scene.file.string() + ": numerics." + key + ": found " + reason + " or remove the key");
}

/// The part of a message that follows a step (s) too long for the dampers of contacts that last.
std::string too_long_for_damping(const std::string& longest) {
  return " s, which is not below the " + longest +
         " s up to which contacts with this damping are stable; reduce it, lower the damping";
}

[[noreturn]] void refuse_own_step(const Scene& scene, double critical, double lasting) {
  const double step = *scene.numerics.time_step;
  const auto [found, longest] = numbers_apart(step, step < critical ? lasting : critical);
  if (step < critical) refuse(scene, "time_step", found + too_long_for_damping(longest));
  const std::string below =
      lasting < critical ? " below " + number_text(lasting) + " s, the limit of its damping," : "";
  refuse(
      scene, "time_step",
      found + " s, which is above the critical step of " + longest + " s for this powder; reduce it" + below);
}

[[noreturn]] void refuse_fraction(const Scene& scene, double step, double lasting) {
  const auto [found, longest] = numbers_apart(step, lasting);
  refuse(scene, "time_step_fraction",
         number_text(scene.numerics.time_step_fraction) + ", a step of " + found +
             too_long_for_damping(longest));
}

}  // namespace

double critical_time_step(const engine::SimulationSettings& settings, double impact_speed) {
  return engine::critical_time_step(moving_types(settings), settings.contact, surfaces_of(settings),
                                    impact_speed);
}

double wedged_time_step(const Scene& scene, const engine::SimulationSettings& settings) {
  double shortest = std::numeric_limits<double>::infinity();
  const auto moves = [](const auto& step) { return !step->tools().empty(); };
  if (std::none_of(scene.steps.begin(), scene.steps.end(), moves)) return shortest;
  const auto types = moving_types(settings);
  const double depth = deepest_wedging(scene);
  for (const ToolSpec& tool : scene.tools)
    for (std::size_t own = 0; own < types.classes().size(); ++own)
      shortest = std::min(shortest, pinch_step(scene, tool, types, settings.contact,
                                               static_cast<engine::ClassNumber>(own), depth));
  return kPinchFraction * shortest;
}

double lasting_contact_time_step(const engine::SimulationSettings& settings, double impact_speed) {
  return engine::lasting_contact_time_step(moving_types(settings), settings.contact, surfaces_of(settings),
                                           impact_speed);
}

double chosen_time_step(const Scene& scene, const engine::SimulationSettings& settings, double impact_speed) {
  const NumericsSpec& numerics = scene.numerics;
  const double critical = critical_time_step(settings, impact_speed);
  if (!numerics.time_step && !(numerics.time_step_fraction > 0))
    return std::min(engine::kDefaultTimeStepFraction * critical, wedged_time_step(scene, settings));
  const double lasting = lasting_contact_time_step(settings, impact_speed);
  if (!numerics.time_step) {
    const double step = numerics.time_step_fraction * critical;
    if (step < lasting) return step;
    refuse_fraction(scene, step, lasting);
  }
  if (*numerics.time_step < std::min(critical, lasting)) return *numerics.time_step;
  refuse_own_step(scene, critical, lasting);
}

}  // namespace diefill::process
