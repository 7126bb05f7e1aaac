#include "process/tradeoff/work_estimate.h"

#include "process/powder/material.h"
#include "process/setup/impact_speed.h"
#include "process/setup/pour.h"

namespace diefill::process {

double expected_impact_speed(const Scene& scene) {
  return expected_impact_speed(scene, pour_height(scene, engine_settings(scene, 1.0)));
}

double time_step_fraction(const Scene& scene) {
  const double impact = expected_impact_speed(scene);
  const auto settings = engine_settings(scene, impact);
  return settings.time_step / critical_time_step(settings, impact);
}

double work_per_second(const Scene& scene) {
  const auto settings = engine_settings(scene, expected_impact_speed(scene));
  const Eigen::Vector3d box = scene.pour.upper - scene.pour.lower;
  const double solid = box[0] * box[1] * scene.pour.fill_height * expected_solid_fraction(scene);
  const double spheres =
      solid / mean_grain(scene).solid_volume * static_cast<double>(settings.shape().spheres());
  return spheres / settings.time_step;
}

}  // namespace diefill::process
