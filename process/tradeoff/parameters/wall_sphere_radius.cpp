#include "process/tradeoff/parameters/parameters.h"

namespace diefill::process {
namespace {

std::vector<std::string> usual(const Scene& scene) {
  return {in_millimetres(2 * scene.walls.sphere_radius), in_millimetres(0.5 * scene.walls.sphere_radius)};
}

}  // namespace

Parameter wall_sphere_radius_parameter() {
  return {.name = "wall_sphere_radius",
          .label = "radius of wall spheres",
          .sign = "wall R",
          .finer = Finer::smaller,
          .dimension = Dimension::length,
          .current = [](const Scene& scene) { return in_millimetres(scene.walls.sphere_radius); },
          .usual = usual,
          .changes = sets_key("walls.sphere_radius")};
}

}  // namespace diefill::process
