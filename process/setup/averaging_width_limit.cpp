#include "process/setup/averaging_width_limit.h"

#include "process/input/numbers_apart.h"
#include "process/input/scene_error.h"
#include "process/measure/fields/averaging_width.h"

namespace diefill::process {
namespace {

/// m: of the cavity, or where there is none of the box about tools and poured powder.
double largest_edge(const Scene& scene, const Tooling& tooling) {
  if (tooling.cavity.found) return tooling.cavity.box.size().maxCoeff();
  geometry::Box box = tooling.all;
  box.include(scene.pour.lower);
  box.include(scene.pour.upper);
  return box.size().maxCoeff();
}

}  // namespace

void refuse_wide_averaging(const Scene& scene, const Tooling& tooling) {
  constexpr double kRounding = 1e-9;
  const double width = scene.measure.averaging_width;
  const double most = largest_averaging_width(scene.powder.grain_diameter, largest_edge(scene, tooling));
  if (width <= most * (1 + kRounding)) return;
  const auto [found, allowed] = numbers_apart(1e3 * width, 1e3 * most);
  throw SceneError(scene.measure.width_place + ": found " + found + " mm, allowed: at most " + allowed +
                   " mm, the largest edge of " +
                   (tooling.cavity.found ? "the cavity" : "the box about tools and powder") +
                   ": above, the field is the same everywhere");
}

}  // namespace diefill::process
