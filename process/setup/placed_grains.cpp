#include "process/setup/placed_grains.h"

#include <cmath>
#include <cstdio>

#include "engine/simulation/settings.h"
#include "process/scene/placed_grains.h"
#include "process/setup/pour_fit.h"

namespace diefill::process {

namespace {

constexpr double kSameRadius = 0.01;

/// Number of the type with that radius (m).
engine::TypeNumber type_with(double radius, const Scene& scene, const engine::SimulationSettings& settings) {
  for (std::size_t type = 0; type < settings.types.size(); ++type)
    if (std::abs(settings.types[type].shape.bounding_radius() - radius) <= kSameRadius * radius)
      return static_cast<engine::TypeNumber>(type);
  std::string sizes;
  char text[160];
  for (const auto& type : settings.types) {
    std::snprintf(text, sizeof text, "%s%.6g mm", sizes.empty() ? "" : ", ",
                  2e3 * type.shape.bounding_radius());
    sizes += text;
  }
  std::snprintf(text, sizeof text,
                ": pour.grains_file: found a grain %.6g mm in diameter, but those of the powder are ",
                2e3 * radius);
  throw SceneError(scene.file.string() + ":" + std::to_string(scene.pour.line) + text + sizes +
                   "; change grain_diameter, or the radii in the file");
}

}  // namespace

std::vector<engine::NewGrain> placed_grains(const Scene& scene, const engine::SimulationSettings& settings,
                                            const Tooling& tooling, const std::filesystem::path& file) {
  std::vector<double> radii;
  for (const auto& type : settings.types) {
    if (type.shape.spheres() > 1)
      throw SceneError(
          scene.file.string() + ":" + std::to_string(scene.pour.line) +
          ": pour.grains_file: places single spheres, but a grain of the powder has several; use "
          "model A or B");
    radii.push_back(type.shape.bounding_radius());
  }
  std::vector<engine::NewGrain> grains;
  for (const engine::ClumpSphere& placed : grains_in_file(file)) {
    engine::NewGrain grain;
    grain.position = placed.centre;
    grain.kind = type_with(placed.radius, scene, settings);
    grains.push_back(grain);
  }
  refuse_overlap(scene, tooling, grains, radii);
  return grains;
}

}  // namespace diefill::process
