#include "process/tradeoff/parameters/parameters.h"

namespace diefill::process {
namespace {

constexpr const char* kAdaptive = "adaptive";

std::string current(const Scene& scene) {
  return scene.numerics.skin > 0 ? in_millimetres(scene.numerics.skin) : kAdaptive;
}

/// Fractions of the radius of the smallest basic spheres.
std::vector<std::string> usual(const Scene& scene) {
  const double radius = scene.powder.grain_diameter / diameter_over_radius(scene.powder);
  return {in_millimetres(0.1 * radius), in_millimetres(radius)};
}

SceneChanges changes(const Scene&, const std::string& value) {
  if (value == kAdaptive) return {"", {"numerics.skin"}};
  return {"numerics.skin = " + toml_value(value) + '\n', {}};
}

}  // namespace

Parameter skin_parameter() {
  return {.name = "skin",
          .label = "skin of the neighbour lists",
          .sign = "skin",
          .dimension = Dimension::length,
          .current = current,
          .usual = usual,
          .changes = changes};
}

}  // namespace diefill::process
