#include "process/setup/near_half.h"

#include <cstdio>

#include "engine/powder/rigid_motion.h"
#include "process/input/scene_error.h"

namespace diefill::process {

namespace {

constexpr double kThroughPlane = 0.25;  // of a sphere's radius: half of it lies in its image

[[noreturn]] void refuse_across_mirror(const Scene& scene, const std::string& key,
                                       const Eigen::Vector3d& centre, double through) {
  const char axis = *scene.economy.mirror == 0 ? 'x' : 'y';
  char text[300];
  std::snprintf(text, sizeof text,
                ": found a grain with a sphere at (%.2f, %.2f, %.2f) mm that reaches %.3g mm through the "
                "mirror plane %c = 0, where it would start inside its own image; give powder of a half model "
                "(economy.mirror = \"%c\"), or remove economy.mirror",
                1e3 * centre[0], 1e3 * centre[1], 1e3 * centre[2], 1e3 * through, axis, axis);
  throw SceneError(scene.file.string() + ":" + std::to_string(scene.pour.line) + ": pour." + key + text);
}

}  // namespace

std::vector<engine::NewGrain> near_half(const Scene& scene, const engine::SimulationSettings& settings,
                                        std::vector<engine::NewGrain> grains, const std::string& key) {
  if (!scene.economy.mirror) return grains;
  const int axis = *scene.economy.mirror;
  std::erase_if(grains, [axis](const engine::NewGrain& grain) { return grain.position[axis] < 0; });
  for (const engine::NewGrain& grain : grains) {
    const engine::GrainShape& shape = settings.types[grain.kind].shape;
    if (grain.position[axis] >= shape.bounding_radius()) continue;
    const Eigen::Matrix3d turn = engine::rotation_matrix(grain.orientation);
    for (std::size_t k = 0; k < shape.spheres(); ++k) {
      const Eigen::Vector3d centre = grain.position + turn * shape.sphere_offsets[k];
      const double through = shape.radius_of(k) - centre[axis];
      if (through > kThroughPlane * shape.radius_of(k)) refuse_across_mirror(scene, key, centre, through);
    }
  }
  return grains;
}

}  // namespace diefill::process
