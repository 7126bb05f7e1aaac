#include "process/setup/restored_grains.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include "engine/powder/rigid_motion.h"
#include "engine/simulation/settings.h"
#include "geometry/solid/solid_query.h"
#include "process/results/storage/result_file.h"

namespace diefill::process {

namespace {

constexpr double kSame = 1e-4;      // share by which sizes may differ
constexpr double kPressedIn = 0.5;  // of its radius, that a sphere at rest is never pressed into a wall

[[noreturn]] void refuse(const Scene& scene, const std::string& key, const std::string& why) {
  throw SceneError(scene.file.string() + ":" + std::to_string(scene.pour.line) + ": pour." + key + ": " +
                   why);
}

bool alike(double one, double other) {
  return std::abs(one - other) <= kSame * std::abs(other);
}

void refuse_other_grains(const Scene& scene, const engine::SimulationSettings& settings,
                         const results::PowderState& powder) {
  const std::size_t types = powder.monodisperse() ? 1 : powder.kinds.size();
  if (types != settings.types.size())
    refuse(scene, "state",
           "that run had " + std::to_string(types) + " grain sizes or powders, this scene has " +
               std::to_string(settings.types.size()) + "; give the same [powder]");
  for (std::size_t k = 0; k < types; ++k) {
    const engine::GrainShape& shape = settings.types[k].shape;
    const double then = powder.monodisperse() ? powder.grain_diameter : powder.kinds.diameter[k];
    const double mass = powder.monodisperse() ? powder.grain_mass : powder.kinds.mass[k];
    const std::size_t spheres =
        powder.kinds.spheres.empty() ? powder.sphere_offsets.size() : powder.kinds.spheres[k];
    char text[240];
    std::snprintf(
        text, sizeof text,
        "that run had grains of %.6g mm, %zu spheres and %.6g mg, this scene has grains of %.6g mm, "
        "%zu spheres and %.6g mg; give the same [powder] and grain_diameter",
        1e3 * then, spheres, 1e6 * mass, 2e3 * shape.bounding_radius(), shape.spheres(), 1e6 * shape.mass);
    if (!alike(then, 2 * shape.bounding_radius()) || !alike(mass, shape.mass) || spheres != shape.spheres())
      refuse(scene, "state", text);
  }
}

void refuse_other_period(const Scene& scene, const results::PowderState& powder) {
  static const char* const kAxes[] = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double now = scene.numerics.period[axis].value_or(0);
    if (alike(powder.period[axis], now)) continue;
    char text[200];
    std::snprintf(
        text, sizeof text,
        "that run had a period of %.6g mm along %s, this scene has %.6g mm (0: none); give the same "
        "numerics.periodic",
        1e3 * powder.period[axis], kAxes[axis], 1e3 * now);
    refuse(scene, "state", text);
  }
}

/// A grain that rests on a tool penetrates it by its contact overlap only; a deeper one would be ejected.
void refuse_grain_in_tool(const Scene& scene, const engine::SimulationSettings& settings,
                          const Tooling& tooling, const std::vector<engine::NewGrain>& grains) {
  for (const Tool& tool : tooling.tools) {
    const geometry::SolidQuery& solid = tool.solid();
    for (const auto& grain : grains) {
      const engine::GrainShape& shape = settings.types[grain.kind].shape;
      const double reach = shape.bounding_radius();
      if (solid.signed_distance(grain.position) > reach) continue;
      const Eigen::Matrix3d turn = engine::rotation_matrix(grain.orientation);
      for (std::size_t k = 0; k < shape.spheres(); ++k) {
        const Eigen::Vector3d centre = grain.position + turn * shape.sphere_offsets[k];
        const double in = shape.radius_of(k) - solid.signed_distance(centre);
        if (in <= kPressedIn * shape.radius_of(k)) continue;
        char text[240];
        std::snprintf(text, sizeof text,
                      "tool \"%s\" reaches %.3g mm into a grain at (%.2f, %.2f, %.2f) mm; move the tool, or "
                      "cut the powder lower with state_below",
                      tool.spec.name.c_str(), 1e3 * in, 1e3 * centre[0], 1e3 * centre[1], 1e3 * centre[2]);
        refuse(scene, "state", text);
      }
    }
  }
}

results::PowderState powder_for(const Scene& scene, const SavedState& state) {
  try {
    return powder_of(state);
  } catch (const results::ResultError& error) {
    refuse(scene, "state", error.what());
  }
}

/// Results of other programs may leave lists out, which pictures do without.
void refuse_missing_lists(const Scene& scene, const results::PowderState& powder) {
  const std::size_t grains = powder.position.size();
  for (const auto& [what, entries] : {std::pair{"velocity", powder.velocity.size()},
                                      {"orientation", powder.orientation.size()},
                                      {"angular_velocity", powder.angular_velocity.size()}})
    if (entries != grains)
      refuse(
          scene, "state",
          std::string("those results have no /powder/") + what +
              " of the grains, which a run needs to start from; give the results of a run of this program");
}

}  // namespace

std::vector<engine::NewGrain> restored_grains(const Scene& scene, const engine::SimulationSettings& settings,
                                              const Tooling& tooling, const SavedState& state) {
  const results::PowderState powder = powder_for(scene, state);
  refuse_missing_lists(scene, powder);
  refuse_other_grains(scene, settings, powder);
  refuse_other_period(scene, powder);
  std::vector<engine::NewGrain> grains;
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    engine::NewGrain grain;
    grain.position = powder.position[k];
    grain.velocity = powder.velocity[k];
    grain.orientation = powder.orientation[k];
    grain.angular_velocity = powder.angular_velocity[k];
    grain.kind = powder.monodisperse() ? engine::TypeNumber{0} : powder.kind[k];
    grains.push_back(grain);
  }
  refuse_grain_in_tool(scene, settings, tooling, grains);
  return grains;
}

}  // namespace diefill::process
