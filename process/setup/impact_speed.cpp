#include "process/setup/impact_speed.h"

#include <algorithm>
#include <cmath>

#include "process/powder/changed_scene.h"
#include "process/powder/material.h"
#include "process/setup/pour.h"

namespace diefill::process {

namespace {

/// m/s, of any tool's farthest point in any step.
double fastest_tool(const Scene& scene, const Tooling& tooling) {
  constexpr int kInstants = 200;
  constexpr double kOpenEnded = 1;  // s, long enough to see what such a step does
  double fastest = 0;
  for (const auto& step : scene.steps) {
    const double length = step->open_ended() ? kOpenEnded : step->duration().value_or(kOpenEnded);
    for (const auto& name : step->tools()) {
      const geometry::Box box = tooling.tools[tooling.index_of(name)].mesh.bounding_box();
      for (int n = 0; n <= kInstants; ++n) {
        const ToolMotion motion = step->motion(length * n / kInstants);
        const double reach = (0.5 * (box.lower + box.upper) - motion.pivot).norm() + 0.5 * box.size().norm();
        fastest = std::max(fastest, motion.velocity.norm() + motion.angular_velocity.norm() * reach);
      }
    }
  }
  return fastest;
}

}  // namespace

double expected_impact_speed(const Scene& scene, double fall_height) {
  constexpr double kSlowest = 0.5;  // m/s: grains fall into cavities even where they are hardly poured
  constexpr double kFastest = 8;    // deviations, of two grains of random velocity that meet
  double random = 0;
  for (const auto& step : scene.steps)
    if (const PowderChange* change = step->change())
      random = std::max(random, kFastest * change->random_velocity);
  const double fall = std::sqrt(2 * largest_gravity(scene) * std::max(0.0, fall_height));
  return std::max({kSlowest, fall, random});
}

double predicted_impact_speed(const Scene& scene, const Tooling& tooling) {
  const double cavity_depth = tooling.cavity.found ? tooling.all_cavities().box.size()[2] : 0;
  const double height = pour_height(scene, engine_settings(scene, 1.0));
  const double fall = std::max(height - scene.pour.fill_height, cavity_depth);
  return std::max(expected_impact_speed(scene, fall), fastest_tool(scene, tooling));
}

}  // namespace diefill::process
