#include "process/plan/forecast.h"

#include <algorithm>
#include <cmath>

#include "process/plan/pilot.h"
#include "process/powder/material.h"
#include "process/powder/powder_mixture.h"
#include "process/setup/impact_speed.h"
#include "process/setup/pour.h"
#include "process/tooling/predicted_memory.h"

namespace diefill::process::plan {

namespace {

/// 1/m, floor and sides of powder poured so high (m) over its volume.
double bounds_over_volume(const Scene& scene, double fill_height) {
  double sum = 1 / fill_height;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    if (!scene.numerics.period[axis]) sum += 2 / (scene.pour.upper[i] - scene.pour.lower[i]);
  }
  return sum;
}

/// How many times as large a share of the scene's grains touches tools as of its pilot's: these form a layer
/// one grain thick along the boundary of the powder.
double near_tools_over_pilot(const Scene& scene, const Pilot& pilot) {
  if (pilot.grain_diameter <= 0 || pilot.fill_height <= 0) return 1;
  return scene.powder.grain_diameter / pilot.grain_diameter *
         bounds_over_volume(scene, scene.pour.fill_height) / bounds_over_volume(scene, pilot.fill_height);
}

}  // namespace

double Forecast::steps() const {
  double sum = 0;
  for (const auto& phase : phases) sum += phase.steps;
  return sum;
}

double Forecast::sphere_steps() const {
  double sum = 0;
  for (const auto& phase : phases) sum += phase.sphere_steps;
  return sum;
}

double Forecast::seconds() const {
  double sum = 0;
  for (const auto& phase : phases) sum += phase.phase.seconds;
  return sum;
}

Forecast forecast(const Scene& scene, const Tooling& tooling, const RestTimes& rest) {
  const double impact = predicted_impact_speed(scene, tooling);
  const auto settings = engine_settings(scene, impact);
  Forecast forecast;
  forecast.grain_diameter = scene.powder.grain_diameter;
  forecast.fill_height = scene.pour.fill_height;
  forecast.time_step = settings.time_step;
  forecast.critical_step = critical_time_step(settings, impact);
  forecast.grains = grains_to_pour(scene);
  forecast.spheres = static_cast<std::size_t>(
      std::llround(static_cast<double>(forecast.grains) * mean_of_poured(scene).spheres));
  forecast.wall_spheres = tooling.wall_spheres();
  double largest_share = 1;
  for (const Phase& phase : timeline(scene, tooling, rest)) {
    PhaseForecast part;
    part.phase = phase;
    part.steps = std::ceil(phase.seconds / forecast.time_step);
    part.sphere_steps = part.steps * phase.share * static_cast<double>(forecast.spheres);
    largest_share = std::max(largest_share, phase.share);
    forecast.phases.push_back(part);
  }
  forecast.memory = predicted_memory(largest_share * static_cast<double>(forecast.spheres),
                                     static_cast<double>(forecast.wall_spheres));
  return forecast;
}

Forecast forecast(const Scene& scene, const Tooling& tooling, const Pilot& pilot) {
  Forecast forecast = plan::forecast(scene, tooling, pilot.rest);
  // Neighbour lists are valid until a grain has moved as far as the skin allows, a share of its size, and
  // grains of any size move at the same speed.
  const double speed_in_fall = pilot.fall_time > 0 ? fall_time(scene, tooling) / pilot.fall_time : 1;
  const double oftener = pilot.time_step > 0 ? forecast.time_step / pilot.time_step *
                                                   (pilot.grain_diameter / forecast.grain_diameter)
                                             : 1;
  const double near_tools = near_tools_over_pilot(scene, pilot);
  double sum = 0;
  for (auto& part : forecast.phases) {
    const double spheres = part.phase.share * static_cast<double>(forecast.spheres);
    const double searches = oftener * (part.phase.kind == PhaseKind::fall ? speed_in_fall : 1);
    part.wall_seconds =
        part.sphere_steps * pilot.seconds_per_sphere_step(part.phase.kind, spheres, searches, near_tools);
    sum += part.wall_seconds;
  }
  if (sum > 0) forecast.wall_seconds = sum;
  return forecast;
}

}  // namespace diefill::process::plan
